#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Unpacks Debian's packages for another processor into a folder, without a change to this system.

sysroot.py ARCHITECTURE FOLDER PACKAGE...

FOLDER/sysroot gets the packages and all that they depend on; nothing of them is run. apt works in a world of
its own, FOLDER/apt, in which that processor is the only one and no package is installed. Its sources and keys
are those of this system, which must be a Debian that serves both processors from the same place. Nothing is
done where the sysroot holds these packages already.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

# What the scripts of packages would link: the plain versions of what has several.
ALTERNATIVES = ("blas/libblas.so.3", "lapack/liblapack.so.3")


def run(*words, environment=None):
    subprocess.run(words, check=True, env={**os.environ, **(environment or {})})


def apt_configuration(folder, architecture):
    """The file that makes apt work below the folder, as the value of APT_CONFIG."""
    for name in ("state/lists/partial", "cache/archives/partial"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    (folder / "state/status").touch()
    file = folder / "apt.conf"
    file.write_text(f"""APT::Architecture "{architecture}";
APT::Architectures {{ "{architecture}"; }};
APT::Install-Recommends "false";
APT::Sandbox::User "root";
Dir::State "{folder}/state";
Dir::State::status "{folder}/state/status";
Dir::Cache "{folder}/cache";
""")
    return {"APT_CONFIG": str(file)}


def download(folder, architecture, packages):
    """The archives of the packages and of all that they depend on."""
    apt = apt_configuration(folder, architecture)
    run("apt-get", "-q", "update", environment=apt)
    run("apt-get", "-qy", "--download-only", "install", *packages, environment=apt)
    return sorted((folder / "cache/archives").glob("*.deb"))


def make_links_relative(sysroot):
    """A link to /usr/lib/... means this system's; it must mean the sysroot's."""
    for path in sysroot.rglob("*"):
        if path.is_symlink() and (target := os.readlink(path)).startswith("/"):
            path.unlink()
            path.symlink_to(os.path.relpath(sysroot / target[1:], path.parent))


def move_cmake_files(sysroot):
    """Some packages' CMake files name /usr, and not where they are found, as the place of their libraries."""
    for file in sysroot.glob("usr/lib/*/cmake/**/*.cmake"):
        text = file.read_text()
        moved = re.sub(r'(?<=[";:])/usr(?=[/"])', f"{sysroot}/usr", text)
        if moved != text:
            file.write_text(moved)


def link_alternatives(sysroot):
    for name in ALTERNATIVES:
        for file in sysroot.glob(f"usr/lib/*/{name}"):
            link = file.parents[1] / file.name
            if not link.is_symlink():
                link.symlink_to(file.relative_to(link.parent))


def main(arguments):
    if len(arguments) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    architecture, folder, packages = arguments[0], Path(arguments[1]).resolve(), arguments[2:]
    wanted, stamp = " ".join([architecture, *packages]) + "\n", folder / "packages"
    if stamp.is_file() and stamp.read_text() == wanted:
        return 0
    stamp.unlink(missing_ok=True)
    sysroot, apt = folder / "sysroot", folder / "apt"
    for old in (sysroot, apt):
        shutil.rmtree(old, ignore_errors=True)
    sysroot.mkdir(parents=True)
    for archive in download(apt, architecture, packages):
        run("dpkg-deb", "--extract", archive, sysroot)
    make_links_relative(sysroot)
    link_alternatives(sysroot)
    move_cmake_files(sysroot)
    shutil.rmtree(apt)
    stamp.write_text(wanted)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
