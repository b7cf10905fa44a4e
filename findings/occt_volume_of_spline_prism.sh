#!/usr/bin/env bash
# OpenCASCADE's volume of a prism over a closed spline is wrong by any factor, while it reports an error of 1e-16.
#
# A wing section as a closed cubic spline through 24 points (GeomAPI_Interpolate, 25 knots), made a face and a prism. The
# area that the spline encloses is summed from 400,000 chords. BRepGProp::VolumeProperties with an accuracy of 1e-7 returns
# an error of 1e-16 and 2.4 times the volume, with 1e-9 it returns 0.7 times the volume and again 1e-16; without an accuracy
# it is a fifth too small. So the returned error says nothing there: integrate from knot to knot, or check against triangles.
#
# Installs libocct 7.6.3+dfsg1-7 from Debian into a temporary folder; needs Debian 12, apt-get, g++ and the libraries
# that libocct itself needs (libtbb12). Exits 0 if the behaviour is as described, 1 if it has changed.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
version=7.6.3+dfsg1-7
for part in modeling-algorithms modeling-data foundation visualization; do
  apt-get -q -o APT::Sandbox::User=root download "libocct-$part-7.6=$version" "libocct-$part-dev=$version" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$(dirname -- "$(find usr/lib -name 'libTKMath.so.7.6*' | head -1)")

cat >volume.cpp <<'END'
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <cmath>
#include <cstdio>
#include <gp_Pln.hxx>

constexpr double height = 10;

// Half the thickness of a wing section at a share of its length.
double thickness(double x) { return 0.6 * (0.2969 * std::sqrt(x) - x * (0.126 + x * (0.3516 - x * (0.2843 - 0.1036 * x)))); }

Handle(Geom_BSplineCurve) section() {
  constexpr int side = 12;
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 2 * side);
  for (int i = 0; i < 2 * side; ++i) {
    const double x = 0.5 * (1 + std::cos(M_PI * i / side));
    const double y = i == 0 ? 0 : i < side ? thickness(x) : -thickness(x);
    points->SetValue(i + 1, gp_Pnt(100 * x, 100 * y, 0));
  }
  GeomAPI_Interpolate curve(points, true, 1e-9);
  curve.Perform();
  return curve.Curve();
}

double enclosed(const Handle(Geom_BSplineCurve)& curve) {
  constexpr int chords = 400000;
  const double first = curve->FirstParameter(), way = curve->LastParameter() - first;
  double sum = 0;
  for (int i = 0; i < chords; ++i) {
    const gp_Pnt a = curve->Value(first + way * i / chords), b = curve->Value(first + way * (i + 1) / chords);
    sum += (a.X() * b.Y() - b.X() * a.Y()) / 2;
  }
  return sum;
}

int main() {
  const Handle(Geom_BSplineCurve) curve = section();
  const TopoDS_Face face =
      BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve)), true);
  const TopoDS_Shape prism = BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, height));
  const double right = height * enclosed(curve);
  for (const double accuracy : {1e-7, 1e-9}) {
    GProp_GProps found;
    const double error = BRepGProp::VolumeProperties(prism, found, accuracy, true);
    std::printf("accuracy %g: %.3f times the volume, error said to be %s\n", accuracy, found.Mass() / right,
                error < 1e-15 ? "below 1e-15" : "larger");
  }
  GProp_GProps found;
  BRepGProp::VolumeProperties(prism, found);
  std::printf("no accuracy: %.3f times the volume\n", found.Mass() / right);
}
END
g++ -w -O1 -Iusr/include/opencascade volume.cpp -o volume -L"$libraries" -Wl,-rpath-link,"$libraries" \
  -lTKPrim -lTKGeomAlgo -lTKTopAlgo -lTKBRep -lTKG3d -lTKGeomBase -lTKMath -lTKernel
export LD_LIBRARY_PATH=$folder/$libraries
seen=$(./volume)
echo "libocct $version, a prism over a closed spline:"
echo "$seen"
[[ $seen == "accuracy 1e-07: 2.449 times the volume, error said to be below 1e-15
accuracy 1e-09: 0.687 times the volume, error said to be below 1e-15
no accuracy: 0.815 times the volume" ]]
