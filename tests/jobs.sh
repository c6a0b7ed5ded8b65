#!/usr/bin/env bash
# Jobs that survive: `restframe render` is killed 50 times at random moments, runs out of disk, loses its
# permissions and has company in its folder. In the end every picture must be what an undisturbed run makes, to the
# bit; and at no time may anything else lie under a picture's name.
#     tests/jobs.sh [PROGRAM] [SEED]        build/release/restframe and 1 unless given
# What this machine does not allow is reported as skipped.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "${1:-$here/../build/release/restframe}")
RANDOM=${2:-1}
kills=25 # of the animation, and as many of the still
patience=20 # seconds, after which what does not end is taken to hang

work=$(mktemp -d)
disk=$work/disk
running=()
cleanup() {
  [ ${#running[@]} -eq 0 ] || kill -KILL "${running[@]}" 2>/dev/null || true
  ! mountpoint -q "$disk" 2>/dev/null || umount "$disk"
  chmod -R u+rwx "$work"
  rm -rf "$work"
}
trap cleanup EXIT
trap 'exit 1' INT TERM
exec 3>&2 # for messages while the shell's own, about killed processes, go nowhere
cd "$work"
chmod 755 "$work" # another user goes in, too

say() { echo "jobs: $1"; }
skipped() { echo "skipped: $1"; }
fail() {
  echo "jobs: $1" >&3
  [ ! -s error.txt ] || sed 's/^/jobs: it said: /' error.txt >&3
  exit 1
}

# An animation of small pictures, and a still that takes seconds.
cat >scene.toml <<'END'
[camera]
position = [0, 0.5, 5]
[animation]
rate = 8
pictures = 24
[render]
resolution = [160, 120]
samples = 12
integrator = "path"
[output]
path = "none/p.####.exr"
layers = ["beauty", "Z", "time", "N", "variance", "samples"]
END
cat "$here/support/moving_ball.toml" >>scene.toml
animation=("$program" render scene.toml --quiet)
still=("$program" render scene.toml --quiet --pictures 3 --size 320x240 --checkpoint 0.15)

milliseconds() { echo $(($(date +%s%N) / 1000000)); }

# ended STATUS...: the last run ended with one of these, with a line for every failure, without a signal of its own.
ended() {
  local allowed
  for allowed in "$@"; do [ "$status" -ne "$allowed" ] || break; done
  [ "$status" -eq "$allowed" ] || fail "exit code $status, must be one of $*"
  case $status in
    0 | 137 | 143) ;;
    *)
      [ "$(wc -l <error.txt)" -eq 1 ] || fail "exit code $status without just one line"
      grep -q '^error: ' error.txt || fail "exit code $status without an error"
      ;;
  esac
}

# run COMMAND...: to its end, for `ended`.
run() {
  status=0
  timeout -s KILL 60 "$@" 2>error.txt >/dev/null || status=$?
}

# wait_for PID: its status; it must end soon.
wait_for() {
  status=0
  local end=$((SECONDS + patience))
  while kill -0 "$1" 2>/dev/null && [ $SECONDS -lt $end ]; do sleep 0.01; done
  ! kill -0 "$1" 2>/dev/null || fail "it does not end"
  wait "$1" || status=$?
  running=()
}

# same FOLDER REFERENCE: whatever lies under a final name is what it must be.
same() {
  local file
  for file in "$1"/*.exr "$1"/*.png; do
    [ -e "$file" ] || continue
    cmp -s "$file" "$2/${file##*/}" || fail "$file is not what an undisturbed run makes"
  done
}

# whole FOLDER REFERENCE: all of it, and nothing else.
whole() {
  same "$1" "$2"
  [ "$(find "$1" -type f | wc -l)" -eq "$(find "$2" -type f | wc -l)" ] ||
    fail "$1 holds $(find "$1" -type f -printf '%f ')"
}

# kill_often FOLDER REFERENCE LONGEST COMMAND...: kills it `kills` times within so many milliseconds of its start.
kill_often() {
  local folder=$1 reference=$2 longest=$3 pid signal sent i terms=0 parts=0 slowest=0
  shift 3
  for ((i = 0; i < kills; ++i)); do
    "$@" 2>error.txt &
    pid=$!
    running=("$pid")
    signal=TERM
    [ $((RANDOM % 2)) -eq 0 ] || signal=KILL
    sleep "$(printf '0.%03d' $((RANDOM % longest)))"
    sent=$(milliseconds)
    kill -$signal $pid 2>/dev/null || true
    wait_for $pid
    sent=$(($(milliseconds) - sent))
    if [ $signal = TERM ]; then
      # 143: before the program had begun.
      ended 0 130 143
      [ $status -ne 130 ] || terms=$((terms + 1))
      [ $sent -le $slowest ] || slowest=$sent
    else
      ended 0 137
    fi
    same "$folder" "$reference"
    [ -z "$(find "$folder" -name '*.part' 2>/dev/null)" ] || parts=$((parts + 1))
  done
  run "$@"
  ended 0
  whole "$folder" "$reference"
  [ $terms -gt 0 ] || fail "SIGTERM never came while it was at work"
  say "$kills kills, $terms of them ended in order after $slowest ms at most, a checkpoint was there after $parts"
  [ "$folder" != still ] || [ $parts -gt 0 ] || fail "there never was a checkpoint"
}

test_animation() {
  local begin
  begin=$(milliseconds)
  run "${animation[@]}" --output reference/p.####.exr
  ended 0
  say "an animation: $(($(milliseconds) - begin)) ms undisturbed"
  kill_often animation reference 400 "${animation[@]}" --output animation/p.####.exr 2>/dev/null
}

# As many samples as make it last some seconds here.
test_still() {
  local begin milliseconds samples=64
  begin=$(milliseconds)
  run "${still[@]}" --output probe.exr --samples $samples
  ended 0
  milliseconds=$(($(milliseconds) - begin))
  samples=$((samples * 4000 / (milliseconds > 50 ? milliseconds : 50)))
  still+=(--samples $((samples < 32 ? 32 : samples > 4096 ? 4096 : samples)))
  begin=$(milliseconds)
  run "${still[@]}" --output still_reference/p.exr
  ended 0
  say "a still: $(($(milliseconds) - begin)) ms undisturbed"
  kill_often still still_reference 600 "${still[@]}" --output still/p.exr 2>/dev/null
}

test_full_disk() {
  mkdir -p "$disk"
  if ! mount -t tmpfs -o size=600k none "$disk" 2>mount.txt; then
    skipped "a small disk: $(head -n 1 mount.txt)"
    return
  fi
  run "${animation[@]}" --output "$disk/p.####.exr"
  ended 3
  grep -q 'No space left' error.txt || fail "a full disk is not named"
  same "$disk" reference
  [ -z "$(find "$disk" -name '.restframe-*')" ] || fail "something half written is left on a full disk"
  say "a full disk holds $(find "$disk" -name '*.exr' | wc -l) whole pictures"
  mount -o remount,size=100m "$disk"
  run "${animation[@]}" --output "$disk/p.####.exr"
  ended 0
  whole "$disk" reference
  umount "$disk"
}

test_no_room() {
  # A file of up to 8 KB: the preview fits, the picture does not.
  run bash -c 'ulimit -f 8; exec "$@"' - "${animation[@]}" --output limited/p.####.exr
  ended 3
  [ -z "$(find limited -type f)" ] || fail "something is left where no file may be as large: $(ls -A limited)"
  mkdir devices
  ln -s /dev/full devices/p.0000.exr
  run "${animation[@]}" --output devices/p.####.exr
  ended 3
  [ -L devices/p.0000.exr ] || fail "a link to a device was replaced"
  [ -c /dev/full ] || fail "a device was replaced"
  status=0
  "$program" info scene.toml >/dev/full 2>error.txt || status=$?
  ended 3
  # A checkpoint for which there is no room: the picture may get on without.
  mkdir -p no_checkpoint/p.exr.part
  run "${still[@]}" --output no_checkpoint/p.exr
  [ $status -eq 0 ] || fail "exit code $status without a checkpoint"
  [ "$(grep -c '^warning: ' error.txt)" -eq 1 ] || fail "a missing checkpoint is not told once"
  same no_checkpoint still_reference
  say "no room: nothing partial"
}

# Root may write everywhere: somebody else tries.
test_permissions() {
  local as=()
  mkdir denied
  "${animation[@]}" --output denied/p.####.exr --pictures 0-1
  if [ "$(id -u)" -eq 0 ]; then
    cp "$program" "$work/restframe"
    as=(setpriv --reuid=65534 --regid=65534 --clear-groups)
    if ! "${as[@]}" "$work/restframe" --version >/dev/null 2>&1; then
      skipped "permissions: no other user can run the program"
      return
    fi
    animation[0]=$work/restframe
  fi
  chmod 555 denied
  run "${as[@]}" "${animation[@]}" --output denied/p.####.exr --pictures 0-1
  ended 0 # all that is wanted is there
  run "${as[@]}" "${animation[@]}" --output denied/p.####.exr
  ended 3
  grep -q 'Permission denied' error.txt || fail "a folder that can not be written is not named"
  run "${as[@]}" "${animation[@]}" --output denied/new/p.####.exr
  ended 3
  same denied reference
  [ "$(find denied -type f | wc -l)" -eq 4 ] || fail "a folder that can not be written has changed"
  chmod 000 scene.toml
  run "${as[@]}" "${animation[@]}" --output other/p.####.exr
  ended 2
  chmod 644 scene.toml
  animation[0]=$program
  say "no permission: told before anything is rendered"
}

# Two at a time; in the second round one of them is killed midway.
test_company() {
  local round first second
  for round in 1 2; do
    "${animation[@]}" --output company/p.####.exr 2>error.txt &
    first=$!
    "${animation[@]}" --output company/p.####.exr 2>other.txt &
    second=$!
    running=("$first" "$second")
    if [ $round -eq 2 ]; then
      sleep 0.3
      kill -KILL $second
    fi
    status=0
    wait $second || status=$?
    [ $status -eq 0 ] || [ $round -eq 2 ] || fail "one of two: exit code $status: $(cat other.txt)"
    status=0
    wait $first || status=$?
    ended 0
    running=()
    same company reference
    [ $round -eq 2 ] || whole company reference
    rm -f company/p.000[0-4].exr company/p.00[12]*
  done
  run "${animation[@]}" --output company/p.####.exr
  ended 0
  whole company reference
  "${still[@]}" --output both/p.exr 2>error.txt &
  first=$!
  "${still[@]}" --output both/p.exr 2>other.txt &
  second=$!
  running=("$first" "$second")
  status=0
  wait $second || status=$?
  [ $status -eq 0 ] || fail "one of two: exit code $status: $(cat other.txt)"
  wait $first || status=$?
  ended 0
  running=()
  same both still_reference
  [ -e both/p.exr ] || fail "two made no picture"
  say "two processes on one folder: every picture whole"
}

begin=$SECONDS
test_animation
test_still
test_full_disk
test_no_room
test_permissions
test_company 2>/dev/null
say "all as undisturbed, after $((SECONDS - begin)) s"
