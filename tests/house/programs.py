"""No program loads gmsh but voussoir-gmsh: it takes as long to load as a small scene does to be solved. Nor does that one
load what solves: Trilinos would make it wait three times as long before it meshes.

usage: programs.py FOLDER_OF_PROGRAMS
"""

import pathlib
import subprocess
import sys

import house


def libraries_of(program):
    return subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout


def problems_of(folder):
    programs = [path for path in sorted(folder.iterdir()) if path.is_file() and path.stat().st_mode & 0o111]
    libraries = {path.name: libraries_of(path) for path in programs}
    loads = {name: "libgmsh" in loaded for name, loaded in libraries.items()}
    problems = [f"{name} loads gmsh; have it ask voussoir-gmsh (src/gmsh/README.md)."
                for name, loaded in loads.items() if loaded and name != "voussoir-gmsh"]
    if not loads.get("voussoir-gmsh"):
        problems.append("voussoir-gmsh is not there, or is without gmsh.")
    if "libtrilinos_tpetra" in libraries.get("voussoir-gmsh", ""):
        problems.append("voussoir-gmsh loads Tpetra: a source it links calls one that stands beside it in its folder; add "
                        "that to of_both_programs in src/CMakeLists.txt.")
    if "voussoir" not in loads:
        problems.append(f"voussoir is not in {folder}.")
    return problems


if __name__ == "__main__":
    house.finish("gmsh is loaded by its program alone, and alone", problems_of(pathlib.Path(sys.argv[1])))
