"""drivers/run refuses what cannot work before it builds anything, says what to do, and never installs in silence."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import house

RUN = house.ROOT / "drivers" / "run"


def run(*arguments, path_first=None):
    environment = dict(os.environ)
    if path_first:
        environment["PATH"] = f"{path_first}:{environment['PATH']}"
    return subprocess.run([RUN, *arguments], capture_output=True, text=True, check=False, env=environment,
                          cwd=tempfile.gettempdir())


class RunRefuses(unittest.TestCase):
    def refused(self, done, code, *words):
        self.assertEqual(done.returncode, code, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertNotIn("Configuring", done.stdout)

    def test_a_scene_that_is_not_there(self):
        self.refused(run("no_such_scene.xml"), 2, "scene = no_such_scene.xml", "those of Voussoir are")

    def test_no_scene_and_two_scenes(self):
        self.refused(run(), 2, "no scene given")
        self.refused(run("a.xml", "b.xml"), 2, "two scenes given, a.xml and b.xml")

    def test_ranks_that_are_no_count(self):
        for ranks in ("0", "-1", "two", "1.5"):
            self.refused(run("a.xml", "--ranks", ranks), 2, f"--ranks = {ranks}", "whole number")

    def test_an_option_without_its_value(self):
        self.refused(run("a.xml", "--set"), 2, "--set needs a value")

    def test_help_is_no_error(self):
        done = run("--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("--ranks N", done.stdout)


class ReadOnly(unittest.TestCase):
    def test_a_build_that_cannot_be_written_to_is_run_as_it_is(self):
        # Root may write anywhere, so that another user has to ask.
        other = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"] if os.getuid() == 0 else []
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            built = root / "build" / "release" / "drivers" / "voussoir"
            built.parent.mkdir(parents=True)
            built.write_text("#!/bin/sh\n")
            shutil.copy(house.ROOT / "cmake" / "setup.sh", root)
            for path in (built, root / "setup.sh", *built.parents[:4]):
                path.chmod(0o555)
            done = subprocess.run([*other, "bash", "-c", "set -euo pipefail; voussoir_root=$1; . $1/setup.sh; "
                                   "configure_and_build voussoir_program; echo went on", "bash", folder],
                                  capture_output=True, text=True, check=False, env={"PATH": os.environ["PATH"]}, cwd="/")
            for path in built.parents[:4]:
                path.chmod(0o755)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Not built anew", done.stdout)
        self.assertIn("went on", done.stdout)

    def test_help_names_limit_analysis_and_the_time(self):
        for option in ("--limit-analysis", "--at-most TIME"):
            self.assertIn(option, run("--help").stdout)


class MissingPackages(unittest.TestCase):
    def test_are_named_with_the_command_that_installs_them(self):
        # dpkg knows all but two packages, and neither apt-get nor sudo can do anything, as on a machine without network.
        stubs = {"dpkg-query": "for p in \"$@\"; do case $p in libgmsh-dev|libmetis-dev|-*|*{*) ;; "
                               "*) echo \"$p installed\" ;; esac; done",
                 "apt-get": "exit 100", "sudo": "exit 1"}
        with tempfile.TemporaryDirectory() as folder:
            for name, body in stubs.items():
                stub = pathlib.Path(folder) / name
                stub.write_text(f"#!/bin/sh\n{body}\n")
                stub.chmod(0o755)
            done = run("--print-parameters", path_first=folder)
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertIn("apt-get install -y --no-install-recommends libgmsh-dev libmetis-dev\n", done.stderr)


if __name__ == "__main__":
    unittest.main()
