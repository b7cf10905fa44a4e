#include "geometry/brep/opencascade/internal/transfer_remarks.hpp"

#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <algorithm>
#include <cstdlib>
#include <map>

#include <fmt/format.h>

namespace isopatch::geometry {
namespace {

// Geometry and topology by the names of the library's classes; the rest (views, layers, tolerances) bounds
// nothing.
bool is_of_shapes(const Standard_Transient& entity) {
  const std::string type = entity.DynamicType()->Name();
  if (type.find("Representation") != type.npos) return false;
  for (const char* room : {"StepGeom_", "StepShape_", "IGESGeom_", "IGESSolid_", "IGESBasic_"})
    if (type.rfind(room, 0) == 0) return true;
  return false;
}

void add_fails(const Interface_Check& check, std::string& text) {
  for (int i = 1; i <= check.NbFails(); ++i) {
    const std::string fail = check.CFail(i, true);
    text += (text.empty() ? "" : "; ") + fail.substr(std::min(fail.size(), fail.find_first_not_of(" ")));
  }
}

}  // namespace

std::int64_t entity_number(const Interface_InterfaceModel& model, const Handle(Standard_Transient) & entity) {
  const Handle(TCollection_HAsciiString) label = model.StringLabel(entity);
  if (label.IsNull()) return 0;
  const std::string text = label->ToCString();
  const std::size_t digit = text.find_first_of("0123456789");
  return digit == text.npos ? 0 : std::strtoll(text.c_str() + digit, nullptr, 10);
}

void add_remarks(const XSControl_WorkSession& session, bool (*is_body_or_face)(const Standard_Transient&),
                 FileShapes& result) {
  const Handle(Interface_InterfaceModel) model = session.Model();
  const Handle(Transfer_TransientProcess) process = session.TransferReader()->TransientProcess();
  if (model.IsNull() || process.IsNull()) return;
  std::map<std::int64_t, std::string> fails;
  Interface_CheckIterator checks = process->CheckList(true);
  for (checks.Start(); checks.More(); checks.Next()) {
    const Handle(Standard_Transient) entity = checks.Value()->Entity();
    if (entity.IsNull() || !is_of_shapes(*entity)) continue;
    std::string text;
    add_fails(*checks.Value(), text);
    if (!text.empty()) fails[entity_number(*model, entity)] = text;
  }
  const Handle(Interface_Check) whole = model->GlobalCheck(true);
  for (int i = 1; i <= whole->NbFails(); ++i)
    if (const std::string fail = whole->CFail(i, true); fail.find("Unresolved Reference") == fail.npos)
      result.lost.push_back({0, fail});
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    const std::int64_t number = entity_number(*model, entity);
    if (is_of_shapes(*entity)) {
      std::string text;
      add_fails(*model->Check(i, true), text);
      // A value that was passed over leaves an entity that looks whole.
      if (text.find("not a ") != text.npos)
        result.lost.push_back({number, text});
      else if (!text.empty())
        fails.emplace(number, text);
    }
    if (!is_body_or_face(*entity)) continue;
    const TopoDS_Shape made = TransferBRep::ShapeResult(process, entity);
    if (made.IsNull() || !TopExp_Explorer(made, TopAbs_FACE).More())
      result.lost.push_back({number, "could not be made"});
  }
  for (const auto& [number, text] : fails) result.remarks.push_back({number, text});
}

}  // namespace isopatch::geometry
