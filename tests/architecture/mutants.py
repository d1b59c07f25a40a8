#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants small defects, one at a time, and sees whether a test notices: do the tests have teeth?

    mutants.py                  runs all mutants of the lists in mutants/; takes an hour or more
    mutants.py NAME...          those of the lists of these names, or with NAME in their own name
    mutants.py --list [NAME...]
    mutants.py --check-stale    only says which no longer fit the sources; ctest runs this

The tree is copied to build/mutants and built there, so that nothing planted can be left behind; what is
not committed is copied too. A mutant is killed if its test fails, survives if it passes. First each test
must pass without a defect. Exits with 1 if any mutant is not killed. A compiler cache is used if there is
one; TWINRAY_SCENES, the folder of the well-known scenes, if it is set.
"""
import argparse
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

from mutant import read_lists, stale

ROOT = Path(__file__).resolve().parents[2]
COPY = ROOT / "build" / "mutants"
BUILD = COPY / "build" / "release"
SECONDS = 300  # as long as ctest gives a test
BYTES = 6 << 30  # of address space: a defect may make a loop that allocates for ever


def environment():
    values = dict(os.environ)
    if shutil.which("ccache"):
        values.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache")
        values.setdefault("CCACHE_NOHASHDIR", "1")
        values["CCACHE_BASEDIR"] = str(COPY)
    return values


def run(command, seconds=None):
    """Whether a command succeeds in time, and what it wrote."""
    try:
        done = subprocess.run(command, cwd=COPY, env=environment(), timeout=seconds, text=True,
                              errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES)))
    except subprocess.TimeoutExpired:
        return False, f"no answer in {seconds} seconds"
    return done.returncode == 0, done.stdout


def copy_tree():
    """The files of the project; those that are the same keep their times, so that nothing is built again."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                            check=True, capture_output=True, text=True).stdout
    files = {name for name in listed.split("\0") if name and (ROOT / name).is_file()}
    for path in [path for path in COPY.rglob("*") if path.is_file()]:
        name = path.relative_to(COPY).as_posix()
        if not name.startswith("build/") and name not in files:
            path.unlink()
    for name in sorted(files):
        source, target = ROOT / name, COPY / name
        if target.is_file() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target)


def configure():
    scenes = os.environ.get("TWINRAY_SCENES", "")
    ok, text = run(["cmake", "--preset", "release", "-DTWINRAY_TESTS=ON", "-DTWINRAY_BENCH=ON",
                    "-DTWINRAY_UNITY=OFF", f"-DTWINRAY_SCENES={scenes}"])
    if not ok:
        sys.exit(text)


def build(targets, jobs):
    parallel = ["--parallel", str(jobs)] if jobs else []
    return run(["cmake", "--build", "build/release", "--target", *targets, *parallel])


def test_command(mutant):
    if not mutant.target.startswith("test_"):
        name = re.escape(mutant.test.rstrip("*")) + ("" if mutant.test.endswith("*") else "$")
        return ["ctest", "--test-dir", "build/release", "--no-tests=error", "--output-on-failure",
                "-R", f"^{name}"]
    program = BUILD / "tests" / mutant.target.split("_")[1] / mutant.target
    return [str(program), re.sub(r"([,\[\]\\])", r"\\\1", mutant.test)] if mutant.test else [str(program)]


def failing_baseline(mutants, jobs):
    """The tests that fail, or that do not build, without any defect."""
    ok, text = build(sorted({mutant.target for mutant in mutants}), jobs)
    if not ok:
        sys.exit(f"the tree does not build:\n{text[-4000:]}")
    tests = {tuple(test_command(mutant)): mutant for mutant in mutants}
    for command, mutant in tests.items():
        ok, text = run(command, SECONDS)
        if not ok or "No test cases matched" in text:
            yield f"{mutant.target}, {mutant.test or 'all tests'}:\n{text[-2000:]}"


def verdict(mutant, jobs):
    """Plants one defect, looks for a test that fails, and takes the defect out again."""
    path = COPY / mutant.file
    text = path.read_text(encoding="utf-8")
    path.write_text(mutant.applied_to(text), encoding="utf-8")
    try:
        built, output = build([mutant.target], jobs)
        if not built:
            return "did not build", output[-2000:]
        passed, output = run(test_command(mutant), SECONDS)
        return ("SURVIVED", "") if passed else ("killed", output)
    finally:
        path.write_text(text, encoding="utf-8")


def run_all(mutants, jobs, verbose):
    copy_tree()
    configure()
    if failing := list(failing_baseline(mutants, jobs)):
        sys.exit("these tests fail without any defect:\n" + "\n".join(failing))
    counts = Counter()
    for number, mutant in enumerate(mutants, 1):
        start = time.monotonic()
        result, output = verdict(mutant, jobs)
        counts[result] += 1
        seconds = time.monotonic() - start
        print(f"{number}/{len(mutants)} {result:<14}{seconds:5.0f} s  {mutant.file}: {mutant.name}",
              flush=True)
        if verbose or result == "did not build":
            print(output)
    print(", ".join(f"{count} {result}" for result, count in sorted(counts.items())))
    return 0 if set(counts) <= {"killed"} else 1


def chosen(lists, names):
    """The mutants of the lists of these names, or with one of them in their own name; all without names."""
    for name in names:
        if name not in lists and not any(name in mutant.name for list_ in lists.values() for mutant in list_):
            sys.exit(f"no list and no mutant is called {name}; the lists: {', '.join(lists)}")
    return [mutant for list_name, list_ in lists.items() for mutant in list_
            if not names or any(name == list_name or name in mutant.name for name in names)]


def show(mutants):
    for mutant in mutants:
        print(f"{mutant.file}: {mutant.name}")
        test = mutant.test or mutant.target
        print(f"    {'equivalent: ' + mutant.equivalent if mutant.equivalent else test}")
    print(f"{len(mutants)} mutants")


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--list", action="store_true", help="show them, with the test that kills each")
    parser.add_argument("--check-stale", action="store_true", help="do they still fit the sources?")
    parser.add_argument("--jobs", type=int, default=0, help="how many files are compiled at once")
    parser.add_argument("--verbose", action="store_true", help="show what the failing tests say")
    options = parser.parse_args(arguments)
    mutants = chosen(read_lists(), options.names)
    if options.list:
        return show(mutants)
    found = list(stale(ROOT, mutants))
    if found or options.check_stale:
        print("\n".join(found) if found else f"{len(mutants)} mutants fit the sources")
        return 1 if found else 0
    return run_all([mutant for mutant in mutants if not mutant.equivalent], options.jobs, options.verbose)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
