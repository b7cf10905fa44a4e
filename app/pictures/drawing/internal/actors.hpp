#pragma once

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkSmartPointer.h>

#include "app/pictures/picture.hpp"

namespace isopatch::app {

vtkSmartPointer<vtkActor> surface_actor(const Surface& surface, const std::vector<Colour>& palette);

/// @param shift  moves the lines toward the eye, so that the surface they lie on does not hide them
vtkSmartPointer<vtkActor> lines_actor(const Lines& lines, double width, const Colour& colour,
                                      const Eigen::Vector3d& shift);

/// @param scale  drawn pixels per pixel of the picture
vtkSmartPointer<vtkActor2D> polygons_actor(const std::vector<PicturePolygon>& polygons, double scale);
vtkSmartPointer<vtkActor2D> text_actor(const PictureText& text, double scale);

}  // namespace isopatch::app
