#!/usr/bin/env bash
# Starts a Slurm of its own on this machine: munge, a controller and node daemons on the loopback, without a database of accounts;
# runs a command under it, and ends them all.
#
# Usage: scripts/slurm-loopback.sh [--nodes N] COMMAND...
# N nodes (default: 3) of one processor each, however many the machine has. Needs slurmctld, slurmd, slurm-client and munge
# (scripts/packages-full.txt), and root. Nothing of the machine's own configuration is read or changed: all files lie in a folder
# that is removed at the end.
#
# For COMMAND there are, so that tests can hurt the daemons:
#   $SLURM_LOOPBACK        the folder; controller.pid and node1.pid, node2.pid ... in it name the daemons
#   $SLURM_LOOPBACK/scratch  on each node another small disk, where mount namespaces can be made
#   start_controller, start_node K   functions of bash that start a daemon again
set -euo pipefail

nodes=3
if [ "${1-}" = --nodes ]; then
  nodes="${2-}"
  shift 2
fi
[ $# -gt 0 ] || { echo "usage: scripts/slurm-loopback.sh [--nodes N] COMMAND..." >&2; exit 2; }
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" > /dev/null || { echo "slurm-loopback: $program is missing; see scripts/packages-full.txt" >&2; exit 3; }
done

SLURM_LOOPBACK="$(mktemp -d -p "${TMPDIR:-/var/tmp}" slurm.XXXXXX)"
SLURM_CONF="$SLURM_LOOPBACK/slurm.conf"
export SLURM_LOOPBACK SLURM_CONF
chmod 755 "$SLURM_LOOPBACK"
mkdir "$SLURM_LOOPBACK"/{state,munge,scratch}

# The daemons, their steps and their jobs: what has the configuration in its environment.
processes() {
  local pattern="^SLURM_CONF=$SLURM_CONF\$"
  (unset SLURM_CONF && grep -lzs "$pattern" /proc/[0-9]*/environ | cut -d / -f 3)
}

# Runs a command until it says yes, so many seconds at most.
await() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.1
  done
}
all_ended() { [ -z "$(processes)" ]; }
queue_is_empty() { ! squeue --noheader 2> /dev/null | grep -q .; }

finish() {
  scancel --quiet --user=root 2> /dev/null && await 10 queue_is_empty || true
  for signal in TERM KILL; do
    # shellcheck disable=SC2046 # one word for each
    kill -s $signal $(processes) 2> /dev/null || true
    await 10 all_ended && break
  done
  rm -rf "$SLURM_LOOPBACK"
}
trap finish EXIT

start_controller() { slurmctld; }

# A node sees a scratch of its own, if the machine lets it.
start_node() {
  if unshare --mount true 2> /dev/null; then
    unshare --mount sh -c 'mount -t tmpfs -o size=160m scratch "$SLURM_LOOPBACK/scratch" && exec slurmd -N "$0"' "node$1"
  else
    slurmd -N "node$1"
  fi
}
export -f start_controller start_node

# munge: a key and a socket of this run.
dd if=/dev/urandom of="$SLURM_LOOPBACK/munge/key" bs=1024 count=1 status=none
chmod 400 "$SLURM_LOOPBACK/munge/key"
munged --force --key-file="$SLURM_LOOPBACK/munge/key" --socket="$SLURM_LOOPBACK/munge/socket" \
  --pid-file="$SLURM_LOOPBACK/munge/pid" --log-file="$SLURM_LOOPBACK/munge/log" --seed-file="$SLURM_LOOPBACK/munge/seed"

# The times are short, so that tests need not wait for them: when a node that is silent counts as lost, how long a job that was
# requeued waits before it may begin (cred_expire), and how old a job must be to be requeued if its node does not know it
# (the last three).
host="$(hostname -s)"
cat > "$SLURM_CONF" << CONF
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$SLURM_LOOPBACK/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$SLURM_LOOPBACK/state
SlurmdSpoolDir=$SLURM_LOOPBACK/spool-%n
SlurmctldPidFile=$SLURM_LOOPBACK/controller.pid
SlurmdPidFile=$SLURM_LOOPBACK/%n.pid
SlurmctldLogFile=$SLURM_LOOPBACK/controller.log
SlurmdLogFile=$SLURM_LOOPBACK/%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0
ReturnToService=2
SlurmdTimeout=10
BatchStartTimeout=2
MessageTimeout=5
ResumeTimeout=5
KillWait=2
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
JobRequeue=1
JobCompType=jobcomp/none
AccountingStorageType=accounting_storage/none
SlurmdParameters=config_overrides
CONF
memory="$(awk '/MemTotal/ { print int($2 / 1024) }' /proc/meminfo)"
for node in $(seq "$nodes"); do
  echo "NodeName=node$node NodeHostname=$host NodeAddr=127.0.0.1 Port=$((17000 + node)) CPUs=1 RealMemory=$memory" >> "$SLURM_CONF"
done
{
  echo "PartitionName=long Nodes=node[1-$nodes] Default=YES MaxTime=INFINITE State=UP PriorityTier=1"
  echo "PartitionName=urgent Nodes=node[1-$nodes] MaxTime=INFINITE State=UP PriorityTier=10 PreemptMode=OFF"
} >> "$SLURM_CONF"

start_controller
for node in $(seq "$nodes"); do
  mkdir "$SLURM_LOOPBACK/spool-node$node"
  start_node "$node"
done
nodes_are_up() { [ "$(sinfo --noheader --Node --partition=long --format=%T 2> /dev/null | grep -c idle)" = "$nodes" ]; }
await 60 nodes_are_up || { echo "slurm-loopback: the nodes do not come up; their logs:" >&2; tail -n 20 "$SLURM_LOOPBACK"/*.log >&2; exit 3; }

"$@"
