#!/usr/bin/env bash
# A face turned from an ellipse that ends on the axis loses its seam in OpenCASCADE's STEP reader, and the solid its volume.
#
# Half an ellipsoid of revolution: a quarter of an ellipse (radius 10, height 5) and two straight lines, turned once
# about z; 1047.2 mm^3 (2 pi / 3 x 100 x 5). Its dome uses four edges: a circle, a seam twice, a point on the axis.
# OpenCASCADE 7.6.3 (Debian 12) writes it to STEP and reads it again, both with success: the dome uses the circle alone
# then, and the volume of the solid is 0.
#
# Installs libocct 7.6.3+dfsg1-7 from Debian into a temporary folder; needs Debian 12, apt-get, g++ and the libraries
# that libocct itself needs (libtbb12). Exits 0 if the behaviour is as described, 1 if it has changed.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
version=7.6.3+dfsg1-7
for part in data-exchange modeling-algorithms modeling-data foundation ocaf visualization; do
  apt-get -q -o APT::Sandbox::User=root download "libocct-$part-7.6=$version" "libocct-$part-dev=$version" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$(dirname -- "$(find usr/lib -name 'libTKSTEP.so.7.6*' | head -1)")

cat >dome.cpp <<'CPP'
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cstdio>
#include <gp_Elips.hxx>

// Uses of edges by the face that is not plane, and the volume.
void tell(const char* when, const TopoDS_Shape& solid) {
  int uses = 0;
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    if (GeomAdaptor_Surface(BRep_Tool::Surface(TopoDS::Face(face.Current()))).GetType() == GeomAbs_Plane) continue;
    for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next()) ++uses;
  }
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  std::printf("\n%s %d %.1f\n", when, uses, properties.Mass());
}

int main() {
  const double height = 5;
  const gp_Elips ellipse(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0), gp::DX()), 10, height);
  BRepBuilderAPI_MakeWire outline;
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0)).Edge());
  outline.Add(BRepBuilderAPI_MakeEdge(ellipse, gp_Pnt(10, 0, 0), gp_Pnt(0, 0, height)).Edge());
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, height), gp_Pnt(0, 0, 0)).Edge());
  const TopoDS_Shape solid =
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp::OZ()).Shape();
  tell("made", solid);
  STEPControl_Writer writer;
  writer.Transfer(solid, STEPControl_AsIs);
  writer.Write("dome.step");
  STEPControl_Reader reader;
  if (reader.ReadFile("dome.step") != IFSelect_RetDone) return 1;
  reader.TransferRoots();
  tell("read", reader.OneShape());
}
CPP
g++ -w -O1 -Iusr/include/opencascade dome.cpp -o dome -L"$libraries" -Wl,-rpath-link,"$libraries" \
  -lTKSTEP -lTKXSBase -lTKPrim -lTKTopAlgo -lTKBRep -lTKGeomBase -lTKG3d -lTKG2d -lTKMath -lTKernel
export LD_LIBRARY_PATH=$folder/$libraries
result=$(./dome | grep -E '^(made|read) ')
echo "libocct $version: uses of edges by the dome, and volume:"
echo "$result"
[[ $result == $'made 4 1047.2\nread 1 0.0' ]]
