#include "geometry/brep/internal/cad_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/iges_header.hpp"
#include "geometry/brep/internal/sentences.hpp"
#include "geometry/brep/internal/step_text.hpp"
#include "geometry/brep/part21.hpp"
#include "geometry/brep/placeholder_name.hpp"
#include "geometry/brep/step_products.hpp"
#include "geometry/brep/step_units.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;

void add(const std::vector<std::string>& sentences, std::vector<std::string>& result) {
  result.insert(result.end(), sentences.begin(), sentences.end());
}

void require_no_length_unit(const fs::path& path, const ReadBrepOptions& options) {
  if (options.length_unit && *options.length_unit != 1)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: the file states its unit of length; leave length_unit out", path.string()));
}

/// Sentences about STEP entities, with their line and product.
class StepWords {
 public:
  StepWords(const Part21File& file, const StepProducts& products) : file_(file), products_(products) {}

  std::string sentence(const EntityRemark& remark) const {
    const Part21Instance* instance = remark.entity > 0 ? file_.find(remark.entity) : nullptr;
    if (instance == nullptr) return remark.text;
    const std::string product = utf8_name(products_.product_of(instance->id));
    return fmt::format("{}{}: {}", file_.place(*instance),
                       is_placeholder_name(product) ? "" : fmt::format(" of '{}'", product), remark.text);
  }
  std::vector<std::string> sentences(const std::vector<EntityRemark>& remarks) const {
    std::vector<std::string> result;
    for (const EntityRemark& remark : remarks) result.push_back(sentence(remark));
    return result;
  }

 private:
  const Part21File& file_;
  const StepProducts& products_;
};

/// Remarks about entities are one warning; those about shapes are sentences of their own, each said once.
template <class Sentences>
void add_remarks(const std::vector<EntityRemark>& remarks, const Sentences& sentences,
                 std::vector<std::string>& warnings) {
  std::vector<EntityRemark> of_entities;
  std::vector<std::string> others;
  for (const EntityRemark& remark : remarks)
    if (remark.entity > 0)
      of_entities.push_back(remark);
    else if (std::find(others.begin(), others.end(), remark.text) == others.end())
      others.push_back(remark.text);
  if (!of_entities.empty())
    warnings.push_back(fmt::format("the CAD library stumbled: {}", listed(sentences(of_entities))));
  add(others, warnings);
}

/// Bodies and faces that the library lost; those it says nothing about are named by the reasons it gives
/// elsewhere.
std::vector<std::string> losses(const KernelFile& made, const Part21File& file,
                                const StepProducts& products) {
  std::vector<EntityRemark> lost = made.lost;
  for (EntityRemark& remark : lost)
    if (remark.entity > 0 && !products.is_used(remark.entity)) remark.text = "nothing in the file uses it";
  for (const Part21Instance* other : products.other_solids()) {
    const bool triangles = other->type.find("TESSELLATED") != other->type.npos ||
                           other->type.find("TRIANGULATED") != other->type.npos;
    const bool known = std::any_of(lost.begin(), lost.end(),
                                   [&](const EntityRemark& remark) { return remark.entity == other->id; });
    if (!known && (!triangles || made.bodies.empty()))
      lost.push_back({other->id, "solids of this kind are not read"});
  }
  std::vector<std::string> result = StepWords(file, products).sentences(lost);
  if (result.empty() && made.listed < products.placed_bodies())
    result.push_back(fmt::format("the file lists {} bodies, of which the CAD library delivers {}",
                                 products.placed_bodies(), made.listed));
  return result;
}

CadFile read_step_file(const fs::path& path, const ReadBrepOptions& options) {
  const std::string bytes = read_file(path);
  std::string_view text = bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // editors of Windows put it there
  options.progress("checking the text", 0);
  const Part21File file(text, path.string());
  CadFile result;
  result.missing = file.unknown_references();
  require_coordinates(file);
  const StepUnits units = step_units(file);
  if (units.stated) require_no_length_unit(path, options);
  for (const std::string& warning : units.warnings)
    if (units.stated || !options.length_unit) result.warnings.push_back(warning);
  result.unit = units.stated          ? units.name
                : options.length_unit ? "as given"
                                      : "mm, since the file states none";
  const StepProducts products(file);
  const std::string prepared = kernel_text(file, units);
  options.progress("reading", 0.1);
  KernelSource source{path, BrepFormat::step, prepared, 1e-3};
  if (!units.stated) source.metres = options.length_unit.value_or(1e-3);
  KernelFile made = brep_module().read(source, options.sew);
  const StepWords words(file, products);
  add(losses(made, file, products), result.missing);
  add_remarks(
      made.remarks, [&](const auto& remarks) { return words.sentences(remarks); }, result.warnings);
  result.bodies = std::move(made.bodies);
  return result;
}

std::vector<std::string> iges_sentences(const std::vector<EntityRemark>& remarks) {
  std::vector<std::string> result;
  for (const EntityRemark& remark : remarks)
    result.push_back(remark.entity > 0 ? fmt::format("entity D{}: {}", remark.entity, remark.text)
                                       : remark.text);
  return result;
}

void take(KernelFile made, CadFile& result) {
  add(iges_sentences(made.lost), result.missing);
  add_remarks(made.remarks, iges_sentences, result.warnings);
  result.bodies = std::move(made.bodies);
}

CadFile read_iges_file(const fs::path& path, const ReadBrepOptions& options) {
  CadFile result;
  const IgesHeader header = iges_header(read_file(path), path.string());
  if (header.has_unit) require_no_length_unit(path, options);
  if (header.has_unit || !options.length_unit) result.warnings = header.warnings;
  result.unit = header.has_unit       ? header.unit
                : options.length_unit ? "as given"
                                      : "mm, since the file states none";
  options.progress("reading", 0.1);
  const double metres = header.has_unit ? 1e-3 : options.length_unit.value_or(1e-3);
  take(brep_module().read({path, BrepFormat::iges, {}, metres / header.scale}, options.sew), result);
  return result;
}

/// The library reads "nan" and "inf" as numbers.
void require_finite_numbers(std::string_view text, const std::string& source) {
  constexpr std::string_view space = " \t\r\n";
  int line = 1;
  for (std::size_t from = 0, end = 0; from < text.size(); from = end + 1) {
    end = std::min(text.find_first_of(space, from), text.size());
    std::string word(text.substr(from, end - from));
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::string_view plain = std::string_view(word).substr(word.find_first_not_of("+-") == 1 ? 1 : 0);
    if (plain == "nan" || plain == "inf" || plain == "infinity")
      throw Error(ErrorCode::bad_format, fmt::format("{}:{}: '{}' is no number", source, line, word));
    if (end < text.size() && text[end] == '\n') ++line;
  }
}

CadFile read_native_file(const fs::path& path, const ReadBrepOptions& options) {
  CadFile result;
  require_finite_numbers(read_file(path), path.string());
  options.progress("reading", 0.1);
  result.unit = options.length_unit ? "as given" : "m, since the format states none";
  if (!options.length_unit)
    result.warnings.emplace_back(
        "OpenCASCADE files do not state their unit of length; m is taken; give length_unit if it is another");
  take(brep_module().read({path, BrepFormat::brep, {}, options.length_unit.value_or(1)}, options.sew),
       result);
  return result;
}

}  // namespace

CadFile read_cad_file(const fs::path& path, BrepFormat format, const ReadBrepOptions& options) {
  CadFile result = format == BrepFormat::step   ? read_step_file(path, options)
                   : format == BrepFormat::iges ? read_iges_file(path, options)
                                                : read_native_file(path, options);
  if (result.bodies.empty())
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: there is no solid in the file, nor a face of one{}", path.string(),
                            result.missing.empty() ? "" : fmt::format(": {}", listed(result.missing))));
  return result;
}

}  // namespace isopatch::geometry
