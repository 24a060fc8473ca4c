#!/usr/bin/env bash
# Starts a Slurm of its own on this machine: munge, a controller and three node daemons on the loopback, without accounts; runs
# a command under it, and ends them all. Each node has as many processors as the machine, so that jobs share them.
#
# Usage: scripts/slurm-loopback.sh COMMAND...
# Needs slurmctld, slurmd, slurm-client and munge (scripts/packages-full.txt), and root. Nothing of the machine's own
# configuration is read or changed: all files lie in a folder that is removed at the end. $SLURM_LOOPBACK is that folder for
# COMMAND: node1.pid to node3.pid and controller.pid in it name the daemons, for tests that kill them.
set -euo pipefail

[ $# -gt 0 ] || { echo "usage: scripts/slurm-loopback.sh COMMAND..." >&2; exit 2; }
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" > /dev/null || { echo "slurm-loopback: $program is missing; see scripts/packages-full.txt" >&2; exit 3; }
done

readonly nodes=3
folder="$(mktemp -d -p "${TMPDIR:-/var/tmp}")"
readonly folder
chmod 755 "$folder"
mkdir "$folder/state" "$folder/munge"
pids=()

finish() {
  for pid in "${pids[@]}" $(cat "$folder"/*.pid 2> /dev/null); do kill "$pid" 2> /dev/null || true; done
  wait
  rm -rf "$folder"
}
trap finish EXIT

# munge: a key and a socket of this run.
dd if=/dev/urandom of="$folder/munge/key" bs=1024 count=1 status=none
chmod 400 "$folder/munge/key"
munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" \
  --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" &
pids+=($!)

processors="$(nproc)"
memory="$(awk '/MemTotal/ { print int($2 / 1024) }' /proc/meminfo)"
cat > "$folder/slurm.conf" << CONF
ClusterName=loopback
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/controller.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/controller.log
SlurmdLogFile=$folder/%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0
ReturnToService=2
SlurmdTimeout=10
KillWait=2
MinJobAge=3600
JobRequeue=1
JobCompType=jobcomp/none
AccountingStorageType=accounting_storage/none
SlurmdParameters=config_overrides
CONF
for node in $(seq $nodes); do
  echo "NodeName=node$node NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$((17000 + node)) CPUs=$processors RealMemory=$memory" \
    >> "$folder/slurm.conf"
done
echo "PartitionName=long Nodes=node[1-$nodes] Default=YES MaxTime=INFINITE State=UP OverSubscribe=YES" >> "$folder/slurm.conf"
export SLURM_CONF="$folder/slurm.conf"

until [ -S "$folder/munge/socket" ]; do sleep 0.1; done
slurmctld -D > /dev/null 2>&1 &
pids+=($!)
for node in $(seq $nodes); do
  mkdir "$folder/spool-node$node"
  slurmd -D -N "node$node" > /dev/null 2>&1 &
  pids+=($!)
done
for second in $(seq 60); do
  [ "$(sinfo -h -o %T -N 2> /dev/null | grep -c idle || true)" = "$nodes" ] && break
  [ "$second" != 60 ] || { echo "slurm-loopback: the nodes do not come up; their logs:" >&2; tail -n 20 "$folder"/*.log >&2; exit 3; }
  sleep 1
done

export SLURM_LOOPBACK="$folder"
"$@"
