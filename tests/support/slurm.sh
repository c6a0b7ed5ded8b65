# shellcheck shell=bash
# Sourced, not run. Slurm on this machine alone: start_slurm FOLDER, restart_slurmd FOLDER, stop_slurm FOLDER.

# shellcheck disable=SC2034 # read by whoever sources this
slurm_fault=
slurm_daemons=() # their processes, in the order in which they must stop

unused_port() {
  local port
  while true; do
    port=$((20000 + RANDOM % 10000))
    (: <"/dev/tcp/127.0.0.1/$port") 2>/dev/null || break
  done
  echo $port
}

# Without cgroups, accounting and prologs; what it gives its node it does not check against the machine.
# A task that is requeued waits for cred_expire first.
write_slurm_conf() {
  local folder=$1 name user
  name=$(hostname -s)
  user=$(id -un)
  cat >"$folder/slurm.conf" <<END
ClusterName=restframe
SlurmctldHost=$name(127.0.0.1)
SlurmctldPort=$(unused_port)
SlurmdPort=$(unused_port)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=bf_interval=1,sched_min_interval=100000
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SwitchType=switch/none
MailProg=/bin/true
ReturnToService=2
JobRequeue=1
KillWait=2
BatchStartTimeout=1
MessageTimeout=3
SlurmdParameters=config_overrides
NodeName=$name NodeAddr=127.0.0.1 CPUs=2 RealMemory=4000
PartitionName=all Nodes=ALL Default=YES State=UP
END
}

start_slurmd() {
  slurmd -D >"$1/slurmd.out.log" 2>&1 &
  slurm_daemons[0]=$!
}

node_is_idle() { [ "$(timeout 2 sinfo --noheader --format=%T 2>/dev/null)" = idle ]; }

all_run() {
  local process
  for process in "${slurm_daemons[@]}"; do kill -0 "$process" 2>/dev/null || return 1; done
}

# Fails with the reason in slurm_fault.
start_slurm() {
  local folder=$1 end=$((SECONDS + 20))
  PATH=$PATH:/usr/sbin:/sbin # where the daemons are, and users do not look
  mkdir -p "$folder/state" "$folder/spool"
  chmod 755 "$(dirname "$folder")" "$folder" # munged wants its socket within everybody's reach
  (umask 077 && head -c 1024 /dev/urandom >"$folder/munge.key")
  write_slurm_conf "$folder"
  export SLURM_CONF=$folder/slurm.conf
  munged --foreground --key-file="$folder/munge.key" --socket="$folder/munge.socket" --num-threads=2 \
    --pid-file="$folder/munge.pid" --seed-file="$folder/munge.seed" --log-file="$folder/munge.log" \
    >"$folder/munge.out.log" 2>&1 &
  slurm_daemons[2]=$!
  for ((i = 0; i < 50; ++i)); do
    [ ! -S "$folder/munge.socket" ] || break
    sleep 0.1
  done
  slurmctld -D -c >"$folder/slurmctld.out.log" 2>&1 &
  slurm_daemons[1]=$!
  start_slurmd "$folder"
  while all_run && [ $SECONDS -lt $end ]; do
    ! node_is_idle || return 0
    sleep 0.2
  done
  # shellcheck disable=SC2034
  slurm_fault=$(cat "$folder"/{munge,slurmd,slurmctld}.out.log | grep -iE 'error|fatal|not found' | tail -n 1)
  return 1
}

# kill_and_wait SIGNAL PROCESS: a child of this shell.
kill_and_wait() {
  kill "-$1" "$2" 2>/dev/null || true
  for ((i = 0; i < 50; ++i)); do
    kill -0 "$2" 2>/dev/null || break
    sleep 0.1
  done
  kill -9 "$2" 2>/dev/null || true
  wait "$2" 2>/dev/null || true
}

# Slurm then misses the tasks whose processes are gone, if it had started them more than BatchStartTimeout and
# MessageTimeout ago.
restart_slurmd() {
  kill_and_wait TERM "${slurm_daemons[0]}"
  start_slurmd "$1"
}

# What Slurm started, by the configuration in its environment.
slurm_processes() {
  local environment
  for environment in /proc/[0-9]*/environ; do
    tr '\0' '\n' 2>/dev/null <"$environment" | grep -qxF "SLURM_CONF=$1/slurm.conf" || continue
    environment=${environment%/environ}
    [ "${environment#/proc/}" = $$ ] || echo "${environment#/proc/}"
  done
}

stop_slurm() {
  local process
  [ ${#slurm_daemons[@]} -gt 0 ] || return 0
  timeout 10 scancel --user="$(id -un)" 2>/dev/null || true
  for process in "${slurm_daemons[@]}"; do kill_and_wait TERM "$process"; done
  for process in $(slurm_processes "$1"); do kill -9 "$process" 2>/dev/null || true; done
  slurm_daemons=()
}
