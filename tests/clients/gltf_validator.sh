#!/usr/bin/env bash
# Holds `restframe check` against the Khronos glTF validator: over the glTF files of assimp-testmodels and over
# self-made ones that are broken in one way each. Where one of the two refuses what the other reads, the file must
# be in gltf_validator.csv beside this script, with the reason; and nothing else may be there.
#     tests/clients/gltf_validator.sh [RESTFRAME]
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
source tests/support/packages.sh

restframe=${1:-build/release/restframe}
work=build/validator
table=tests/clients/gltf_validator.csv
package=gltf-validator@2.0.0-dev.3.10

skip() {
  echo "SKIPPED: $1; restframe is not compared with the Khronos validator"
  exit 0
}

have_node() { command -v node >/dev/null && command -v npm >/dev/null; }
have_node || install_packages nodejs npm || skip "node and npm can not be had"
mkdir -p $work
[ -d $work/node_modules/gltf-validator ] ||
  timeout 120 npm install --silent --no-audit --no-fund --prefix $work $package >$work/npm.log 2>&1 ||
  skip "npm can not get $package (see $work/npm.log)"

models() { dpkg -L assimp-testmodels | grep -E '\.(gltf|glb)$'; }

rm -rf $work/broken
node tests/clients/broken_gltf.js $work/broken
mapfile -t files < <(find $work/broken -type f | sort && models | sort)

# Both must read a file, or both refuse it.
differences() {
  local file validator restframe_says
  NODE_PATH=$work/node_modules node tests/clients/gltf_validator.js "${files[@]}" >$work/verdicts.csv || return 1
  echo file,validator,restframe
  while IFS=, read -r file validator; do
    timeout 20 "$restframe" check "$file" >>$work/check.log 2>&1
    case $? in
      0) restframe_says=reads ;;
      2) restframe_says=refuses ;;
      *) restframe_says=FAILS ;;
    esac
    case "$validator,$restframe_says" in
      ok,reads) ;;
      *,FAILS | ok,refuses | *,reads) echo "$(basename "$(dirname "$file")")/$(basename "$file"),$validator,$restframe_says" ;;
    esac
  done <$work/verdicts.csv
}

: >$work/check.log
differences >$work/differences.csv || { echo "error: the validator failed"; exit 1; }
echo "${#files[@]} files, $(($(wc -l <$work/differences.csv) - 1)) differences"
diff -u --label "$table" --label found <(cut -d, -f1-3 $table) $work/differences.csv || {
  echo "error: the differences are not those of $table: mend restframe, or give the reason there"
  exit 1
}
