"""The model of many ranks predicts what is counted on 4 and 8, from what was counted on 2.

    rank_model.py PROGRAM MPIEXEC FOLDER-OF-THE-MODEL

Messages within 6 %: METIS need not make as many neighbours as a triangulation has. Bytes within 20 %: its borders are
shorter than those of squares.
"""

import json
import pathlib
import subprocess
import sys

MESSAGES, BYTES = 0.06, 0.20


def main(program, mpiexec, model):
    sys.path.insert(0, model)
    import rank_model

    rows = []
    for ranks in (2, 4, 8):
        for on_first in (0, 20000):  # block motions by levels, and factored by the first rank
            folder = pathlib.Path("rank_model") / f"{ranks}-{on_first}"
            subprocess.run([mpiexec, "--oversubscribe", "-np", str(ranks), program, "--systems=blocks", "--smallest=16",
                            "--largest=32", f"--out={folder}", "--set",
                            f"internals/preconditioner/motions on first rank={on_first}"], check=True, capture_output=True)
            rows += json.loads((folder / "systems.json").read_text(encoding="utf-8"))
    by_levels = [bool(row["motion_level_rows"]) for row in rows]
    widths = rank_model.Widths([row for row in rows if row["ranks"] == 2])
    failed = compared = 0
    for row in rows:
        measured, predicted = rank_model.measured(row), rank_model.predicted(row, widths)
        for name, value in measured.items():
            allowed = BYTES if name.endswith(" bytes") else MESSAGES
            wrong = abs(predicted[name] / value - 1)
            compared += 1
            if wrong > allowed:
                failed += 1
                print(f"W({row['size']:g}), {row['ranks']} ranks, {name}: {value:g}, predicted {predicted[name]:g}")
    print(f"{compared} counts compared, {failed} off")
    return failed > 0 or compared < 80 or by_levels.count(True) != 6


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
