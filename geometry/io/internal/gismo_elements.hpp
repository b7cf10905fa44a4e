#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/io/internal/xml_text.hpp"
#include "geometry/splines/knot_vector.hpp"

namespace isopatch::geometry {

/// Largest id of an element that is accepted.
constexpr int max_id = 2'000'000'000;

// What all geometries of a G+Smo file are made of. `name` says in messages what is being read.

/// @throws Error bad_format if there is no such child
pugi::xml_node required_child(const XmlText& xml, pugi::xml_node parent, const char* tag,
                              const std::string& name);

/// A `KnotVector` element as it stands there.
struct GivenKnots {
  int degree = 1;
  std::vector<double> knots;
  int line = 0;
};
GivenKnots given_knots(const XmlText& xml, pugi::xml_node node, const std::string& name);

/// The knot vectors of the D factors of a tensor product basis, as they stand there.
template <int D>
std::array<GivenKnots, D> given_knots(const XmlText& xml, pugi::xml_node basis, const std::string& name);

/// Checked. @throws Error bad_format with the line
KnotVector knot_vector(const XmlText& xml, GivenKnots given, const std::string& name);

/// The numbers in an element, (rows, count), the rows running fastest; exactly as many.
Eigen::MatrixXd numbers(const XmlText& xml, pugi::xml_node node, int rows, std::int64_t count,
                        const std::string& what);

}  // namespace isopatch::geometry
