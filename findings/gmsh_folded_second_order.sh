#!/usr/bin/env bash
# gmsh writes second-order meshes with folded elements, and is done: a warning, exit code 0.
#
# A tube of radii 10 and 8, meshed with elements of 8 at order 2: the middles of edges move onto the round faces through the
# wall, which leaves 21 tetrahedra with a negative Jacobian. gmsh 4.8.4 warns of a "worst distortion", writes the mesh, says
# "0 errors" and exits with 0; a solver refuses it (CalculiX: exit code 201). Mesh.HighOrderOptimize, off unless asked for,
# unfolds them.
#
# Installs gmsh and libgmsh 4.8.4 from Debian into a temporary folder; needs Debian 12, apt-get and the libraries that gmsh
# itself needs. Exits 0 if the behaviour is as described, 1 if it has changed.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
version=4.8.4+ds2-3
apt-get -q -o APT::Sandbox::User=root download "libgmsh4.8=$version" "gmsh=$version" >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
LD_LIBRARY_PATH=$(dirname -- "$(find "$folder/usr/lib" -name 'libgmsh.so.4.8' | head -1)")
export LD_LIBRARY_PATH

cat >tube.geo <<'END'
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 20, 10};
Cylinder(2) = {0, 0, 0, 0, 0, 20, 8};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
END

seen=$(for optimize in 0 1; do
  code=0
  usr/bin/gmsh -3 -order 2 -clmin 8 -clmax 8 -setnumber Mesh.HighOrderOptimize "$optimize" -v 4 -o tube.msh tube.geo \
    >said.txt 2>&1 || code=$?
  folded=$(sed -n 's/.*Volume mesh:.* \([0-9]*\) elements with jac. < 0.*/\1/p' said.txt)
  echo "Mesh.HighOrderOptimize = $optimize: $folded folded tetrahedra, $(grep -c 'Optimization succeeded' said.txt || true)" \
    "time unfolded, exit code $code"
done)
echo "gmsh $version, a tube of radii 10 and 8, elements of 8, order 2:"
echo "$seen"
[[ $seen == "Mesh.HighOrderOptimize = 0: 21 folded tetrahedra, 0 time unfolded, exit code 0
Mesh.HighOrderOptimize = 1: 21 folded tetrahedra, 1 time unfolded, exit code 0" ]]
