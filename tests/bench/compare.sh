#!/usr/bin/env bash
# restframe's path integrator against Blender's Cycles and Embree's sample path tracer, on the bench lattice
# under a white sky. Run by hand, on a quiet machine: it takes about six minutes.
#     tests/bench/compare.sh [PROGRAM]        build/release/restframe unless given
# Writes tests/bench/compare.csv. Installs Debian's blender, python3-numpy and embree-tools where missing.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=SCRIPTDIR/../support/packages.sh
source "$here/../support/packages.sh"
program=$(realpath "${1:-$here/../../build/release/restframe}")
install_packages "${packages_blender[@]}" "${packages_compare[@]}" g++ libembree-dev

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_CACHE_HOME=$folder/cache PYTHONDONTWRITEBYTECODE=1
g++ -O2 -shared -fPIC -o "$folder/count_rays.so" "$here/compare/count_rays.cpp" -ldl
/usr/bin/python3 "$here/compare/compare.py" "$program" "$folder/count_rays.so" "$folder" "$here/compare.csv"
