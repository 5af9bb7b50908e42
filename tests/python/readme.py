"""The examples of python/README.md run as they stand there, and the package can be installed.

    readme.py PROGRAM MPIEXEC
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import sweeps  # noqa: E402

PYTHON = sweeps.ROOT / "python"


class Readme(sweeps.SweepTest):
    def test_its_examples_run(self):
        text = (PYTHON / "README.md").read_text(encoding="utf-8")
        examples = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        self.assertGreater(len(examples), 5)
        (self.folder / "examples.py").write_text("\n".join(examples), encoding="utf-8")
        done = subprocess.run([sys.executable, "-B", "examples.py"], cwd=self.folder, capture_output=True, text=True, check=False,
                              env=sweeps.environment(PYTHONPATH=str(PYTHON)))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn('did you mean "friction coefficient"?', done.stdout)
        self.assertIn("moved by at most 1.0 mm", done.stdout)

    @unittest.skipUnless(shutil.which("pip3"), "pip is not installed")
    def test_the_package_installs(self):
        shutil.copytree(PYTHON, self.folder / "python", ignore=shutil.ignore_patterns("__pycache__"))  # pip builds in the folder
        done = subprocess.run(["/usr/bin/python3", "-m", "pip", "install", "--quiet", "--no-build-isolation", "--no-deps", "--no-index",
                               "--target", str(self.folder / "installed"), str(self.folder / "python")],
                              capture_output=True, text=True, check=False)
        if "setuptools" in done.stderr and "No module" in done.stderr:
            self.skipTest("setuptools is not installed")
        self.assertEqual(done.returncode, 0, done.stderr)
        code = "import voussoir; print(voussoir.__file__, len(voussoir.Scene('s').keys()))"
        done = subprocess.run([sys.executable, "-B", "-c", code], cwd=self.folder / "installed", capture_output=True, text=True, check=False,
                              env={**sweeps.environment(), "PYTHONPATH": str(self.folder / "installed")})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith(str(self.folder / "installed" / "voussoir")), done.stdout)

    def test_it_has_the_version_of_the_program(self):
        said = subprocess.run([os.fspath(program.PROGRAM), "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
        self.assertIn(f'version = "{said}"', (PYTHON / "pyproject.toml").read_text(encoding="utf-8"))


if __name__ == "__main__":
    program.main()
