"""--help is answered, and what is no option refused, by the programs themselves: help.py PROGRAM ...

Kokkos reads --help as well when it is given the command line, and prints its own options first.
"""

import pathlib
import subprocess
import sys


def run(program, option):
    return subprocess.run([program, option], capture_output=True, text=True, check=False)


def main():
    failed = 0
    for program in sys.argv[1:]:
        name = pathlib.Path(program).name
        done = run(program, "--help")
        good = done.returncode == 0 and done.stdout.startswith(name) and not done.stderr and "kokkos" not in done.stdout
        print(f"{'passed' if good else 'FAILED'}: {name} --help: {done.stdout.strip().splitlines()[:1]}")
        failed += not good
        refused = run(program, "--hepl")
        wanted = f"{name}: '--hepl' is no option (did you mean \"--help\"?).\n  See {name} --help.\n"
        good = refused.returncode == 2 and refused.stderr == wanted and not refused.stdout
        print(f"{'passed' if good else 'FAILED'}: {name} --hepl: {refused.stderr.strip().splitlines()[:1]}")
        failed += not good
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
