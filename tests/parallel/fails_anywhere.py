"""One rank of two fails in one exchange, whichever: all end, with a message, and none waits.

    fails_anywhere.py PROGRAM MPIEXEC PLANTED_LIBRARY [PLACES]

Set-up    Small scenes from input to result, or from a state that was kept, with fields and a state saved after every
          step; the calls of MPI are counted first (planted_failure.cpp). Then so many PLACES, shared out over all of
          them, in which one rank throws what nobody foresaw. Those at the beginning stand closer, since there every call
          is another.
Expected  An exit code that is not 0, within a minute (a run takes a second), and words that the program, or a library, has
          failed. What HDF5 and MUMPS exchange among themselves is not reached: tests/restart/out_of_memory.py is about them.
"""

import pathlib
import re
import subprocess
import sys
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path("fails-anywhere").resolve()
RANK, RANKS, LIMIT = 1, 2, 60
SCENES = {
    "load steps": ("wall", ["selection/mode=adaptive"]),
    "time steps": ("sliding-block", ["steps/stages/sliding/duration=2e-3", "steps/stages/sliding/time step=1e-4"]),
    "in space": ("wall-in-space", ["mesh/wall in space/courses=3"]),
    "limit analysis": ("doorway", []),
    "a restart": ("wall-in-space", ["mesh/wall in space/courses=3", "selection/mode=adaptive"]),
}


def begun(command, name, sets):
    """The folder of a run of the first stage of a scene alone."""
    scene = ElementTree.parse(ROOT / "xml" / f"{name}.xml")
    stages = scene.getroot().find("ParameterList[@name='steps']/ParameterList[@name='stages']")
    for stage in list(stages)[1:]:
        stages.remove(stage)
    scene.write(FOLDER / "begun.xml")
    line = [command["mpiexec"], "--oversubscribe", "-np", str(RANKS), command["program"],
            f"--xml={FOLDER / 'begun.xml'}", f"--out={FOLDER / 'begun'}", "--overwrite", "--quiet"]
    for one in sets:
        line += ["--set", one]
    subprocess.run(line, check=True, timeout=LIMIT)
    return FOLDER / "begun"


def options_of(what, command, name, sets):
    if what == "limit analysis":
        return ["--limit-analysis"]
    if what == "a restart":
        return [f"--restart-from={begun(command, name, sets)}"]
    return []


def run(command, name, sets, extra, call):
    environment = {"LD_PRELOAD": command["library"], "FAILING_RANK": str(RANK), "FAILING_CALL": str(call)}
    line = [command["mpiexec"], "--oversubscribe", "-np", str(RANKS)]
    for variable, value in environment.items():
        line += ["-x", f"{variable}={value}"]
    out = FOLDER / f"{name}-{len(extra)}-{call}"
    line += [command["program"], f"--xml={ROOT / 'xml' / name}.xml", f"--out={out}", "--overwrite", "--quiet", *extra]
    for one in [*sets, "output/checkpoint every=1"]:
        line += ["--set", one]
    with open(FOLDER / "said.txt", "w+", encoding="utf-8") as said:
        child = subprocess.Popen(line, stdout=said, stderr=said, start_new_session=True)
        try:
            code = child.wait(LIMIT)
        except subprocess.TimeoutExpired:
            child.terminate()  # mpiexec ends its ranks
            child.wait()
            code = None
        said.seek(0)
        return code, said.read()


def main():
    program, mpiexec, library, *rest = sys.argv[1:]
    places = int(rest[0]) if rest else 4
    command = {"program": program, "mpiexec": mpiexec, "library": library}
    FOLDER.mkdir(exist_ok=True)
    wrong = []
    for what, (name, sets) in SCENES.items():
        extra = options_of(what, command, name, sets)
        code, said = run(command, name, sets, extra, 0)
        counted = re.search(r"counted (\d+) calls", said)
        if code != 0 or not counted:
            wrong.append(f"{what}: without a failure it ends with {code}:\n{said[-1000:]}")
            continue
        calls = int(counted[1])
        # From 1 to the last, closer at the beginning: squares.
        for k in range(places):
            call = 1 + round((calls - 1) * ((k + 0.5) / places) ** 2)
            code, said = run(command, name, sets, extra, call)
            told = "a planted failure in" in said or "has failed and says" in said
            if code in (0, None) or not told:
                how = "hangs" if code is None else f"ends with {code}" + ("" if told else ", and does not say why")
                wrong.append(f"{what}, call {call} of {calls}: {how}:\n{said[-1500:]}")
        print(f"{what}: {calls} calls, {places} of them planted")
    print("\n".join(wrong) or "all end, and say why")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
