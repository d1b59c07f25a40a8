#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""readme_commands.py sees every command, runs it word for word, and fails where it fails."""
import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import readme_commands

README = """# twinray
```sh
git clone https://example.org/twinray
./run render a.dae -o a.png   # a comment
cat a.png \\
  b.png
# not a command
./run render "$TWINRAY_SCENES/cow.dae" -o cow.png
./run test
```
```
not a command either
```
"""
RUN = """#!/usr/bin/env bash
[[ $1 == render && -e $2 ]] && echo "$2" >"$4" && echo b >b.png
"""


class ReadmeCommands(unittest.TestCase):
    def checkout(self, folder, readme):
        root = Path(folder)
        (root / "README.md").write_text(readme, encoding="utf-8")
        (root / "a.dae").write_text("a")
        (root / "run").write_text(RUN)
        (root / "run").chmod(0o755)
        return root

    def outcome(self, readme, which="run"):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as output:
            root = self.checkout(folder, readme)
            result = readme_commands.main([str(root), which])
            left = sorted(path.name for path in root.iterdir())
        self.assertEqual(left, ["README.md", "a.dae", "run"])
        return result, output.getvalue()

    def test_commands_are_those_of_sh_blocks(self):
        found = [readme_commands.treatment(command) for command in readme_commands.commands(README)]
        self.assertEqual(found, ["the checkout itself", "run", "run", "scenes", "it is what runs this test"])

    def test_commands_run_in_order_and_leave_nothing_behind(self):
        result, output = self.outcome(README)
        self.assertEqual(result, 0, output)
        self.assertEqual(len(output.splitlines()), 2)

    def test_a_command_that_fails_is_shown(self):
        result, output = self.outcome(README.replace("a.dae", "missing.dae"))
        self.assertEqual(result, 1)
        self.assertIn("README.md's command ended with 1", output)

    def test_commands_that_need_scenes_run_on_their_own(self):
        result, output = self.outcome(README, "scenes")  # the folder is not there: the command must fail
        self.assertEqual(result, 1)
        self.assertIn("cow.dae", output)


if __name__ == "__main__":
    unittest.main()
