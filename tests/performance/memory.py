"""What a block takes at the peak of a load step: between a wall of 32 and one of 96 courses, so that the libraries, which
are the same in both, do not count.

    memory.py PROGRAM WALL.xml

Bonded with the estimate of its error, one system in which every stone that violates its law moves by itself; and
adaptive, where the systems of several rounds must not be there at once. Blocks of 2 x 1 cells.
"""

import json
import math
import pathlib
import subprocess
import sys

# kB per block, a fortieth above what is measured, 14.5 and 16.0: a page more or less of the allocator passes, a list per
# node (16 bytes each on 6 nodes) with its reserve does not. Six points of a block take 1.1 kB of it: a point has a place and
# axes with three components in the plane too. The adaptive one holds what the local criterion of ties keeps of stones and
# points from step to step, 1 kB.
MOST = {"bonded": 14.9, "adaptive": 16.4}


def peak(program, scene, courses, mode):
    folder = pathlib.Path("memory") / f"{mode}-{courses}"
    sets = {"mesh/wall/courses": courses, "mesh/wall/blocks per course": courses, "mesh/wall/cells along": 2,
            "mesh/wall/cells up": 1, "selection/mode": mode, "steps/stages/push/loads/sideways": 0}
    command = [program, f"--xml={scene}", f"--out={folder}", "--overwrite", "--quiet"]
    for path, value in sets.items():
        command += ["--set", f"{path}={value}"]
    subprocess.run(command, check=True)
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    return 1e3 * result["peak_memory_MB"], result["blocks"]


def main(program, scene):
    failed = 0
    for mode, most in MOST.items():
        per_block = math.inf
        for _ in range(3):  # on a busy machine a run may take a few per mille more, which is no more that a block takes
            (small, few), (large, many) = (peak(program, scene, courses, mode) for courses in (32, 96))
            per_block = min(per_block, (large - small) / (many - few))
            if per_block <= most:
                break
        print(f"{mode}: {per_block:.1f} kB per block, at most {most:.1f}")
        failed += per_block > most
    return failed > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
