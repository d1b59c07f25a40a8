# SPDX-License-Identifier: Apache-2.0
"""Runs a command and writes what it took: started.py FILE COMMAND...

Linux keeps the largest size that a process had before it became the command, which is its parent's. So the
parent of what is measured is this small program, not the one that holds all pictures.
"""
import json
import os
import sys


def main(file, *command):
    try:
        child = os.posix_spawnp(command[0], command, os.environ)
    except OSError as error:
        sys.exit(f"{command[0]}: it cannot be started: {error.strerror}")
    _, status, usage = os.wait4(child, 0)
    with open(file, "w", encoding="utf-8") as output:
        seconds = usage.ru_utime + usage.ru_stime
        json.dump([os.waitstatus_to_exitcode(status), seconds, usage.ru_maxrss], output)


if __name__ == "__main__":
    main(*sys.argv[1:])
