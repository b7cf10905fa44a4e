#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "geometry/polyhedron.hpp"

namespace isopatch::geometry::test {

/// Writes STEP files entity by entity, as programs do and as they should not.
class StepAssembly {
 public:
  /// @param unit  an entity of a unit of length, "$" for a context without one
  explicit StepAssembly(const std::string& unit = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");

  /// Adds an entity and returns its number.
  int add(const std::string& entity);
  /// A solid or a shell of planar faces.
  struct Body {
    int item = 0;  ///< MANIFOLD_SOLID_BREP or SHELL_BASED_SURFACE_MODEL
    int shell = 0;
    std::vector<int> faces;
  };
  /// @param kind  "solid", or "shell" for a surface model
  Body body(const Polyhedron& polyhedron, const std::string& name = "", const std::string& kind = "solid");
  /// Both in one closed shell.
  Body body(const std::vector<Polyhedron>& pieces);
  /// A product with these items as its shape.
  struct Product {
    int definition = 0, shape = 0;
  };
  Product product(const std::string& name, const std::vector<int>& items);
  /// Places a part in an assembly, moved by (x, y, z).
  void place(const Product& assembly, const Product& part, const std::array<double, 3>& by,
             const std::string& name = "");
  /// Gives an item a colour.
  void colour(int item, const std::array<double, 3>& red_green_blue);
  std::vector<int> faces(const Polyhedron& polyhedron);
  std::string text() const;

 private:
  int placement(const std::array<double, 3>& at);

  std::string data_;
  int last_ = 0;
  int context_ = 0, application_ = 0, product_context_ = 0, definition_context_ = 0;
  std::vector<int> styled_;
};

/// "#3,#4,#5".
std::string references(const std::vector<int>& ids);

}  // namespace isopatch::geometry::test
