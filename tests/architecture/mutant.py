# SPDX-License-Identifier: Apache-2.0
"""A mutant: one small planted defect, with the test that must notice it. The lists stand in mutants/."""
import re
import runpy
from dataclasses import dataclass
from pathlib import Path

LISTS = Path(__file__).resolve().parent / "mutants"


@dataclass(frozen=True)
class Mutant:
    """`old` in `file` is replaced by `new`; then `test`, which `target` builds, must fail.

    name: a sentence that says what is wrong.
    old: stands in the file exactly once.
    target: a target of CMake; of a test_... the test is run, of another one the test of ctest.
    test: the whole name of one test case or, with * at its end, how its name begins; nothing for all of
        the target's.
    equivalent: why no test can fail; such a mutant is kept to be read, and not run.
    """
    name: str
    file: str
    old: str
    new: str
    target: str
    test: str = ""
    equivalent: str = ""

    def applied_to(self, text):
        """The text with the defect; an error where `old` does not stand in it exactly once."""
        count = text.count(self.old)
        if count != 1:
            raise ValueError(f"{self.file} holds its old text {count} times")
        return text.replace(self.old, self.new)


def read_lists(folder=LISTS):
    """Name of the list -> its mutants."""
    return {path.stem: runpy.run_path(str(path))["MUTANTS"] for path in sorted(folder.glob("*.py"))}


def test_names(root):
    """All that stands in the tests' sources, with string literals joined as a compiler does."""
    files = [path for path in (root / "tests").rglob("*") if path.name.endswith(("_test.cpp", "_check.cpp"))]
    files += (root / "tests").rglob("CMakeLists.txt")
    text = "\n".join(path.read_text(encoding="utf-8") for path in files)
    return re.sub(r'"\s*"', "", text)


def stale(root, mutants):
    """Why mutants can no longer be run, a line each."""
    names = test_names(root)
    seen = set()
    for mutant in mutants:
        if mutant.name in seen:
            yield f"{mutant.name}: two mutants have this name"
        seen.add(mutant.name)
        if mutant.old == mutant.new:
            yield f"{mutant.name}: it changes nothing"
        try:
            mutant.applied_to((root / mutant.file).read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            yield f"{mutant.name}: {error}"
        exact = not mutant.test.endswith("*")
        if mutant.test and f'"{mutant.test.rstrip("*")}' + '"' * exact not in names:
            yield f"{mutant.name}: there is no test \"{mutant.test}\""
