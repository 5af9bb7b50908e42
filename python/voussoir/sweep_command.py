"""The command line of drivers/sweep."""

import argparse
import signal
import sys

from . import program, sweep_inputs
from .sweeping import Sweep

USAGE = """drivers/sweep SCENE.xml --set "path=a,b,c" [--set "path=from:to:n"] [options]

Computes a scene for all combinations of the values given, as many runs side by side as cores bear.

  SCENE.xml               a scene; looked for from here, then from the folder of Voussoir
  --set "PATH=A,B,C"      values of one parameter of the scene (between ; where a value holds a comma); may be repeated
  --set "PATH=FROM:TO:N"  N values, evenly from FROM to TO, both included
  --zip                   the first values of all, then the second of all, ..., instead of all combinations
  --jobs N                runs side by side (default: the physical cores over the ranks)
  --ranks N               MPI ranks of each run (default: 1)
  --out DIR               folder of the sweep (default: out/sweep-NAME, NAME being that of the scene)
  --envelope              also tell the worst of every quantity and the combination that has it, and up to where all stand
  --no-reports            draw no report of the single runs, only the page of the sweep
  --limit-analysis        ask rigid limit analysis alone: seconds where a run takes minutes
  --at-most TIME          end each run in time with what is known by then: 90s, 5min, 2h
  --trust                 let a .geo run programs, and read and write other files, which is refused else
  --overwrite             compute all again, also what is done

Leaves in DIR: sweep.csv with a row for each combination, sweep.svg, sweep.html with links to the reports, and the results
of each run in DIR/runs. Ctrl-C and SIGTERM make all runs save their state; the same command goes on. What is done is not run
again, and a scene, drawing, record or program that has changed meanwhile is noticed.

Exit code: 0 all runs came to an end (a collapse is a result), 2 the input is wrong, or some combinations are,
3 some runs did not converge, 4 a resource is missing, 5 stopped (the same command goes on).
"""


def parser():
    words = argparse.ArgumentParser(prog="drivers/sweep", add_help=False, allow_abbrev=False, usage=argparse.SUPPRESS)
    words.add_argument("scene", nargs="?")
    words.add_argument("--set", action="append", default=[])
    for name in ("--jobs", "--ranks"):
        words.add_argument(name)
    words.add_argument("--out")
    words.add_argument("--at-most")
    for name in ("--zip", "--envelope", "--no-reports", "--limit-analysis", "--trust", "--overwrite", "--help", "-h"):
        words.add_argument(name, action="store_true")
    words.error = refuse
    return words


def refuse(message):
    raise program.InputError(f"drivers/sweep: {message}\n  See drivers/sweep --help.")


def count(name, text):
    if text is None:
        return None
    if not text.isdigit() or int(text) == 0:
        raise program.InputError(f"drivers/sweep: {name} = {text}\n  must be a whole number, 1 or more.")
    return int(text)


def read_command(arguments):
    asked = parser().parse_args(arguments)
    if asked.help or asked.h:
        return asked
    if not asked.scene:
        refuse("no scene given.")
    asked.inputs = sweep_inputs.read_inputs(asked.set)
    sweep_inputs.combinations(asked.inputs, asked.zip)  # refuses what cannot be
    asked.jobs, asked.ranks = count("--jobs", asked.jobs), count("--ranks", asked.ranks) or 1
    asked.scene = program.find_scene(asked.scene)
    asked.options = [option for option, wanted in (("--limit-analysis", asked.limit_analysis), ("--trust", asked.trust)) if wanted]
    asked.options += [f"--at-most={asked.at_most}"] if asked.at_most else []
    return asked


def exit_code(rows):
    codes = [row.get("exit_code") for row in rows]
    known = (program.STOPPED, program.NO_RESOURCE, program.NO_CONVERGENCE, program.WRONG_INPUT)
    if any(code not in (*known, program.DONE) for code in codes):
        return program.NO_RESOURCE
    return next((code for code in known if code in codes), program.DONE)


def say(line):
    print(line, flush=True)


def tell_end(work, rows):
    counts = {}
    for row in rows:
        counts[row["outcome"]] = counts.get(row["outcome"], 0) + 1
    words = {"equilibrium": "in equilibrium"}
    say("\n" + ", ".join(f"{number} {words.get(word, word.replace('_', ' '))}" for word, number in counts.items())
        + f". Table: {work.out}/sweep.csv")
    page = work.draw()
    if page:
        say(f"Page: {page}")


def main(arguments, build=lambda: None):
    """@param build  makes sure that the program is there, once the command is known to be right"""
    def interrupt(*_):
        raise KeyboardInterrupt

    signal.signal(signal.SIGTERM, interrupt)
    work = None
    try:
        asked = read_command(arguments)
        if asked.help or asked.h:
            print(USAGE, end="")
            return program.DONE
        build()
        work = Sweep(asked.scene, asked.inputs, asked.out, asked.zip, asked.jobs, asked.ranks, not asked.no_reports,
                     asked.envelope, asked.overwrite, asked.options, say)
        rows = work.go()
        tell_end(work, rows)
        return exit_code(rows)
    except program.VoussoirError as error:
        print(error, file=sys.stderr)
        return error.code
    except KeyboardInterrupt:
        print("Stopped. The same command goes on with what is left." if work else "Stopped.", file=sys.stderr)
        return program.STOPPED
