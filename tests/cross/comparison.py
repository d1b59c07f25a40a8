# SPDX-License-Identifier: Apache-2.0
"""One case of cross_machine.py: what two machines made, compared bit for bit."""
from machine import Failed


def case(title, compare, *arguments):
    """The title, and what differs or fails: nothing where all is well."""
    try:
        return title, compare(*arguments)
    except Failed as failed:
        return title, str(failed)


def passes(title, run, *words):
    """The case of a program that compares by itself: run(*words) must end with 0."""
    def compare():
        run(*words)
        return ""
    return case(title, compare)


def difference_of_films(left, right, name):
    return "" if left.sums(name) == right.sums(name) else "the films have other sums"


def difference_of_files(left, right, name):
    return "" if left.file(name).read_bytes() == right.file(name).read_bytes() else f"{name} has other bytes"


def same_file(title, bench, words, name):
    """The case of a file that both write by the same words."""
    def compare():
        for machine in bench.both():
            machine.twinray(*words, "-o", name)
        return difference_of_files(*bench.both(), name)
    return case(title, compare)
