#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders a picture by a plan, on a real Slurm and by Open Job Description, and compares it with one run's.

farm_test.py PROGRAM SCENE [OPENJD]

Slurm has two nodes on this machine, started here and stopped after. Of eight parts one is queued again, one
is told that its time is over, a node loses those that it renders (its daemon and all its processes get
SIGKILL), and some make room for an urgent job. Another job is cancelled and must not come back. OPENJD is the
program of PyPI's openjd-cli; without it that part is left out, and says so.
"""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import slurm_cluster

PARTS = 8
PROGRAM = "twinray"
# On Slurm a part takes some seconds, or as long as it is held where it is.
SIZE, SAMPLES, FEW_SAMPLES = ["-r", "320", "240"], 500, 24


def run(*words, cwd, environment=None):
    done = subprocess.run(words, cwd=cwd, text=True, check=False, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**os.environ, **(environment or {})})
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, words))} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def render_alone(program, scene, folder, samples):
    run(program, "render", scene, *SIZE, "-s", str(samples), "-q", "-o", "alone.pfm", cwd=folder)
    return (folder / "alone.pfm").read_bytes()


def make_plan(program, scene, folder, name, samples):
    run(program, "plan", scene, *SIZE, "-s", str(samples), "--checkpoint-seconds=0.5", f"--folder={name}",
        f"--jobs={PARTS}", f"--output={name}.pfm", cwd=folder)


def running(tasks):
    """The numbers of those that render."""
    return [number for number, task in tasks.items() if task["JobState"] == "RUNNING"]


def restarts(cluster, job, number):
    return int(cluster.tasks(job).get(number, {}).get("Restarts", "0"))


def freeze_begun(cluster, job, folder):
    """Holds each task that has a checkpoint where it is, however fast the machine is; how many there are."""
    begun = [number for number in running(cluster.tasks(job))
             if list((folder / "slurm/parts").glob(f"*{number:05}.checkpoint"))]
    return sum(cluster.freeze(number, PROGRAM) for number in begun)


def disturb(cluster, job, folder):
    """Each kind of disturbance, and the numbers of the tasks that it met."""
    last = PARTS - 1
    cluster.run("scontrol", "hold", f"{job}_{last}")
    cluster.wait(lambda: freeze_begun(cluster, job, folder) == 4, "four parts are rendered at once")
    tasks = cluster.tasks(job)
    first, second = [number for number in running(tasks) if tasks[number]["NodeList"] == "node1"]
    lost = [number for number in running(tasks) if tasks[number]["NodeList"] == "node2"]
    cluster.run("scontrol", "requeue", f"{job}_{first}")
    cluster.end_time_of(tasks[second]["JobId"])
    cluster.thaw(second, PROGRAM)
    for number in (first, second):
        cluster.wait(lambda: restarts(cluster, job, number) > 0, f"task {number} is queued again")
    cluster.kill_node("node2")
    cluster.wait(lambda: all(restarts(cluster, job, number) > 0 for number in lost),
                 "lost tasks are queued again")
    cluster.run("slurmd", "-N", "node2")
    cluster.run("scontrol", "release", f"{job}_{last}")
    cluster.wait(lambda: cluster.freeze(last, PROGRAM), "the last part is begun")
    before = {number: restarts(cluster, job, number) for number in range(PARTS)}
    cluster.run("sbatch", "--partition=urgent", "--nodes=2", "--exclusive", "--wrap=sleep 1",
                "--output=/dev/null")
    cluster.wait(lambda: restarts(cluster, job, last) > before[last], "a task made room")
    moved = [n for n in range(PARTS) if restarts(cluster, job, n) > before[n]]
    return {"queued again": [first], "out of time": [second], "lost": lost, "made room": moved}


def cancel(cluster, folder):
    """A job that is cancelled keeps its checkpoints, and does not come back."""
    job = cluster.run(str(folder / "cancelled/slurm/submit"), "--time=30").split()[2].strip(";")
    cluster.wait(lambda: len(running(cluster.tasks(job))) > 1, "parts are rendered")
    cluster.wait(lambda: list((folder / "cancelled/parts").glob("*.checkpoint")), "a checkpoint is written")
    cluster.run("scancel", job)
    cluster.wait(lambda: not running(cluster.tasks(job)), "no part is rendered any more")
    time.sleep(10)
    states = {task["JobState"] for task in cluster.tasks(job).values()}
    if states - {"CANCELLED"} or not list((folder / "cancelled/parts").glob("*.checkpoint")):
        raise RuntimeError(f"after scancel tasks are {states}, or no checkpoint is left")


def render_on_slurm(folder):
    with tempfile.TemporaryDirectory() as place, slurm_cluster.Cluster(place) as cluster:
        said = cluster.run(str(folder / "slurm/slurm/submit"), "--time=30", "--cpus-per-task=1")
        job, merging = (word.strip(";") for word in said.split() if word.strip(";").isdigit())
        disturbed = disturb(cluster, job, folder)
        cluster.wait((folder / "slurm.pfm").exists, "the parts are merged", 300)
        cluster.wait(lambda: "RUNNING" not in cluster.run("scontrol", "show", "job", merging, check=False),
                     "the merge has ended")
        cancel(cluster, folder)
    disturbed["cancelled"] = "a job"
    print("Slurm:", "; ".join(f"{what}: {tasks}" for what, tasks in disturbed.items()))


def main(arguments):
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    program, scene = (str(Path(word).resolve()) for word in arguments[:2])
    expected = {}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o755)
        if reason := slurm_cluster.missing():
            print(f"Slurm: not tried: {reason}")
        else:
            expected["slurm"] = render_alone(program, scene, folder, SAMPLES)
            make_plan(program, scene, folder, "slurm", SAMPLES)
            make_plan(program, scene, folder, "cancelled", 10 * SAMPLES)  # No part ends in time.
            render_on_slurm(folder)
        if len(arguments) < 3:
            print("Open Job Description: not tried: PyPI's openjd-cli is not there")
        else:
            expected["openjd"] = render_alone(program, scene, folder, FEW_SAMPLES)
            make_plan(program, scene, folder, "openjd", FEW_SAMPLES)
            run(arguments[2], "run", "openjd/openjd/template.json", cwd=folder)
        for name, picture in expected.items():
            if (folder / f"{name}.pfm").read_bytes() != picture:
                print(f"{name}: the picture has other bits than that of one run")
                return 1
            print(f"{name}: {PARTS} parts have the bits of one run")
    return 0 if expected else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
