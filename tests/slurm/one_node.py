"""A study in shares on a real Slurm of one node: an array of 8 tasks, one of which is killed.

    one_node.py STRAINWAVE EXAMPLES SCRIPT

The test starts munged, slurmctld and slurmd in a folder of its own, which needs root.  It submits
examples/slurm/study.sbatch as an array, kills one task with signal 9, requeues it, merges the
shards, and compares the bytes with those of one run.  Exit status 77: this machine cannot run it.
"""
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SKIPPED = 77
SHARES = 8


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def run(*words, **options):
    return subprocess.run([str(word) for word in words], check=True, text=True,
                          capture_output=True, **options).stdout


def wait_until(done, seconds, what):
    end = time.monotonic() + seconds
    while not done():
        if time.monotonic() > end:
            raise AssertionError(f"{what}: not after {seconds} s")
        time.sleep(0.1)


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """Slurm of one node, with its daemons, files and ports in one folder."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = []
        control, node = free_ports(2)
        name = socket.gethostname().split(".")[0]
        for part in ("state", "spool", "munge"):
            (folder / part).mkdir(mode=0o700)
        key = folder / "munge" / "key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.munge_socket = folder / "munge" / "socket"
        conf = folder / "slurm.conf"
        conf.write_text(f"""\
ClusterName=test
SlurmctldHost={name}(127.0.0.1)
SlurmctldPort={control}
SlurmdPort={node}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={self.munge_socket},cred_expire=5
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SwitchType=switch/none
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MinJobAge=300
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName={name} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} State=UNKNOWN
PartitionName=all Nodes={name} Default=YES MaxTime=INFINITE State=UP
""")
        self.environment = dict(os.environ, SLURM_CONF=str(conf))
        self.start("munged", "--foreground", f"--key-file={key}", f"--socket={self.munge_socket}",
                   f"--pid-file={folder}/munged.pid", f"--log-file={folder}/munged.log",
                   f"--seed-file={folder}/munge/seed", "--force")
        wait_until(self.munge_socket.exists, 10, "munged")
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D", "-N", name)
        wait_until(lambda: "idle" in self("sinfo", "-h", "-o", "%T"), 30, "the node is idle")

    def start(self, *words):
        log = open(self.folder / f"{words[0]}.out", "w")
        self.daemons.append(subprocess.Popen(words, env=self.environment, stdout=log, stderr=log))

    def __call__(self, *words):
        done = subprocess.run([str(word) for word in words], env=self.environment, text=True,
                              capture_output=True, cwd=self.folder)
        return done.stdout if done.returncode == 0 else ""

    def stop(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in reversed(self.daemons):
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()


def main(strainwave, examples, script):
    if os.geteuid() != 0:
        skip("the daemons of Slurm need root")
    os.environ["PATH"] = f"{Path(strainwave).parent}:/usr/sbin:{os.environ['PATH']}"
    for word in ("munged", "slurmctld", "slurmd", "sbatch"):
        if shutil.which(word) is None:
            skip(f"{word} is not installed")
    folder = Path(tempfile.mkdtemp(prefix="slurm"))
    study = ["sensitivity", f"{examples}/article_scatter.toml", "--scatter", "--samples", "1000000"]
    cluster = None
    try:
        try:
            cluster = Cluster(folder)
        except AssertionError as problem:
            for log in sorted(folder.glob("*.log")) + sorted(folder.glob("*.out")):
                print(f"== {log.name}\n{log.read_text()[-2000:]}")
            skip(f"Slurm does not start here: {problem}")
        job = cluster("sbatch", "--parsable", f"--array=1-{SHARES}", script, SHARES,
                      folder / "shards", *study).strip()
        assert job, "sbatch refused the array"
        # Kill the first program that runs; the task fails, and is put into the queue again.
        killed = {}

        def kill_one():
            for line in cluster("squeue", "-h", "-r", "-t", "R", "-o", "%K").split():
                share = f"--shard {line}/{SHARES}"
                for pid in run("pgrep", "-f", "--", share, timeout=10).split() if subprocess.run(
                        ["pgrep", "-f", "--", share], capture_output=True).returncode == 0 else []:
                    try:
                        if os.readlink(f"/proc/{pid}/exe") == os.path.realpath(strainwave):
                            os.kill(int(pid), signal.SIGKILL)
                            killed["share"] = line
                            return True
                    except OSError:
                        continue
            return False

        wait_until(kill_one, 60, "a task runs")
        share = killed["share"]
        print(f"killed share {share}")
        wait_until(lambda: cluster("squeue", "-h", "-r", "-o", "%i").strip() == "", 300, "the array")
        made = sorted(path.name for path in (folder / "shards").glob("*.shard"))
        assert f"{share}.shard" not in made, "the killed task left a shard"
        assert len(made) == SHARES - 1, made
        assert not list((folder / "shards").glob("*.part")), "a temporary file is left"
        # Slurm forgets a finished job after five minutes; until then it can run the task again.  A
        # requeued task waits until its credential expires, cred_expire above.
        assert cluster("scontrol", "requeue", f"{job}_{share}") == ""
        wait_until(lambda: (folder / "shards" / f"{share}.shard").exists(), 120, "the requeued task")
        wait_until(lambda: cluster("squeue", "-h", "-r", "-o", "%i").strip() == "", 120, "the end")
        shards = sorted((folder / "shards").glob("*.shard"))
        assert len(shards) == SHARES, shards
        for format_ in ("text", "json", "csv"):
            merged = run(strainwave, "merge", *shards, "--format", format_)
            whole = run(strainwave, *study, "--format", format_)
            assert merged == whole, f"the merged {format_} differs from one run"
        print(f"{SHARES} shards of {sum(path.stat().st_size for path in shards)} bytes merged")
    finally:
        if cluster is not None:
            cluster.stop()
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
