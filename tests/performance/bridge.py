"""Linear solves and whole factorisations of the bridge's main job: own weight, then its western pier settles and tilts.

    bridge.py PROGRAM BRIDGE.xml
"""

import json
import pathlib
import subprocess
import sys

# 230 and 146 when this was written; 271 and 185 where active sets damped on when that did not help.
MOST_SOLVES, MOST_WHOLE = 255, 170


def main(program, scene):
    folder = pathlib.Path("bridge")
    subprocess.run([program, f"--xml={scene}", f"--out={folder}", "--overwrite", "--quiet"], check=True)
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    solves, whole = result["linear_solves"], result["factorisations"]["whole"]
    print(f"{solves} linear solves, at most {MOST_SOLVES}; {whole} systems factored whole, at most {MOST_WHOLE}")
    return not (result["outcome"] == "equilibrium" and solves <= MOST_SOLVES and whole <= MOST_WHOLE)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
