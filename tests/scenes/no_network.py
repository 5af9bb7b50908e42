"""A machine without any network interface, as a sandbox is: one rank runs, several are refused with words.

usage: no_network.py PROGRAM MPIEXEC

Set-up    The program and drivers/run in a network of their own in which nothing is up, by unshare of util-linux.
Expected  A run on one rank reaches equilibrium; drivers/run says why it takes one rank, and refuses two with the remedy.
"""

import os
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import program  # noqa: E402  (a folder of its own)

ALONE = ["unshare", "--net"] if os.geteuid() == 0 else ["unshare", "--map-root-user", "--net"]
SCENE = ROOT / "xml" / "arch.xml"


def can_be_alone():
    try:
        return subprocess.run([*ALONE, "true"], capture_output=True, check=False).returncode == 0
    except FileNotFoundError:
        return False


@unittest.skipUnless(can_be_alone(), "unshare may not make a network here")
class NoNetwork(program.SceneTest):
    def run_alone(self, *command):
        environment = {**os.environ, **program.ENVIRONMENT, "VOUSSOIR_PROGRAM": str(program.PROGRAM)}
        return subprocess.run([*ALONE, *command], capture_output=True, text=True, check=False, timeout=120, env=environment,
                              stdin=subprocess.DEVNULL)

    def test_one_rank_runs(self):
        done = self.run_alone(program.PROGRAM, f"--xml={SCENE}", f"--out={self.folder / 'out'}")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("Equilibrium under all loads", done.stdout)

    def test_several_are_refused_and_one_is_taken_where_none_were_asked_for(self):
        done = self.run_alone(ROOT / "drivers" / "run", SCENE, "--ranks", "2", "--out", self.folder / "two")
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertIn("not even the loopback", done.stderr)
        self.assertIn("--ranks 1", done.stderr)
        done = self.run_alone(ROOT / "drivers" / "run", SCENE, "--validate", "--ranks", "1", "--out", self.folder / "one")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    program.main()
