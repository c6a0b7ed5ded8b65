#!/usr/bin/env bash
# Blender as a client: a scene with custom properties, exported by Blender's own exporter, rendered by
# restframe, and compared with what the properties ask for.
#     tests/clients/blender.sh [PROGRAM]        build/release/restframe unless given
# Installs Debian's blender and python3-numpy (520 MB) where they are missing. Says so in one line and
# succeeds where they can not be had, unless RESTFRAME_NEED_BLENDER is set.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=SCRIPTDIR/../support/packages.sh
source "$here/../support/packages.sh"
program=$(realpath "${1:-$here/../../build/release/restframe}")

if ! said=$(install_packages "${packages_blender[@]}" 2>&1); then
  echo "blender: skipped, its packages can not be had: $(tail -n 1 <<<"$said")"
  [ -z "${RESTFRAME_NEED_BLENDER:-}" ]
  exit
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export XDG_CONFIG_HOME=$folder/config XDG_CACHE_HOME=$folder/cache
if ! timeout 120 blender --background --factory-startup --python-exit-code 1 \
  --python "$here/blender_scene.py" -- "$folder/scene.glb" >blender.log 2>&1; then
  tail -n 20 blender.log
  echo "blender: failed to export the scene" >&2
  exit 1
fi
timeout 60 "$program" render scene.glb --output picture.exr --quiet
PYTHONDONTWRITEBYTECODE=1 python3 "$here/blender_check.py" picture.exr
