#!/bin/bash
# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
#
# A Slurm cluster of one node on loopback, from Debian's slurm-wlm and munge, with everything it writes in one folder.
#   slurm_cluster.sh start DIR   prints nothing and makes DIR/slurm.conf, or prints why it cannot and exits with 1
#   slurm_cluster.sh stop DIR
set -u
command=$1
dir=$2

stop() {
  for name in slurmd slurmctld munged; do
    [ -f "$dir/$name.process" ] || continue
    kill "$(cat "$dir/$name.process")" 2>/dev/null
  done
  for name in slurmd slurmctld munged; do
    [ -f "$dir/$name.process" ] || continue
    for _ in $(seq 50); do kill -0 "$(cat "$dir/$name.process")" 2>/dev/null || break; sleep 0.1; done
    kill -9 "$(cat "$dir/$name.process")" 2>/dev/null
    rm -f "$dir/$name.process"
  done
}
fail() { echo "$1"; stop; exit 1; }

case $command in
  stop) stop; exit 0 ;;
  start) ;;
  *) fail "usage: slurm_cluster.sh start|stop DIR" ;;
esac

for program in slurmctld slurmd munged sbatch squeue; do
  PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || fail "no $program here (Debian packages slurm-wlm and munge)"
done
PATH=$PATH:/usr/sbin
user=$(id -un)
base=$((20000 + $$ % 20000))
mkdir -p "$dir/state" "$dir/spool"
chmod 755 "$dir"
head -c 1024 /dev/urandom > "$dir/munge.key"
chmod 600 "$dir/munge.key"
memory=$(($(getconf _PHYS_PAGES) * $(getconf PAGE_SIZE) / 1048576 * 9 / 10))
cat > "$dir/slurm.conf" <<EOF
ClusterName=hydrabench_test
SlurmctldHost=localhost
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$dir/munge.socket
SlurmctldPort=$base
SlurmdPort=$((base + 1))
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
JobRequeue=1
KillWait=2
MinJobAge=600
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName=localhost NodeAddr=127.0.0.1 CPUs=2 Boards=1 SocketsPerBoard=1 CoresPerSocket=2 ThreadsPerCore=1 RealMemory=$memory State=UNKNOWN
PartitionName=main Nodes=localhost Default=YES MaxTime=INFINITE State=UP
EOF

start() {
  local name=$1
  shift
  "$@" >"$dir/$name.log" 2>&1 </dev/null &
  echo $! > "$dir/$name.process"
}
start munged munged --foreground --force --socket "$dir/munge.socket" --key-file "$dir/munge.key" --pid-file "$dir/munged.pid" \
  --log-file "$dir/munged_own.log" --seed-file "$dir/munge.seed" --num-threads 1
for _ in $(seq 50); do [ -S "$dir/munge.socket" ] && break; sleep 0.1; done
[ -S "$dir/munge.socket" ] || fail "munged did not start: $(tail -n 1 "$dir/munged.log")"
start slurmctld slurmctld -D -f "$dir/slurm.conf" -i
start slurmd slurmd -D -N localhost -f "$dir/slurm.conf"
for _ in $(seq 200); do
  if SLURM_CONF="$dir/slurm.conf" sinfo --noheader --format=%T 2>/dev/null | grep -q idle; then exit 0; fi
  sleep 0.1
done
fail "the node did not come up: $(tail -n 1 "$dir/slurmctld.log") $(tail -n 1 "$dir/slurmd.log")"
