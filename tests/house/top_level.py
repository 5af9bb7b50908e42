"""The top level holds the folders of src/README.md and what tools look for there, and nothing that a run left behind."""

import subprocess

import house

ALLOWED = {"CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "cmake", "drivers", "meshes", "python", "src", "tests", "xml"}


def problems_of(paths):
    """Of the files that belong to the repository, as paths below its root."""
    names = sorted({path.split("/")[0] for path in paths})
    return [f"{name}: is no part of the project; results of runs and tests belong to folders that git ignores."
            for name in names if name not in ALLOWED and not name.startswith(".")]


def main():
    listed = subprocess.run(["git", "-C", house.ROOT, "ls-files"], capture_output=True, text=True, check=False)
    if listed.returncode != 0:  # an archive of the sources has no list, and holds what git had
        house.finish("The sources are no repository, so that nothing can have been added to it", [])
    house.finish("The top level holds the project alone", problems_of(listed.stdout.splitlines()))


if __name__ == "__main__":
    main()
