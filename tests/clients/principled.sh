#!/usr/bin/env bash
# Materials of Cycles' Principled BSDF, exported to glTF, by Cycles and by restframe, side by side.
#     tests/clients/principled.sh [PROGRAM]        build/release/restframe unless given
# Writes tests/clients/principled.csv and .png, which tests/clients/README.md explains. Run by hand.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=SCRIPTDIR/../support/packages.sh
source "$here/../support/packages.sh"
program=$(realpath "${1:-$here/../../build/release/restframe}")
install_packages "${packages_blender[@]}" assimp-testmodels

folder=${RESTFRAME_KEEP:-$(mktemp -d)}
[ -n "${RESTFRAME_KEEP:-}" ] || trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_CACHE_HOME=$folder/cache PYTHONDONTWRITEBYTECODE=1
if ! blender --background --factory-startup --python-exit-code 1 --python "$here/principled.py" -- \
  "$program" "$folder" "$here/principled.csv" "$here/principled.png" >"$folder/blender.log" 2>&1; then
  tail -n 20 "$folder/blender.log"
  exit 1
fi
cat "$here/principled.csv"
