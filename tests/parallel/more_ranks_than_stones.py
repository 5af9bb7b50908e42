"""More ranks than stones, to the end of whole scenes: what is found is what one rank finds.

    more_ranks_than_stones.py PROGRAM MPIEXEC

Set-up    A stone that slides on a bed until it rests and its joint is tied again (sliding-block.xml, four ranks); a doorway
          of a few stones whose collapse factor is searched, with the static theorem (doorway.xml, nine ranks).
Expected  The outcome, warnings and numbers of one rank. A list that is empty on a rank without stones says nothing of whether
          there is anything to do: ranks that took it so would wait for each other, or read each other's messages.
Tolerance Displacements 1e-6 of the largest; factors that are proven 1e-9.
"""

import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = {"sliding-block": 4, "doorway": 9}


def result(program, mpiexec, scene, ranks):
    folder = pathlib.Path("more-ranks") / f"{scene}-np{ranks}"
    launch = [mpiexec, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    subprocess.run([*launch, program, f"--xml={ROOT / 'xml' / scene}.xml", f"--out={folder}", "--overwrite", "--quiet"], check=True)
    return json.loads((folder / "result.json").read_text(encoding="utf-8"))


def differences(one, many):
    found = [f"{key}: {one[key]} and {many[key]}" for key in ("outcome", "blocks", "steps", "joints") if one[key] != many[key]]
    size = one["largest_displacement_m"]
    if not abs(many["largest_displacement_m"] - size) <= 1e-6 * size and one["outcome"] == "equilibrium":
        found.append(f"largest displacement: {size} and {many['largest_displacement_m']}")
    kinds = [sorted({w["what"] for w in of["warnings"]}) for of in (one, many)]
    if kinds[0] != kinds[1]:
        found.append(f"warnings: {kinds[0]} and {kinds[1]}")
    for key in ("certified_upper", "estimate_without_dilatancy"):
        a, b = ((of.get("collapse") or {}).get(key) for of in (one, many))
        if (a is None) != (b is None) or (a is not None and not abs(a - b) <= 1e-9 * abs(a)):
            found.append(f"{key}: {a} and {b}")
    return found


def main():
    program, mpiexec = sys.argv[1:]
    wrong = []
    for scene, ranks in SCENES.items():
        one, many = (result(program, mpiexec, scene, count) for count in (1, ranks))
        assert many["blocks"] < ranks, f"{scene} has {many['blocks']} stones for {ranks} ranks"
        wrong += [f"{scene}, {line}" for line in differences(one, many)]
    print("\n".join(wrong) or "alike")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
