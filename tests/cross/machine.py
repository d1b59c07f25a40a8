# SPDX-License-Identifier: Apache-2.0
"""The two processors of cross_machine.py: a folder of files each, and how a program is run there."""
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path


class Failed(Exception):
    """A program did not end as it should; the text says which and what it said."""


class Machine:
    """Programs of one build, which read and write in a folder of their own; `emulator` comes before each."""

    def __init__(self, name, build, folder, emulator=()):
        self.name, self.build, self.emulator = name, Path(build), tuple(emulator)
        self.folder = Path(folder) / name
        self.folder.mkdir()

    def file(self, name):
        return self.folder / name

    def command(self, program, words):
        return [*self.emulator, str(self.build / program), *map(str, words)]

    def start(self, program, *words, environment=None):
        return subprocess.Popen(self.command(program, words), cwd=self.folder, text=True, errors="replace",
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                env={**os.environ, **(environment or {})})

    def run(self, program, *words, environment=None):
        """What the program says. Throws Failed where it does not end with 0."""
        process = self.start(program, *words, environment=environment)
        said, _ = process.communicate()
        if process.returncode != 0:
            command = " ".join(map(str, (program, *words)))
            raise Failed(f"{command} ended with {process.returncode} on {self.name}:\n{said[-3000:]}")
        return said

    def twinray(self, *words, environment=None):
        return self.run("cli/twinray", *words, environment=environment)

    def sums(self, film):
        """The hash of all sums, with which a film file ends."""
        return self.file(film).read_bytes()[-8:]

    def stop_after_checkpoint(self, checkpoint, *words):
        """Renders until there is a checkpoint, then asks the program to end; its exit code."""
        process = self.start("cli/twinray", *words)
        while process.poll() is None and not self.file(checkpoint).exists():
            time.sleep(0.05)
        if process.poll() is None:
            process.send_signal(signal.SIGTERM)
        process.communicate()
        return process.returncode


class Bench:
    """Both machines and the scenes."""

    def __init__(self, builds, sysroot, scenes, folder):
        self.x86 = Machine("x86-64", builds[0], folder)
        self.arm = Machine("aarch64", builds[1], folder, ("qemu-aarch64-static", "-L", sysroot))
        self.scenes = Path(scenes)

    def both(self):
        return self.x86, self.arm

    def scene(self, name):
        return self.scenes / name

    @staticmethod
    def copy(name, source, target):
        shutil.copy(source.file(name), target.file(name))
