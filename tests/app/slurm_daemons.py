# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of one node for tests: slurmctld and slurmd of this machine, in a folder of their own, gone at the end.

No munge: authentication is off, and both daemons listen on free ports. They need root.
"""
import os
import shutil
import socket
import subprocess
import tempfile
import time

DAEMONS = ("slurmctld", "slurmd")
CONFIGURATION = """ClusterName=tests
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ReturnToService=2
SchedulerParameters=sched_interval=1,bf_interval=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
"""


def why_not():
    """Why no Slurm can be run here; empty where one can."""
    missing = [d for d in DAEMONS + ("sbatch",) if not _path(d)]
    if missing:
        return "no " + ", ".join(missing) + " (packages slurmctld, slurmd, slurm-client)"
    return "" if os.geteuid() == 0 else "Slurm's daemons need root"


class Slurm:
    """with Slurm() as slurm: slurm.environment is for sbatch and the like."""

    def __init__(self, cpus=2):
        self.folder = tempfile.mkdtemp()  # short: the paths of its sockets may have 108 characters
        os.makedirs(os.path.join(self.folder, "state"))
        os.makedirs(os.path.join(self.folder, "spool"))
        self.host = socket.gethostname().split(".")[0]
        configuration = os.path.join(self.folder, "slurm.conf")
        with open(configuration, "w") as file:
            file.write(CONFIGURATION.format(host=self.host, ports=_free_ports(2), folder=self.folder, cpus=cpus))
        self.environment = {**os.environ, "SLURM_CONF": configuration}
        self.running = []

    def __enter__(self):
        for daemon, name in zip(DAEMONS, ((), ("-N", self.host))):
            with open(os.path.join(self.folder, daemon + ".out"), "w") as out:
                self.running.append(subprocess.Popen([_path(daemon), "-D", *name], env=self.environment, stdout=out, stderr=subprocess.STDOUT,
                                                     start_new_session=True))
        try:
            self._wait_until(lambda: "idle" in self.ask("sinfo", "-h", "-o", "%T"), 60, "the node is not idle")
        except Exception:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for process in reversed(self.running):
            process.terminate()
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def ask(self, *command):
        """What the command prints; empty where it fails."""
        done = subprocess.run(command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        return done.stdout if done.returncode == 0 else ""

    def wait_for_jobs(self, seconds):
        """Until no job is left."""
        self._wait_until(lambda: not self.ask("squeue", "-h").strip() and self.ask("sinfo", "-h"), seconds, "jobs are left")

    def _wait_until(self, is_so, seconds, otherwise):
        end = time.time() + seconds
        while not is_so():
            if time.time() > end:
                raise TimeoutError("Slurm: %s after %d s\n%s" % (otherwise, seconds, self.logs()))
            time.sleep(0.5)

    def logs(self):
        said = []
        for name in sorted(os.listdir(self.folder)):
            if name.endswith((".log", ".out")):
                with open(os.path.join(self.folder, name), errors="replace") as file:
                    said.append(name + ":\n" + "".join(file.readlines()[-20:]))
        return "\n".join(said)


def _path(program):
    return shutil.which(program, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def _free_ports(n):
    """None of them is taken now; that none is taken a moment later cannot be promised."""
    sockets = [socket.socket() for _ in range(n)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports
