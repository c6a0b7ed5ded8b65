#!/usr/bin/env bash
# Blender's Cycles as a reference at rest: a Cornell box, and rough metal and glass under a sky, built from
# Cycles' Diffuse and GGX nodes and exported by Blender, rendered by both.
#     tests/clients/cycles.sh [PROGRAM]        build/release/restframe unless given
# Writes tests/clients/cycles.csv; fails where the pictures differ by more than their noise. Run by hand:
# it takes minutes. Installs Debian's blender and python3-numpy where they are missing.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=SCRIPTDIR/../support/packages.sh
source "$here/../support/packages.sh"
program=$(realpath "${1:-$here/../../build/release/restframe}")
install_packages "${packages_blender[@]}"

folder=${RESTFRAME_KEEP:-$(mktemp -d)}
[ -n "${RESTFRAME_KEEP:-}" ] || trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_CACHE_HOME=$folder/cache PYTHONDONTWRITEBYTECODE=1
if ! blender --background --factory-startup --python-exit-code 1 --python "$here/cycles.py" -- \
  "$program" "$folder" "$here/cycles.csv" >"$folder/blender.log" 2>&1; then
  tail -n 20 "$folder/blender.log"
  exit 1
fi
cat "$here/cycles.csv"
