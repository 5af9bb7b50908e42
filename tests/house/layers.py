"""Includes point one way: from what uses to what is used, never back; methods are given settings, not a scene."""

import re

import house

# folder: the folders it may include; what those may include is allowed with them.
SEES = {
    "base": [],
    "linalg": ["base"],
    "mesh": ["base"],
    "stones": ["mesh"],
    "drawings": ["stones"],
    "blocks": ["mesh", "linalg"],
    "joints": ["blocks", "linalg"],
    "selection": ["linalg"],
    "homogenisation": ["joints", "linalg"],
    "nonlinear": ["linalg"],
    "statics": ["base"],
    "dynamics": ["nonlinear"],
    "loads": ["blocks"],
    "output": ["base"],
    "scene": ["base"],
    "model": ["scene", "homogenisation", "selection", "dynamics", "loads", "output"],
    "ties": ["model"],
    "step": ["ties"],
    "time": ["step"],
    "results": ["time", "statics"],
    "range": ["results", "drawings"],
    "run": ["range"],
    "study": ["run"],
    "gmsh": ["stones"],
    "drivers": ["study", "gmsh"],
}

# Pure functions of numbers, without geometry: the headers of joints that all folders from linalg up may see.
PURE = {"joints/contact_law.hpp", "joints/damage.hpp", "joints/point_freedom.hpp", "joints/softening.hpp"}

# What ranks tell each other: all folders but base may see it.
RANKS = {f"linalg/{name}.hpp" for name in ("agree", "fail_together", "gather", "groups", "mpi_handle", "numbering", "parcels", "reduce", "shared_warnings")}

# Libraries with one owner: each is included by at most one source file and by no header.
ONE_OWNER = {"Belos": "Belos", "MueLu": "MueLu", "METIS": "metis.h", "HDF5": "hdf5", "CLP": "Clp",
             "CLI11": "CLI/", "pugixml": "pugixml", "Eigen": "Eigen/"}
# A library of a program of its own, which no other program loads: known to one folder.
ONE_FOLDER = {"gmsh": ("gmsh.h", "src/gmsh")}
# Documents with nothing in common: scenes, and drawings that are XML.
TWO_OWNERS = {"pugixml": {"scene_xml.cpp", "svg_stones.cpp"}}


# Rooms of methods, which are given the settings that are theirs (model/model_settings.hpp).
SEE_NO_SCENE = {"ties", "step", "time"}


def reach(folder):
    """The folder itself and all folders below it in the table."""
    seen = {folder}
    for below in SEES[folder]:
        seen |= reach(below)
    return seen


def is_parameters(name):
    return name.endswith("_parameters.hpp")


def problem_of(path, name):
    """What is wrong with the file `path` (such as src/mesh/mesh.hpp) including "name", or None."""
    folder = path.parts[1] if path.parts[0] == "src" else "drivers"
    if folder not in SEES:
        return f"{path}: folder {folder} is not in the table of tests/house/layers.py."
    if "/" not in name:
        return f'{path}: #include "{name}" must start at src/, such as "{folder}/{name}".'
    target = name.split("/")[0]
    if target not in SEES:
        return f'{path}: #include "{name}" is not below src/; libraries are included with <>.'
    if is_parameters(path.name):
        # A parameter struct is plain data: the scene reads it without seeing the module.
        allowed = target == "base" or is_parameters(name)
    elif name in PURE | RANKS and folder != "base":
        allowed = True
    elif folder == "scene" and is_parameters(name):
        allowed = True
    else:
        allowed = target in reach(folder)
    if allowed:
        return None
    return f'{path}: #include "{name}" points up; {folder} may see {", ".join(sorted(reach(folder)))}.'


def problems_of_scenes(path, text):
    """What hands a whole scene to methods, in a file of src/."""
    if path.parts[1] == "scene":
        return []
    code = "\n".join(line.split("//")[0] for line in text.splitlines())
    problems = []
    if re.search(r"\bscene\(\)", code):
        problems.append(f"{path}: scene() hands a whole scene on; give the settings that are read.")
    if path.parts[1] in SEE_NO_SCENE and re.search(r"\bScene\b", code):
        problems.append(f"{path}: {path.parts[1]} sees no scene; give it the settings that it reads.")
    return problems


def problems_of_libraries(files):
    """files: pairs of path and text."""
    problems = []
    for library, start in ONE_OWNER.items():
        users = [path for path, text in files
                 if any(quote == "<" and name.startswith(start) for quote, name in house.includes(text))]
        problems += [f"{path}: a header must not include {library}." for path in users if path.suffix == ".hpp"]
        if {path.name for path in users} <= TWO_OWNERS.get(library, set()):
            continue
        if len(users) > 1:
            problems.append(f"{library} belongs to one .cpp, but is included by {', '.join(map(str, users))}.")
    for library, (header, folder) in ONE_FOLDER.items():
        problems += [f"{path}: {library} belongs to {folder}." for path, text in files
                     if str(path.parent) != folder and ("<", header) in house.includes(text)]
    return problems


def main():
    files = [(path, house.read(path)) for path in house.code_files(".hpp", ".cpp") if path.parts[0] in ("src", "drivers")]
    problems = [problem_of(path, name) for path, text in files for quote, name in house.includes(text) if quote == '"']
    problems = [problem for problem in problems if problem]
    problems += [f"{path}: base knows nothing of Trilinos, but includes <{name}>." for path, text in files
                 if path.parts[1] == "base" for quote, name in house.includes(text)
                 if name.startswith(("Tpetra", "Kokkos", "Xpetra"))]
    problems += [problem for path, text in files if path.parts[0] == "src" for problem in problems_of_scenes(path, text)]
    problems += problems_of_libraries(files)
    house.finish("Includes point down", problems)


if __name__ == "__main__":
    main()
