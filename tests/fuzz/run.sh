#!/usr/bin/env bash
# Runs every fuzz target, or those named, for so many seconds each:
#     tests/fuzz/run.sh SECONDS [--record] [TARGET...]
# --record appends the numbers of executions to tests/fuzz/executions.csv. What the targets learn stays in
# build/fuzz/NAME. The input of a defect is left as build/fuzz/NAME-crash-* (or -timeout-, -oom-): put it
# under tests/fuzz/corpus/NAME, where the ordinary tests read it.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1

fuzzer=build/asan/restframe_fuzz
models=/usr/share/assimp/models
work=build/fuzz
table=tests/fuzz/executions.csv
all=(gltf glb obj mtl ply stl off image scene intervals csv formula sky)

seconds=${1:?usage: tests/fuzz/run.sh SECONDS [--record] [TARGET...]}
shift
record=
if [ "${1:-}" = --record ]; then
  record=yes
  shift
fi
[ $# -gt 0 ] || set -- "${all[@]}"
[ -x $fuzzer ] || { echo "error: no $fuzzer; run: cmake --preset asan && cmake --build --preset fuzz" >&2; exit 1; }

# models_of EXTENSION...: small files of assimp-testmodels.
models_of() {
  local extension
  [ -d $models ] || return 0
  for extension in "$@"; do find $models -iname "*.$extension" -size -40k; done
}

seeds_of() {
  find "tests/fuzz/seeds/$1" "tests/fuzz/corpus/$1" -type f 2>/dev/null
  case $1 in
    image) models_of png jpg ;;
    scene) find scenes -name '*.toml' ;;
    *) models_of "$1" ;;
  esac
}

# Longer inputs take longer and say no more.
longest_of() {
  case $1 in
    formula) echo 300 ;;
    intervals | csv) echo 1000 ;;
    mtl | off | ply | stl) echo 2000 ;;
    obj | scene) echo 5000 ;;
    *) echo 10000 ;;
  esac
}

# Seeds are copied flat, under names that folders can not make equal.
copy_seeds() {
  local file
  mkdir -p "$work/seeds/$1" "$work/$1"
  seeds_of "$1" | while read -r file; do cp "$file" "$work/seeds/$1/${file//\//_}"; done
}

run_target() {
  local target=$1 log=$work/$1.log executions
  copy_seeds "$target"
  "$fuzzer" --target="$target" -max_total_time="$seconds" -timeout=5 -rss_limit_mb=2500 -malloc_limit_mb=500 \
    -max_len="$(longest_of "$target")" -seed=1 -print_final_stats=1 -dict="tests/fuzz/dictionaries/$target.dict" \
    -artifact_prefix="$work/$target-" "$work/$target" "$work/seeds/$target" >"$log" 2>&1
  local status=$?
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  printf '%-10s %9s executions in %s s\n' "$target" "${executions:-0}" "$seconds"
  if [ $status -ne 0 ]; then
    grep -aE 'ERROR|SUMMARY|runtime error|what\(\)|Test unit written' "$log"
    echo "FAILED: $target, see $log"
  fi
  [ -z "$record" ] || echo "$target,$seconds,${executions:-0}" >>$table
  return $status
}

[ -z "$record" ] || [ -f $table ] || echo target,seconds,executions >$table
# As many at a time as there are cores.
mkdir -p $work && rm -f $work/*.failed
for target in "$@"; do
  if [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; then wait -n; fi
  { run_target "$target" || touch "$work/$target.failed"; } &
done
wait
[ ! -f $table ] || awk -F, 'NR > 1 {n += $3} END {printf "recorded so far: %d executions\n", n}' $table
! compgen -G "$work/*.failed" >/dev/null
