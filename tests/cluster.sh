#!/usr/bin/env bash
# A cluster of this one machine: munge, slurmctld and slurmd from Debian's packages, in a temporary folder, on ports
# and with a key of their own, without systemd. `restframe submit --slurm` has it render 40 pictures; midway a task is
# requeued, one's restframe is killed, one loses Slurm's own process beside it, and the node's daemon is started anew.
# In the end every picture must be what a run without a cluster makes, to the bit.
#     tests/cluster.sh [PROGRAM]        build/release/restframe unless given
# Says so in one line and succeeds where a machine does not allow this, unless RESTFRAME_NEED_CLUSTER is set.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=SCRIPTDIR/support/packages.sh
source "$here/support/packages.sh"
# shellcheck source=SCRIPTDIR/support/slurm.sh
source "$here/support/slurm.sh"
program=$(realpath "${1:-$here/../build/release/restframe}")

skip() {
  echo "cluster: skipped, $1"
  [ -z "${RESTFRAME_NEED_CLUSTER:-}" ]
  exit
}

fail() {
  echo "cluster: $1" >&2
  squeue --array >&2 || true
  tail -n 20 "$slurm/slurmctld.log" "$slurm/slurmd.log" >&2 || true
  tail -n 5 "$slurm_folder"/*.log >&2 || true
  exit 1
}

# wait_until SECONDS WHAT COMMAND...
wait_until() {
  local end=$((SECONDS + $1)) what=$2
  shift 2
  until "$@"; do
    [ $SECONDS -lt $end ] || fail "$what: not within the time given"
    sleep 0.1
  done
}

if ! said=$(install_packages "${packages_cluster[@]}" 2>&1); then
  skip "its packages can not be had: $(tail -n 1 <<<"$said")"
fi
work=$(mktemp -d)
slurm=$work/slurm
trap 'stop_slurm "$slurm"; rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
start_slurm "$slurm" || skip "Slurm does not start here: $slurm_fault"

# Names that a shell or Slurm could misread.
mkdir "$work/a b'c %j"
cd "$work/a b'c %j"
cat >scene.toml <<'END'
[camera]
position = [0, 0.5, 5]
[animation]
rate = 8
pictures = 40
[render]
resolution = [128, 96]
samples = 64
integrator = "path"
[output]
path = "out/the $ball.####.exr"
layers = ["beauty", "Z", "time"]
END
cat "$here/support/moving_ball.toml" >>scene.toml
slurm_folder="out/the \$ball.slurm"
submit=("$program" submit --slurm scene.toml --chunk 3 --threads 1 --time 5)

queue_is_empty() { [ -z "$(squeue --noheader)" ]; }
# A task of the array that is midway, the first of its three pictures made, other than those named: 1_2.
task_midway() {
  local candidate
  for candidate in $(squeue --noheader --array --states=RUNNING --format='%F_%K' --name=restframe-the__ball); do
    [[ " $* " != *" $candidate "* && -e $(printf "out/the \$ball.%04d.exr" $((3 * ${candidate#*_}))) ]] || continue
    echo "$candidate"
    return 0
  done
  return 1
}
# The process of restframe in a task.
process_of() {
  local job pid
  job=$(squeue --noheader --array --format=%A --jobs="$1") || return 1
  for pid in $(scontrol listpids "$job" 2>/dev/null | awk 'NR > 1 { print $1 }'); do
    [ "$(readlink "/proc/$pid/exe")" != "$program" ] || { echo "$pid" && return 0; }
  done
  return 1
}
is_midway() { task=$(task_midway "$@") && process=$(process_of "$task"); }

begin=$SECONDS
timeout 80 "$program" render scene.toml --output "local/the \$ball.####.exr" --quiet
echo "cluster: 40 pictures without it: $((SECONDS - begin)) s"

begin=$SECONDS
"${submit[@]}"
wait_until 30 "a task to be midway" is_midway
requeued=$task
scontrol requeue "$requeued"
wait_until 20 "another task to be midway" is_midway "$requeued"
killed=$task
kill -9 "$process"
wait_until 20 "another task to be midway" is_midway "$requeued" "$killed"
orphaned=$task
kill -9 "$(awk '{ print $4 }' "/proc/$process/stat")"
orphaned_since=$SECONDS
echo "cluster: requeued task $requeued; killed restframe in $killed, slurmstepd of $orphaned"
status=0
"$program" status scene.toml >status.txt || status=$?
[ $status -eq 3 ] || fail "restframe status: $status, must be 3 while pictures are missing"
grep -E '^slurm: [0-9]+ running, [0-9]+ waiting$' status.txt || fail "restframe status: $(cat status.txt)"

sleep $((orphaned_since + 5 - SECONDS > 0 ? orphaned_since + 5 - SECONDS : 0))
restart_slurmd "$slurm"
wait_until 75 "the queue to empty" queue_is_empty
grep -q "missing from batch node" "$slurm/slurmctld.log" || fail "Slurm did not miss task $orphaned"
reported=$(grep '^missing:' "$slurm_folder"/check-*.log) || fail "the task that was killed is not missed"
echo "cluster: after $((SECONDS - begin)) s, by the job that checks: $reported"
"${submit[@]}"
wait_until 30 "the queue to empty" queue_is_empty
"$program" status scene.toml || fail "not all pictures are there"
for picture in local/*; do
  cmp "$picture" "out/${picture#local/}" || fail "$picture differs"
done
[ "$(find out -maxdepth 1 -type f | wc -l)" -eq 80 ] || fail "out: not just 40 pictures and 40 previews"
echo "cluster: 40 pictures as without it, to the bit, after $((SECONDS - begin)) s"
