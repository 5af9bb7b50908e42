"""--help and --version are answered by the programs themselves: help.py PROGRAM ...

Kokkos reads --help as well when it is given the command line, and prints its own options first.
"""

import pathlib
import subprocess
import sys


def main():
    failed = 0
    for program in sys.argv[1:]:
        name = pathlib.Path(program).name
        done = subprocess.run([program, "--help"], capture_output=True, text=True, check=False)
        good = done.returncode == 0 and done.stdout.startswith(name) and not done.stderr and "kokkos" not in done.stdout
        print(f"{'passed' if good else 'FAILED'}: {name} --help: {done.stdout.strip().splitlines()[:1]}")
        failed += not good
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
