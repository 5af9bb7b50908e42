#!/usr/bin/python3
"""Other programs on W(n) and A(n) beside this one, run by run in turn on the same machine.

    compare.py VOUSSOIR OUTDIR [--scenes=W4,W8,W16,A15,A31,A61] [--repeat=2] [--limit=120]

Seconds are those of the processor, user and system, of whole processes from reading the scene to the displacements, least
of the repetitions. A program is stopped after as many of them as the limit; one that is not installed is said to be.
Every program solves both load steps; the displacement is the largest of the second. Writes OUTDIR/peers.csv.
"""
import csv
import json
import os
import resource
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

HERE = Path(__file__).resolve().parent
XML = HERE.parents[1] / "xml"
PYTHON = "/usr/bin/python3"
# GetFEM's Newton method takes 157 solves for W4 with Debian's reference BLAS and does not end with OpenBLAS, which our
# packages install: others get the one they do better with.
LIBRARIES = "/usr/lib/" + str(sysconfig.get_config_var("MULTIARCH"))
REFERENCE_BLAS = ":".join(filter(None, (f"{LIBRARIES}/blas", f"{LIBRARIES}/lapack", os.environ.get("LD_LIBRARY_PATH"))))


def seconds_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def finished(command, limit, **variables):
    """The process and its seconds; processes it starts have the same limit each."""
    before = seconds_of_children()
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", **variables)
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit))))
    return done, seconds_of_children() - before


def without_answer(seconds, limit, why="failed"):
    return None, seconds, f"stopped after {limit:g} s" if seconds > 0.95 * limit else why


def run(command, limit):
    """What it prints last, its seconds, what went wrong."""
    done, seconds = finished(command, limit, LD_LIBRARY_PATH=REFERENCE_BLAS)
    lines = done.stdout.strip().splitlines()
    if done.returncode != 0 or not lines or not lines[-1].startswith("{"):
        return without_answer(seconds, limit)
    found = json.loads(lines[-1])
    if not found["converged"]:
        return without_answer(seconds, limit, "no convergence")
    return found, seconds, ""


def ours(program, mode, scene, folder, limit):
    n = int(scene[1:])
    changes = [f"selection/mode={mode}", "output/fields=false"]
    changes += ([f"mesh/wall/courses={n}", f"mesh/wall/blocks per course={n}"] if scene[0] == "W"
                else [f"mesh/arch/voussoirs={n}"])
    command = [program, f"--xml={XML / ('wall.xml' if scene[0] == 'W' else 'arch.xml')}", f"--out={folder}", "--quiet",
               "--overwrite"]
    for change in changes:
        command += ["--set", change]
    shutil.rmtree(folder, ignore_errors=True)
    _, seconds = finished(command, limit)
    if not (folder / "result.json").exists():
        return without_answer(seconds, limit)
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    if result["outcome"] != "equilibrium":
        return None, seconds, result["outcome"]
    return {"solves": [result["linear_solves"]], "largest_displacement_m": [result["largest_displacement_m"]]}, seconds, ""


def programs(voussoir, folder):
    """Name, and how to run a scene."""
    found = {"Voussoir, all points": lambda s, limit: ours(voussoir, "all", s, folder / "run", limit),
             "Voussoir, adaptive": lambda s, limit: ours(voussoir, "adaptive", s, folder / "run", limit)}
    if subprocess.run([PYTHON, "-c", "import getfem"], capture_output=True, check=False).returncode == 0:
        found["GetFEM"] = lambda s, limit: run([PYTHON, "-B", HERE / "getfem_scene.py", s], limit)
    else:
        print("GetFEM is not installed (apt-get install python3-getfem): not run.")
    if shutil.which("ccx"):
        found["CalculiX"] = lambda s, limit: run([PYTHON, "-B", HERE / "calculix_scene.py", s, folder / "ccx"], limit)
    else:
        print("CalculiX is not installed (apt-get install calculix-ccx): not run.")
    return found


def compare(scene, found, repeat, limit):
    """A row per program; those that failed once are not run again."""
    rows = {}
    for _ in range(repeat):
        for name, solve in found.items():
            if name in rows and rows[name]["outcome"]:
                continue
            answer, seconds, outcome = solve(scene, limit)
            row = {"scene": scene, "program": name, "seconds": seconds, "outcome": outcome,
                   "solves": sum(answer["solves"]) if answer else "",
                   "displacement_m": answer["largest_displacement_m"][-1] if answer else ""}
            if name not in rows or seconds < rows[name]["seconds"]:
                rows[name] = row
    reference = rows["Voussoir, all points"]
    for row in rows.values():
        solved = not row["outcome"] and not reference["outcome"]
        row["ratio"] = row["seconds"] / reference["seconds"] if solved else ""
        row["off"] = abs(row["displacement_m"] / reference["displacement_m"] - 1) if solved else ""
    return list(rows.values())


def main(words):
    options = {"scenes": "W4,W8,W16,A15,A31,A61", "repeat": "2", "limit": "120"}
    places = []
    for word in words:
        name, _, value = word.removeprefix("--").partition("=")
        if word.startswith("--") and name in options:
            options[name] = value
        elif word.startswith("--"):
            sys.exit(f"compare.py: '{word}' is no option.\n{__doc__}")
        else:
            places.append(word)
    if len(places) != 2:
        sys.exit(__doc__)
    folder = Path(places[1])
    folder.mkdir(parents=True, exist_ok=True)
    found = programs(places[0], folder)
    print("| scene | program | solves | s | over ours, all points | largest displacement | off ours |\n" + "|---" * 7 + "|")
    table = []
    for scene in options["scenes"].split(","):
        for row in compare(scene, found, int(options["repeat"]), float(options["limit"])):
            table.append(row)
            cells = ([f"{row['seconds']:.2f}", f"{row['ratio']:.2g}", f"{row['displacement_m']:.6g} m", f"{row['off']:.1e}"]
                     if row["ratio"] != "" else [f"{row['seconds']:.2f}", row["outcome"] or "-", "", ""])
            print(f"| {scene} | {row['program']} | {row['solves']} | " + " | ".join(cells) + " |", flush=True)
    with open(folder / "peers.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, fieldnames=list(table[0]))
        writer.writeheader()
        writer.writerows(table)
    shutil.rmtree(folder / "run", ignore_errors=True)
    shutil.rmtree(folder / "ccx", ignore_errors=True)


if __name__ == "__main__":
    main(sys.argv[1:])
