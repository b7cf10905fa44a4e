#!/usr/bin/env bash
# OpenCASCADE's STEP reader does not follow a unit of length that is defined by another conversion unit.
#
# ISO 10303-41 lets a CONVERSION_BASED_UNIT be so many of any other unit: here an inch is a twelfth of a foot, and a foot
# is 0.3048 m. A vertex at (10, 0, 0) inch lies at 254 mm. OpenCASCADE 7.6.3 (Debian 12) puts it at 10 mm: it takes the
# number of the first conversion if that refers to an SI unit, and nothing otherwise. Reading and transfer report success.
# The same file with the inch as 25.4 mm comes out right, so only the chain is the matter.
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

# $1: how long an inch is.
write_step() {
  cat <<END
ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('automotive design');
#2=PRODUCT_CONTEXT('',#1,'mechanical');
#3=PRODUCT('rod','rod','',(#2));
#4=PRODUCT_DEFINITION_FORMATION('','',#3);
#5=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#6=PRODUCT_DEFINITION('design','',#4,#5);
#7=PRODUCT_DEFINITION_SHAPE('','',#6);
#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);
#9=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#10),#30);
#10=GEOMETRIC_CURVE_SET('',(#11));
#11=CARTESIAN_POINT('',(10.,0.,0.));
#20=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));
#21=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);
#22=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.3048),#20);
#23=(CONVERSION_BASED_UNIT('FOOT',#22)LENGTH_UNIT()NAMED_UNIT(#21));
#24=$1;
#25=(CONVERSION_BASED_UNIT('INCH',#24)LENGTH_UNIT()NAMED_UNIT(#21));
#26=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#27=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#30=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#25,#26,#27))REPRESENTATION_CONTEXT('',''));
ENDSEC;
END-ISO-10303-21;
END
}
write_step 'LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.0254),#20)' >by_metre.step
write_step 'LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.08333333333333333),#23)' >by_foot.step

cat >read.cpp <<'END'
#include <BRep_Tool.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cstdio>

int main(int, char** arguments) {
  STEPControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (reader.ReadFile(arguments[1]) != IFSelect_RetDone) return 1;
  reader.TransferRoots();
  const TopExp_Explorer vertex(reader.OneShape(), TopAbs_VERTEX);
  if (!vertex.More()) return 1;
  std::printf("%.6g\n", BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())).X());
}
END
g++ -w -O1 -Iusr/include/opencascade read.cpp -o read -L"$libraries" -Wl,-rpath-link,"$libraries" \
  -lTKSTEP -lTKXSBase -lTKBRep -lTKG3d -lTKTopAlgo -lTKMath -lTKernel
export LD_LIBRARY_PATH=$folder/$libraries
by_metre=$(./read by_metre.step | tail -1)
by_foot=$(./read by_foot.step | tail -1)
echo "libocct $version: 10 inch are $by_metre mm with the inch in metres, $by_foot mm with the inch in feet; both are 254 mm"
[[ $by_metre == 254 && $by_foot != 254 ]]
