"""One scene by CalculiX: contact of surfaces by penalty (Debian: calculix-ccx).

    calculix_scene.py W8 FOLDER      prints a line of JSON: iterations, whether both load steps ended, displacement, seconds
"""
import json
import math
import pathlib
import re
import resource
import subprocess
import sys

import scenes

PENALTY = 1e12  # [N/m3]; ten times as much converges less often, ten times less is that much softer


def deck_of(scene):
    lines = ["*NODE, NSET=NALL"]
    lines += [f"{k}, {x:.12g}, {y:.12g}, 0" for k, (x, y) in enumerate(scene.position, 1)]
    lines += ["*ELEMENT, TYPE=CPS4, ELSET=EALL"]
    lines += [f"{k}, " + ", ".join(str(node + 1) for node in cell) for k, cell in enumerate(scene.cells, 1)]
    face = {}
    for k, cell in enumerate(scene.cells, 1):
        for side in range(4):
            face[frozenset((cell[side], cell[(side + 1) % 4]))] = (k, side + 1)
    for number, sides in enumerate(scene.joints):
        for name, nodes in zip("IJ", sides):
            lines.append(f"*SURFACE, NAME=S{number}{name}, TYPE=ELEMENT")
            lines += ["{}, S{}".format(*face[frozenset(edge)]) for edge in zip(nodes, nodes[1:])]
    lines += ["*MATERIAL, NAME=STONE", "*ELASTIC", f"{scenes.YOUNG:g}, {scenes.POISSON}", "*DENSITY",
              f"{scenes.DENSITY:g}", "*SOLID SECTION, ELSET=EALL, MATERIAL=STONE", f"{scenes.THICKNESS}",
              "*SURFACE INTERACTION, NAME=DRY", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{PENALTY:g}",
              "*FRICTION", f"{scenes.FRICTION}, {PENALTY:g}"]
    for number in range(len(scene.joints)):
        lines += ["*CONTACT PAIR, INTERACTION=DRY, TYPE=SURFACE TO SURFACE", f"S{number}I, S{number}J"]
    for step in (1, 2):
        lines += ["*STEP, INC=1000", "*STATIC", "1, 1, 1e-5, 1", "*BOUNDARY"]
        for node, given in scene.held:
            for c in range(2):
                lines.append(f"{node + 1}, {c + 1}, {c + 1}, {given[c] if step == 2 else 0:g}")
        lines += ["*DLOAD, OP=NEW", f"EALL, GRAV, {scenes.GRAVITY}, 0, -1, 0"]
        if step == 2 and scene.push:
            # One acceleration: the resultant of both.
            size = math.hypot(scene.push, scenes.GRAVITY)
            lines[-1] = f"EALL, GRAV, {size:.12g}, {scene.push / size:.12g}, {-scenes.GRAVITY / size:.12g}, 0"
        lines += ["*NODE PRINT, NSET=NALL", "U", "*END STEP"]
    return "\n".join(lines) + "\n"


def last_displacements(text):
    """Of the last table: node, ux, uy, uz."""
    rows = []
    for line in text.splitlines():
        words = line.split()
        if line.strip().startswith("displacements"):
            rows = []
        elif len(words) == 4 and words[0].isdigit():
            rows.append([float(word) for word in words[1:]])
    return rows


def main(name, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scene.inp").write_text(deck_of(scenes.scene_of(name)), encoding="utf-8")
    done = subprocess.run(["ccx", "-i", "scene"], cwd=folder, capture_output=True, text=True, check=False)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN)
    status = (folder / "scene.sta").read_text(encoding="utf-8") if (folder / "scene.sta").exists() else ""
    steps = [line.split() for line in status.splitlines() if re.match(r"\s*\d+\s+\d+\s", line)]
    converged = done.returncode == 0 and "Job finished" in done.stdout and bool(steps) and steps[-1][0] == "2"
    u = last_displacements((folder / "scene.dat").read_text(encoding="utf-8")) if converged else []
    print(json.dumps({"solves": [sum(int(row[3]) for row in steps)], "converged": converged,
                      "largest_displacement_m": [max(math.hypot(x, y) for x, y, _ in u)] if u else [],
                      "seconds_to_solve": seconds.ru_utime + seconds.ru_stime}))


if __name__ == "__main__":
    main(*sys.argv[1:])
