"""Measures solve_counts.csv: what scenes cost under every kernel of OpenBLAS that this processor can run.

usage: count_ranges.py PROGRAM TEST_SOLVE_COUNTS TEST_DEAR_SOLVE_COUNTS > tests/performance/solve_counts.csv

A count whose most is more than twice its least, by more than ten, is one that jumps.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))
from kernels import kernels


def counts(tests, kernel):
    """Per scene its four counts."""
    return {scene: values for test in tests for scene, values in counts_of(test, kernel).items()}


def counts_of(test, kernel):
    with tempfile.TemporaryDirectory() as folder:
        said = subprocess.run([test, "--details=ALL"], env={**os.environ, "OPENBLAS_CORETYPE": kernel}, cwd=folder,
                              capture_output=True, text=True, check=False).stdout
    lines = [line.strip().removeprefix("counted: ") for line in said.splitlines() if line.strip().startswith("counted: ")]
    return {scene: [int(n) for n in rest] for scene, *rest in (line.split(",") for line in lines)}


def told(values):
    least, most = min(values), max(values)
    if least == most:
        return str(least)
    return f"{'~' if most - 2 * least > 10 else ''}{least}-{most}"


if __name__ == "__main__":
    able = [name for name, why in kernels(sys.argv[1]).items() if not why]
    per_kernel = [counts(sys.argv[2:], kernel) for kernel in able]
    print(f"# Least-most over the kernels {', '.join(able)} of OpenBLAS; ~ before a range that jumps from one to the next.")
    print("scene,solves,krylov,whole,patches")
    for scene in per_kernel[0]:
        print(",".join([scene, *(told([table[scene][i] for table in per_kernel]) for i in range(4))]))
