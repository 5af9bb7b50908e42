"""A program of somebody else finds an installed Voussoir with find_package and runs.

usage: consumer.py BUILD_FOLDER CMAKE
"""

import pathlib
import subprocess
import sys
import tempfile

import house


def main():
    build, cmake = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        prefix, work = pathlib.Path(folder) / "prefix", pathlib.Path(folder) / "work"
        for command in (
                [cmake, "--install", build, "--prefix", prefix],
                [cmake, "-G", "Ninja", "-S", house.ROOT / "tests/house/consumer", "-B", work,
                 f"-DCMAKE_PREFIX_PATH={prefix}"],
                [cmake, "--build", work],
                [work / "consumer"]):
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            if done.returncode != 0:
                house.finish("find_package(Voussoir) works", [" ".join(map(str, command)) + "\n" + done.stdout])
        house.finish("find_package(Voussoir) works", [])


if __name__ == "__main__":
    main()
