#pragma once

#include <string>
#include <vector>

#include "app/problem/selection.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::app {

/// The edges of some faces that fulfil conditions at every one of 17 points; normals are not asked for.
///
/// An edge that several of the faces have comes once for each of their patches, as they name it.
///
/// @param model  in m
/// @param place  of the conditions in the study file
/// @throws Error invalid_argument  no edge fulfils them: names those that come nearest
std::vector<iga::SupportedEdge> select_edges(const geometry::MultiPatch& model,
                                             const std::vector<geometry::PatchFace>& faces,
                                             const FaceConditions& conditions, const Place& place);

/// "0:east+back": the two sides of the patch that meet in the edge, in the input's naming.
std::string label(const geometry::MultiPatch& model, const iga::SupportedEdge& held);

}  // namespace isopatch::app
