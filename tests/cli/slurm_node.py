"""A Slurm cluster of this machine alone, for a test: its own munged, slurmctld and slurmd in a folder of its own."""

import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

DAEMONS = ("munged", "slurmctld", "slurmd")
COMMANDS = ("sbatch", "squeue", "scancel", "sinfo")
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
START_SECONDS = 20

CONFIGURATION = """\
ClusterName=breccia
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={daemon}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0
ReturnToService=2
KillWait=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


class NoSlurm(Exception):
    """Why no Slurm can be started here."""


def look_for_hindrances():
    missing = [name for name in (*DAEMONS, *COMMANDS) if not shutil.which(name, path=PATH)]
    if missing:
        raise NoSlurm(f"Slurm is not installed ({', '.join(missing)} not found); "
                      "on Debian: slurmctld slurmd slurm-client munge")
    if os.getuid() != 0:
        raise NoSlurm("only root may start slurmd")


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Node:
    """Starts the daemons; `environment` is what the commands of Slurm need to find them."""

    def __init__(self, folder, cpus=2):
        self.folder = pathlib.Path(folder)
        self.running = []
        look_for_hindrances()
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], controller=free_port(), daemon=free_port(),
            folder=self.folder, cpus=cpus))
        # Nothing here uses control groups; slurmd loads its plugin all the same, and the older one starts without any.
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(configuration)}
        try:
            self.start("munged", "--foreground", f"--socket={self.folder}/munge.socket", f"--key-file={key}",
                       f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log",
                       f"--seed-file={self.folder}/munge.seed", "--force")
            self.wait("munged", lambda: (self.folder / "munge.socket").exists())
            self.start("slurmctld", "-D")
            self.start("slurmd", "-D", "-N", socket.gethostname().split(".")[0])
            self.wait("the node", lambda: "idle" in self.output("sinfo", "--noheader", "--format=%T"))
        except BaseException:
            self.stop()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def start(self, name, *arguments):
        with open(self.folder / f"{name}.out", "wb") as out:
            self.running.append(subprocess.Popen([shutil.which(name, path=PATH), *arguments], stdout=out, stderr=out,
                                                 env=self.environment, cwd=self.folder, start_new_session=True))

    def output(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=30).stdout

    def wait(self, what, ready):
        end = time.monotonic() + START_SECONDS
        while not ready():
            if time.monotonic() > end or any(process.poll() is not None for process in self.running):
                logs = "".join(f"\n== {path.name}\n{path.read_text(errors='replace')[-1000:]}"
                               for path in sorted(self.folder.glob("*.out")))
                raise NoSlurm(f"{what} does not start{logs}")
            time.sleep(0.1)

    def stop(self):
        for process in reversed(self.running):
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.running = []
