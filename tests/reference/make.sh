#!/usr/bin/env bash
# Remakes the contact sheets and the table's outcomes: make.sh [RESTFRAME [MODELS]]
# RESTFRAME: the program, of the release build unless given; MODELS: the folder of assimp-testmodels.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release/restframe}
models=${2:-/usr/share/assimp/models}
for needed in "$program" "$models"; do
  [[ -e $needed ]] || { echo "make.sh: $needed is not there" >&2; exit 2; }
done
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
export PYTHONDONTWRITEBYTECODE=1
python3 "$here/self_made.py" "$made"
timeout 600 python3 "$here/sheets.py" "$program" "$models" "$made"
