#!/usr/bin/env bash
# VTK's clip filters find the points of a cut in single precision, its contour filter in double, so the two do not meet.
#
# A solid is cut open by clipping its surface at a value and closing it with the contour at the same value. With points and
# values in double precision one expects the same places from both. vtkClipPolyData and vtkClipDataSet of VTK 9.1 give
# points of double type whose numbers are rounded like single ones (0.1003 becomes 0.10029999790); vtkContourFilter and
# vtkTableBasedClipDataSet give 0.1003. vtkStructuredGridGeometryFilter makes single-precision points of double ones, where
# vtkDataSetSurfaceFilter keeps them. Edges of such a cut stay open unless they are joined with a tolerance of 1e-7 of the size.
#
# Installs python3-vtk9 and libvtk9.1 from Debian into a temporary folder; needs Debian 12, apt-get, python3 and the libraries
# that VTK itself needs. Exits 0 if the behaviour is as described, 1 if it has changed.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
apt-get -q -o APT::Sandbox::User=root download "libvtk9.1=$version" "python3-vtk9=$version" >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
LD_LIBRARY_PATH=$(dirname -- "$(find "$folder/usr/lib" -name 'libvtkCommonCore-9.1.so.*' | head -1)")
export LD_LIBRARY_PATH PYTHONPATH=$folder/usr/lib/python3/dist-packages

seen=$(/usr/bin/python3 - <<'END'
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkContourFilter
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet, vtkTableBasedClipDataSet
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter, vtkStructuredGridGeometryFilter

points, height = vtkPoints(), vtkDoubleArray()
points.SetDataTypeToDouble()
for n in range(8):
    points.InsertNextPoint(0.1 + 1e-3 * (n & 1), 1e-3 * (n >> 1 & 1), 1e-3 * (n >> 2))
    height.InsertNextValue(points.GetPoint(n)[0])
grid = vtkStructuredGrid()
grid.SetDimensions(2, 2, 2)
grid.SetPoints(points)
grid.GetPointData().SetScalars(height)


def places(result):
    return [result.GetPoint(n)[0] for n in range(result.GetNumberOfPoints())]


def kind(result):
    return result.GetPoints().GetData().GetClassName()


surface = vtkDataSetSurfaceFilter()
for faces in (surface, vtkStructuredGridGeometryFilter()):
    faces.SetInputData(grid)
    faces.Update()
    print(f"{faces.GetClassName()}: {kind(faces.GetOutput())}, {max(places(faces.GetOutput())):.11f}")
for cut in (vtkClipPolyData(), vtkClipDataSet(), vtkTableBasedClipDataSet(), vtkContourFilter()):
    cut.SetInputConnection(surface.GetOutputPort())
    cut.SetValue(0, 0.1003) if cut.GetClassName() == "vtkContourFilter" else cut.SetValue(0.1003)
    cut.Update()
    there = min(places(cut.GetOutput()), key=lambda x: abs(x - 0.1003))
    print(f"{cut.GetClassName()}: {kind(cut.GetOutput())}, {there:.11f}")
END
)
echo "VTK $version, a cell from x = 0.1 to 0.101 cut at 0.1003:"
echo "$seen"
[[ $seen == "vtkDataSetSurfaceFilter: vtkDoubleArray, 0.10100000000
vtkStructuredGridGeometryFilter: vtkFloatArray, 0.10100000352
vtkClipPolyData: vtkDoubleArray, 0.10029999790
vtkClipDataSet: vtkDoubleArray, 0.10029999790
vtkTableBasedClipDataSet: vtkDoubleArray, 0.10030000000
vtkContourFilter: vtkDoubleArray, 0.10030000000" ]]
