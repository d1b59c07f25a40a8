#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs what README.md tells its readers to type.

readme_commands.py ROOT run     every command of a ```sh block, word for word, that needs no folder of scenes
readme_commands.py ROOT scenes  those that name $TWINRAY_SCENES
readme_commands.py ROOT list    how each command is treated

The commands run in the order of the file in one temporary folder, in which every entry of ROOT is a link: so
relative paths hold, and what a command writes is thrown away with the folder. The first that fails ends it.
"""
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

# Commands that are not run here, and what stands for them.
ELSEWHERE = (
    (r"git clone\b|cd\b", "the checkout itself"),
    (r"(sudo )?apt(-get)? ", "run installs the packages"),
    (r"\./run test$", "it is what runs this test"),
    (r"\./run bench\b", "the tests run every benchmark for an instant"),
    (r"\./run study\b", "the tests make a study of small scenes"),
    (r"\./run peers\b", "the peers are outside of the project; the tests run it with stand-ins"),
    (r"\./run format\b", "it writes the source files"),
    (r"cmake --install\b", "the test of an installed twinray"),
    (r"cmake --(preset|build)\b|ctest --preset\b", "run builds and tests by presets"),
)
SECONDS = 240


def commands(readme):
    """The commands of all ```sh blocks; a backslash at the end of a line joins the next one."""
    for block in re.findall(r"^```sh\n(.*?)^```", readme, re.MULTILINE | re.DOTALL):
        for line in block.replace("\\\n", " ").splitlines():
            if line.strip() and not line.lstrip().startswith("#"):
                yield line.strip()


def treatment(command):
    """"run", "scenes", or why the command is not run here."""
    for pattern, reason in ELSEWHERE:
        if re.match(pattern, re.sub(r"\s+#.*", "", command)):
            return reason
    return "scenes" if "TWINRAY_SCENES" in command else "run"


def run_in_order(root, chosen):
    with tempfile.TemporaryDirectory() as folder:
        for entry in root.iterdir():
            if entry.name != ".git":
                os.symlink(entry, Path(folder, entry.name))
        for command in chosen:
            start = time.monotonic()
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", command], cwd=folder, text=True,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  timeout=SECONDS, check=False)
            print(f"{time.monotonic() - start:6.1f} s  {command}", flush=True)
            if done.returncode != 0:
                print(f"README.md's command ended with {done.returncode}:\n{done.stdout}")
                return 1
    return 0


def main(arguments):
    if len(arguments) != 2 or arguments[1] not in ("run", "scenes", "list"):
        print(__doc__, file=sys.stderr)
        return 2
    root = Path(arguments[0]).resolve()
    found = list(commands((root / "README.md").read_text(encoding="utf-8")))
    if arguments[1] == "list":
        print("\n".join(f"{command}\n    {treatment(command)}" for command in found))
        return 0
    return run_in_order(root, [command for command in found if treatment(command) == arguments[1]])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
