#!/usr/bin/env bash
# OpenCASCADE's IGES reader passes over the model space scale.
#
# The 13th parameter of an IGES file's global section (IGES 5.3, 2.2.4.3.13) is the ratio of lengths in the file to real
# ones: with 0.5 a box drawn 10 mm long is 20 mm long. OpenCASCADE 7.6.3 (Debian 12) reads 10 mm, whatever stands there, and
# reports success. The file is one of its own writer's, in which the parameter is always 1., with that one parameter changed.
#
# Installs libocct 7.6.3+dfsg1-7 from Debian into a temporary folder; needs Debian 12, apt-get, g++ and the libraries that
# libocct itself needs (libtbb12). Exits 0 if the behaviour is as described, 1 if it has changed.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
version=7.6.3+dfsg1-7
for part in data-exchange modeling-algorithms modeling-data foundation ocaf visualization; do
  apt-get -q -o APT::Sandbox::User=root download "libocct-$part-7.6=$version" "libocct-$part-dev=$version" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$(dirname -- "$(find usr/lib -name 'libTKIGES.so.7.6*' | head -1)")

cat >box.cpp <<'END'
#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <cstdio>
#include <string>

int main(int, char** arguments) {
  IGESControl_Controller::Init();
  if (std::string(arguments[1]) == "write") {
    IGESControl_Writer writer("MM", 1);
    writer.AddShape(BRepPrimAPI_MakeBox(10., 10., 10.).Shape());
    writer.ComputeModel();
    return writer.Write(arguments[2]) ? 0 : 1;
  }
  IGESControl_Reader reader;
  if (reader.ReadFile(arguments[2]) != IFSelect_RetDone) return 1;
  reader.TransferRoots();
  Bnd_Box box;
  BRepBndLib::AddOptimal(reader.OneShape(), box, false, false);
  std::printf("%.6g\n", box.CornerMax().X() - box.CornerMin().X());
}
END
g++ -w -O1 -Iusr/include/opencascade box.cpp -o box -L"$libraries" -Wl,-rpath-link,"$libraries" \
  -lTKIGES -lTKXSBase -lTKPrim -lTKTopAlgo -lTKBRep -lTKG3d -lTKMath -lTKernel
export LD_LIBRARY_PATH=$folder/$libraries
./box write one.igs >/dev/null
sed 's/,1\.,2,2HMM/,.5,2,2HMM/' one.igs >half.igs
cmp -s one.igs half.igs && { echo "the parameter is not where it was"; exit 1; }
one=$(./box read one.igs | tail -1)
half=$(./box read half.igs | tail -1)
echo "libocct $version: a box of 10 mm drawn at scale 1 is $one mm long, at scale 0.5 $half mm; right are 10 and 20"
[[ $one == 10 && $half == 10 ]]
