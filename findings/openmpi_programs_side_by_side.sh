#!/usr/bin/env bash
# MPI programs of one process that are started side by side, without mpiexec, can fail in MPI_Init with Open MPI 4.1.4.
#
# Each makes and removes the folder /tmp/ompi.HOST.UID, which is that of all programs of a user: one that ends removes it just
# before another makes its own folder inside, which then cannot be made, and MPI_Init ends that program. Up to some percent of short
# programs, sixteen at a time, fail. Without folders of a session (the parameter orte_create_session_dirs) none does; a program
# alone needs none.
#
# Installs Open MPI 4.1.4-3+b1 from Debian into a temporary folder; needs Debian 12, apt-get, gcc and the libraries that Open MPI
# itself needs (libhwloc15, libevent, libpmix2). Exits 0 if the behaviour is as described, 1 if it has changed.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
version=4.1.4-3+b1
apt-get -q -o APT::Sandbox::User=root download "libopenmpi3=$version" "libopenmpi-dev=$version" "openmpi-bin=$version" openmpi-common=4.1.4-3 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname -- "$(find "$folder/usr/lib" -name 'libmpi.so.40' | head -1)")
headers=$(dirname -- "$(find "$folder/usr/lib" -name mpi.h | head -1)")

cat >alone.c <<'END'
#include <mpi.h>

int main(int count, char** words) {
  MPI_Init(&count, &words);
  return MPI_Finalize();
}
END
gcc -O1 -I"$headers" alone.c -o alone -L"$library" -lmpi
export LD_LIBRARY_PATH=$library:$library/openmpi/lib OPAL_PREFIX=$folder/usr OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_mca_base_component_path=$library/openmpi/lib/openmpi3 OMPI_MCA_ess_singleton_isolated=1
export TMPDIR=$folder/tmp  # folders of its own, so that no other program is disturbed
mkdir "$TMPDIR"

# How many of 1600 programs fail, sixteen at a time.
failures() {
  for _ in {1..16}; do
    (for _ in {1..100}; do ./alone >/dev/null 2>&1 || echo failed; done) &
  done | grep -c failed || true
  wait
}

./alone || { echo "not one program alone starts"; exit 1; }
with=$(failures)
without=$(OMPI_MCA_orte_create_session_dirs=0 failures)
echo "Open MPI $version, programs of one process, sixteen at a time: $with of 1600 fail; without session folders $without"
[[ $with -gt 0 && $without -eq 0 ]]
