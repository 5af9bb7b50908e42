"""Goes through seeds of planted stones and tells what came of each: planted.py, planted_in_space.py."""

import argparse
import pathlib
import sys
import tempfile
import time


def judge(words, posed, run, *, first, count, programs=("program",)):
    """posed(seed) is a scene; run(scene, asked, folder) says what is wrong with what came of it, or nothing. Ends the process.

    words: the help; programs: what is named on the command line before the options.
    """
    parser = argparse.ArgumentParser(description=words, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in programs:
        parser.add_argument(name)
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--first", type=int, default=first)
    parser.add_argument("--mode", default="adaptive")
    parser.add_argument("--hosts", action="store_true", help="the structures alone, which must stand")
    parser.add_argument("--keep", type=pathlib.Path, help="folder in which scenes and results stay")
    asked = parser.parse_args()
    right = "stands" if asked.hosts else "falls"
    wrong = undecided = 0
    with tempfile.TemporaryDirectory() as temporary:
        for seed in range(asked.first, asked.first + asked.count):
            scene, start = posed(seed), time.monotonic()
            problem = run(scene, asked, (asked.keep or pathlib.Path(temporary)) / str(seed))
            verdict = problem or ("undecided" if scene.undecided else right)
            print(f"{seed}: {scene}: {verdict} ({time.monotonic() - start:.1f} s)", flush=True)
            wrong += bool(problem)
            undecided += scene.undecided
    print(f"{wrong} of {asked.count} are wrong, {undecided} undecided.")
    sys.exit(wrong > 0)
