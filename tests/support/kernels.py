"""Kernels of OpenBLAS that this processor can run: each rounds sums in its own way, so they stand for other processors.

usage: kernels.py PROGRAM [COUNT]

Prints "run NAME", "own NAME" or "skip NAME: why" for each, a line for COUNT of them at most, spread from the oldest to the
newest; own is the one that the program takes here by itself. What a program takes is asked of OpenBLAS, which says so under
OPENBLAS_VERBOSE=2; it does not ask whether the processor has the instructions, so that is looked up in /proc/cpuinfo.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

# The instructions that the code of a kernel is compiled for, as Linux names them.
AVX2 = {"avx", "avx2", "fma"}
AVX512 = AVX2 | {"avx512f", "avx512bw", "avx512dq", "avx512vl", "avx512cd"}
NEEDS = {
    "Prescott": {"pni"},
    "Nehalem": {"pni", "sse4_2"},
    "Sandybridge": {"avx"},
    "Haswell": AVX2,
    "Zen": AVX2,
    "SkylakeX": AVX512,
    "Cooperlake": AVX512 | {"avx512_bf16"},
}


def flags_of_processor():
    found = re.search(r"^flags\s*:(.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return set(found[1].split()) if found else set()


def taken(program, kernel=None):
    """The kernel that a program takes when asked for one, or by itself; None where its BLAS is not OpenBLAS."""
    env = {**os.environ, "OPENBLAS_VERBOSE": "2"}
    if kernel:
        env["OPENBLAS_CORETYPE"] = kernel
    said = subprocess.run([program, "--version"], env=env, capture_output=True, text=True, timeout=60, check=False)
    found = re.search(r"^Core: (\S+)", said.stdout + said.stderr, re.MULTILINE)
    return found[1] if found else None


def kernels(program):
    """Per kernel why it cannot be run; "" where it can."""
    flags, why = flags_of_processor(), {}
    for name, needs in NEEDS.items():
        if needs - flags:
            why[name] = "the processor lacks " + " ".join(sorted(needs - flags))
            continue
        core = taken(program, name)
        why[name] = "" if core == name else f"OpenBLAS takes {core}" if core else "the BLAS is not OpenBLAS"
    return why


def spread(names, count):
    if count >= len(names):
        return names
    if count < 2:
        return names[:count]
    return [names[round(i * (len(names) - 1) / (count - 1))] for i in range(count)]


if __name__ == "__main__":
    known = kernels(sys.argv[1])
    able = [name for name, why in known.items() if not why]
    chosen = spread(able, int(sys.argv[2])) if len(sys.argv) > 2 else able
    for name, why in known.items():
        if why:
            print(f"skip {name}: {why}")
    own = taken(sys.argv[1])
    for name in chosen:
        print("own" if name == own else "run", name)
