"""Viewers of others, asked what they make of our files."""

import pathlib
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent


def in_paraview(folder):
    """Words of ParaView's own reader (in_paraview.py), which fails where a number is another; why it was not asked, where it is not
    installed."""
    program = shutil.which("pvpython")
    if not program:
        return "ParaView is not installed (Debian's packages paraview and python3-paraview): its reader is not asked."
    done = subprocess.run([program, HERE / "in_paraview.py", folder], capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode == 0 and done.stdout.startswith("agrees: "), done.stdout + done.stderr
    return done.stdout.strip()
