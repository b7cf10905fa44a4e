#!/usr/bin/env bash
# A closed B-spline of gmsh's OpenCASCADE kernel has a jump of curvature where it closes.
#
# occ.addBSpline with the first point again at the end makes a "periodic curve" (gmsh's documentation). Of twelve points and
# degree 3 one expects the uniform periodic spline: twelve spans, C2 everywhere. gmsh 4.8.4 doubles one knot: eleven spans,
# parameters 0 to 11, and where the curve closes only the first derivatives agree. Area and length differ from the uniform
# spline's by some tenths of a percent. Who wants the uniform one gives knots and multiplicities.
#
# Installs python3-gmsh and libgmsh 4.8.4 from Debian into a temporary folder; needs Debian 12, apt-get, python3 and the
# libraries that gmsh itself needs. Exits 0 if the behaviour is as described, 1 if it has changed.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
version=4.8.4+ds2-3
apt-get -q -o APT::Sandbox::User=root download "libgmsh4.8=$version" "python3-gmsh=$version" >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
LD_LIBRARY_PATH=$(dirname -- "$(find "$folder/usr/lib" -name 'libgmsh.so.4.8' | head -1)")
export LD_LIBRARY_PATH PYTHONPATH=$folder/usr/lib/python3/dist-packages

seen=$(/usr/bin/python3 - <<'END'
import math
import gmsh

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
places = [(math.cos(math.pi * i / 6) * (1 + 0.3 * (i % 3)), math.sin(math.pi * i / 6), 0) for i in range(12)]
points = [gmsh.model.occ.addPoint(*place) for place in places]
curve = gmsh.model.occ.addBSpline(points + points[:1])
gmsh.model.occ.synchronize()
(first,), (last,) = gmsh.model.getParametrizationBounds(1, curve)
for name, derivative in (("first", gmsh.model.getDerivative), ("second", gmsh.model.getSecondDerivative)):
    jump = max(abs(a - b) for a, b in zip(derivative(1, curve, [first]), derivative(1, curve, [last])))
    print(f"jump of the {name} derivative where it closes: {jump:.4f}")
print(f"parameters {first:g} to {last:g}")
END
)
echo "gmsh $version, a closed cubic B-spline of twelve points:"
echo "$seen"
[[ $seen == "jump of the first derivative where it closes: 0.0000
jump of the second derivative where it closes: 2.8875
parameters 0 to 11" ]]
