#!/usr/bin/env bash
# OpenCASCADE's removal of features leaves a slot in place that opens in two extruded splines.
#
# A block of 50 x 40 x 60 with a slot of 10 x 10 right through it. Removing the four faces of the slot by
# BRepAlgoAPI_Defeaturing gives the block again where the walls that the slot opens in are planes. Where they are splines,
# bulging by 4 and extruded, which need no extension at all since the openings lie inside of them, the slot is still there:
# IsDone() says true, HasErrors() false, only HasWarnings() tells. So look at the warnings, or take inner outlines off the
# faces oneself.
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

cat >slot.cpp <<'END'
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Defeaturing.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <cmath>
#include <cstdio>
#include <gp_Pln.hxx>

// From (x, 0, 0) to (x, 0, 60), bulging by `bulge` to the side.
TopoDS_Edge wall(double x, double bulge) {
  constexpr int count = 7;
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
  for (int i = 0; i < count; ++i) {
    const double share = double(i) / (count - 1);
    points->SetValue(i + 1, gp_Pnt(x + bulge * std::sin(M_PI * share), 0, 60 * share));
  }
  GeomAPI_Interpolate curve(points, false, 1e-9);
  curve.Perform();
  return BRepBuilderAPI_MakeEdge(curve.Curve());
}

TopoDS_Edge line(double x0, double z0, double x1, double z1) {
  return BRepBuilderAPI_MakeEdge(gp_Pnt(x0, 0, z0), gp_Pnt(x1, 0, z1));
}

double volume(const TopoDS_Shape& shape) {
  GProp_GProps found;
  BRepGProp::VolumeProperties(shape, found, 1e-6);
  return found.Mass();
}

void defeature(const char* what, double bulge) {
  BRepBuilderAPI_MakeWire outline;
  outline.Add(line(0, 0, 50, 0));
  outline.Add(bulge == 0 ? line(50, 0, 50, 60) : wall(50, bulge));
  outline.Add(line(50, 60, 0, 60));
  outline.Add(bulge == 0 ? line(0, 60, 0, 0) : wall(0, -bulge));
  const TopoDS_Shape body = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(gp_Pln(gp::ZOX()), outline.Wire()), gp_Vec(0, 40, 0));
  const TopoDS_Shape tool = BRepPrimAPI_MakeBox(gp_Pnt(-20, 15, 25), gp_Pnt(70, 25, 35));
  const TopoDS_Shape slotted = BRepAlgoAPI_Cut(body, tool);
  TopTools_ListOfShape faces;
  for (TopExp_Explorer all(slotted, TopAbs_FACE); all.More(); all.Next()) {
    Bnd_Box box;
    BRepBndLib::AddOptimal(all.Current(), box, false);
    double x0, y0, z0, x1, y1, z1;
    box.Get(x0, y0, z0, x1, y1, z1);
    if (y0 > 14.9 && y1 < 25.1 && z0 > 24.9 && z1 < 35.1) faces.Append(all.Current());
  }
  BRepAlgoAPI_Defeaturing whole;
  whole.SetShape(slotted);
  whole.AddFacesToRemove(faces);
  whole.Build();
  std::printf("%s: valid %s, %d faces, ", what, BRepCheck_Analyzer(slotted).IsValid() ? "yes" : "no", faces.Extent());
  std::printf("done %s, errors %s, warnings %s, ", whole.IsDone() ? "yes" : "no", whole.HasErrors() ? "yes" : "no",
              whole.HasWarnings() ? "yes" : "no");
  std::printf("%.4f times the volume of the block\n", std::abs(volume(whole.Shape()) / volume(body)));
}

int main() {
  defeature("flat walls", 0);
  defeature("splines", 4);
}
END
g++ -w -O1 -Iusr/include/opencascade slot.cpp -o slot -L"$libraries" -Wl,-rpath-link,"$libraries" \
  -lTKBO -lTKPrim -lTKGeomAlgo -lTKTopAlgo -lTKBRep -lTKG3d -lTKGeomBase -lTKMath -lTKernel
export LD_LIBRARY_PATH=$folder/$libraries
seen=$(./slot)
echo "libocct $version, the four faces of a slot removed:"
echo "$seen"
[[ $seen == "flat walls: valid yes, 4 faces, done yes, errors no, warnings no, 1.0000 times the volume of the block
splines: valid yes, 4 faces, done yes, errors no, warnings yes, 0.9562 times the volume of the block" ]]
