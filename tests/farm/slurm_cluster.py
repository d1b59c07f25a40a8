# SPDX-License-Identifier: Apache-2.0
"""A Slurm of two nodes on this machine, for as long as a test takes."""
import os
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "sinfo")
NODES = ("node1", "node2")
PORTS = (26817, 26818, 26819)  # of the controller and the nodes

CONFIGURATION = """\
ClusterName=twinray
SlurmctldHost={host}
SlurmctldPort={ports[0]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldLogFile={folder}/controller.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,bf_interval=1,sched_min_interval=1
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
ReturnToService=2
SlurmdTimeout=10
KillWait=5
MpiDefault=none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName={nodes} NodeHostname={host} NodeAddr=127.0.0.1 Port=[{ports[1]}-{ports[2]}] CPUs=2 RealMemory=1000
PartitionName=farm Nodes={nodes} Default=YES MaxTime=INFINITE PriorityTier=1
PartitionName=urgent Nodes={nodes} MaxTime=INFINITE PriorityTier=10 PreemptMode=off
"""


def signal_to(process, signal_number):
    """Sends a process a signal, unless it has ended."""
    try:
        os.kill(int(process), signal_number)
    except ProcessLookupError:
        pass


def content(path):
    """What a file of /proc holds, or nothing where its process has ended."""
    try:
        return Path(path).read_text(errors="surrogateescape")
    except OSError:
        return ""


def missing():
    """What keeps a cluster from being made here, or nothing."""
    absent = [name for name in PROGRAMS if not shutil.which(name, path=f"{os.environ['PATH']}:/usr/sbin")]
    if absent:
        return f"{', '.join(absent)} missing; Debian has them in slurmctld, slurmd, slurm-client and munge"
    return "" if os.geteuid() == 0 else "Slurm's node daemons need root"


class Cluster:
    """Daemons and their files in a folder; `with` starts and stops them."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf"),
                            "PATH": f"{os.environ['PATH']}:/usr/sbin"}

    def run(self, *words, check=True):
        """What a command prints."""
        done = subprocess.run(words, env=self.environment, text=True, check=False, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if check and done.returncode != 0:
            raise RuntimeError(f"{' '.join(words)} ended with {done.returncode}: {done.stdout}")
        return done.stdout.strip()

    def start_munge(self):
        folder = self.folder / "munge"
        folder.mkdir()
        (folder / "key").write_bytes(os.urandom(1024))
        (folder / "key").chmod(0o600)
        files = [f"--{option}={folder / name}" for option, name in (
            ("socket", "socket"), ("key-file", "key"), ("pid-file", "pid"), ("log-file", "log"),
            ("seed-file", "seed"))]
        self.run("munged", "--force", *files)

    def __enter__(self):
        self.folder.chmod(0o755)
        (self.folder / "state").mkdir()
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=socket.gethostname(), folder=self.folder, ports=PORTS, nodes=",".join(NODES)))
        self.start_munge()
        self.run("slurmctld", "-c")
        for node in NODES:
            self.run("slurmd", "-N", node)
        self.wait(lambda: self.run("sinfo", "--noheader", "-N", "-t", "idle", "-o", "%N").count("node") >= 2,
                  "both nodes are idle")
        return self

    def __exit__(self, *_):
        self.run("scancel", "--user=root", check=False)
        self.run("scontrol", "shutdown", check=False)
        time.sleep(1)
        for name in (*[f"{node}.pid" for node in NODES], "controller.pid", "munge/pid"):
            self.kill(name, signal.SIGKILL)

    def kill(self, pid_file, signal_number):
        try:
            signal_to((self.folder / pid_file).read_text(), signal_number)
        except (FileNotFoundError, ValueError):
            pass  # It has not begun, or has ended and taken its file along.

    def kill_node(self, node):
        """As a machine that loses its power: its daemon, and all that runs on it, the daemons first."""
        self.kill(f"{node}.pid", signal.SIGKILL)
        jobs = self.processes(SLURMD_NODENAME=node)
        parents = {parent for process in jobs
                   for parent in content(process / "stat").rpartition(")")[2].split()[1:2]}
        steps = [number for number in parents if content(f"/proc/{number}/comm") == "slurmstepd\n"]
        for number in (*steps, *(process.name for process in jobs)):
            signal_to(number, signal.SIGKILL)

    def freeze(self, task, program):
        """Holds a task's processes of this name where they are: they last until they are told to end. Whether
        there is one."""
        return self.tell(task, program, signal.SIGSTOP)

    def thaw(self, task, program):
        """Lets them go on."""
        return self.tell(task, program, signal.SIGCONT)

    def tell(self, task, program, signal_number):
        told = False
        for process in self.processes(SLURM_ARRAY_TASK_ID=task):
            if content(process / "comm").strip() == program:
                signal_to(process.name, signal_number)
                told = True
        return told

    def end_time_of(self, job):
        """What a node's daemon does a minute before a job's time is over: its script, alone, gets SIGUSR2."""
        script = f"/job{int(job):05d}/slurm_script"
        for process in Path("/proc").iterdir():
            words = content(process / "cmdline")
            if script in words and str(self.folder) in words:
                signal_to(process.name, signal.SIGUSR2)

    def processes(self, **variables):
        """Those of this cluster's jobs whose environment says so, as folders of /proc."""
        wanted = {f"{name}={value}" for name, value in variables.items()}
        wanted.add(f"SLURM_CONF={self.environment['SLURM_CONF']}")
        return [process for process in Path("/proc").iterdir()
                if wanted <= set(content(process / "environ").split("\0"))]

    @staticmethod
    def wait(is_so, what, seconds=180):
        end = time.monotonic() + seconds
        while not is_so():
            if time.monotonic() > end:
                raise RuntimeError(f"for {seconds} seconds it was not so that {what}")
            time.sleep(0.3)

    def tasks(self, job):
        """Of an array job: by number, each task's fields as scontrol shows them."""
        found = {}
        for line in self.run("scontrol", "--oneliner", "show", "job", job, check=False).splitlines():
            fields = dict(word.split("=", 1) for word in line.split() if "=" in word)
            number = fields.get("ArrayTaskId", "")
            if number.isdigit():
                found[int(number)] = fields
        return found
