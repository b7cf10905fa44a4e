#pragma once

#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <optional>
#include <string>
#include <vector>

namespace isopatch::parts {

/// The name of the face that a point lies on, mm.
struct FaceName {
  std::string name;
  gp_Pnt on;
};

/// Another solid of an assembly.
struct Body {
  std::string name;
  TopoDS_Shape solid;
  std::vector<FaceName> faces;
};

/// A solid as it is drawn, mm.
struct Part {
  TopoDS_Shape solid;
  std::vector<FaceName> faces;    ///< the first one is held and the second one loaded in a first study
  std::optional<double> volume;   ///< mm^3, where it has a closed form
  std::string name = {};          ///< of the solid; the drawing's where empty
  std::vector<Body> others = {};  ///< that touch it: an assembly
};

}  // namespace isopatch::parts
