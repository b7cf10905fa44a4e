#!/usr/bin/env bash
# OpenCASCADE's wire builder forgets edges that it could not add, and says in the end that all is well.
#
# Four edges around a square of 10, one after the other; the second begins 1e-5 beside the end of the first, farther than
# the tolerance of both (1e-7). In OpenCASCADE 7.6.3 (Debian 12) BRepBuilderAPI_MakeWire has Error() == DisconnectedWire
# after it and after the third, which would have followed it; the fourth, which ends where the first begins, sets that back: IsDone() is
# true, and the wire has two edges. Who asks at the end gets an open wire without a word; one has to ask after each edge.
#
# Installs libocct 7.6.3+dfsg1-7 from Debian into a temporary folder; needs Debian 12, apt-get, g++ and the libraries
# that libocct itself needs (libtbb12). Exits 0 if the behaviour is as described, 1 if it has changed.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
version=7.6.3+dfsg1-7
for part in modeling-algorithms modeling-data foundation; do
  apt-get -q -o APT::Sandbox::User=root download "libocct-$part-7.6=$version" "libocct-$part-dev=$version" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$(dirname -- "$(find usr/lib -name 'libTKTopAlgo.so.7.6*' | head -1)")

cat >square.cpp <<'CPP'
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <cstdio>
#include <gp_Pnt.hxx>

// Which of the four edges is an error when it is added, whether the wire is done, and how many edges it has.
void tell(double gap) {
  const gp_Pnt corners[4] = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  BRepBuilderAPI_MakeWire wire;
  std::printf("%g:", gap);
  for (int i = 0; i < 4; ++i) {
    gp_Pnt from = corners[i];
    if (i == 1) from.SetX(from.X() + gap);
    wire.Add(BRepBuilderAPI_MakeEdge(from, corners[(i + 1) % 4]).Edge());
    std::printf(" %s", wire.Error() == BRepBuilderAPI_WireDone ? "ok" : "error");
  }
  int edges = 0;
  for (TopExp_Explorer edge(wire.Wire(), TopAbs_EDGE); edge.More(); edge.Next()) ++edges;
  std::printf(", done %d, edges %d\n", static_cast<int>(wire.IsDone()), edges);
}

int main() {
  tell(0);
  tell(1e-5);
}
CPP
g++ -w -O1 -Iusr/include/opencascade square.cpp -o square -L"$libraries" -Wl,-rpath-link,"$libraries" \
  -lTKTopAlgo -lTKBRep -lTKGeomBase -lTKG3d -lTKG2d -lTKMath -lTKernel
export LD_LIBRARY_PATH=$folder/$libraries
result=$(./square)
echo "libocct $version: gap, each edge as it is added, the wire:"
echo "$result"
[[ $result == $'0: ok ok ok ok, done 1, edges 4\n1e-05: ok error error ok, done 1, edges 2' ]]
