#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests. Arguments go to ctest:
#     tests/run.sh -R Lattice
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/packages.sh

install_packages "${packages_build[@]}" "${packages_test[@]}"
cmake --preset release -DRESTFRAME_TESTS=ON
cmake --build --preset release
exec ctest --preset release --no-tests=error -j "$(nproc)" "$@"
