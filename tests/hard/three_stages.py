"""Random small masonry through three stages, of load steps, of time and of construction, in any order.

    three_stages.py PROGRAM MPIEXEC [--count N] [--first SEED] [--seeds SEED ...] [--space]

Set-up    A wall in bond, a stack or a portal whose lintel has a prop (in space a corner of two walls too), dry, with joints that soften, or on mortar as springs.
          Its first stage is its own weight. The other two are load steps or take time; in each a support may settle, the
          structure is pushed, its top is loaded by wind, a push comes as a pulse in time, and a stone appears or disappears.
          Every structure bears what it is given by far.
Expected  1. A run that is stopped at a random step and goes on writes the history of one that was not, to the last bit.
          2. One, two and four ranks agree.
          3. The work of loads and supports in the energy book is that of forces times ways: nodal forces and their impulses
             are integrated here from the scene and the mesh, ways are those of fields.h5, and what supports bear and how far
             they go is what history.csv observes. Of a load step both know the ends alone, so what joints do between them
             (work_within_steps_J) is not part of it.
          4. The outcome is an equilibrium, without a warning that is none of the scene's.
          Construction and time do not go together in one scene: such ones are load steps alone.
Tolerance Ranks: 1e-6 of the largest energy and displacement, a hundred times what the solver leaves of forces. Work: 1e-6 of
          the largest energy, beside the imbalance that the run tells.
"""

import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "ground"), str(HERE.parent / "support")]

import program  # noqa: E402  (modules of folders of their own)
import scenes  # noqa: E402
from staged import Posed  # noqa: E402
from staged_in_space import PosedInSpace  # noqa: E402

SMALL = 1e-6
PATIENCE = 300  # [s] of a run
STOPPED = 5  # exit code of a run that a signal stopped
# What any of these scenes may say and mean: load steps drop the velocity of a structure that still moves, and a time step
# is longer than a piece of its pulse. A force drawn by lot may be as small as nobody gives it. Where a stone comes or goes,
# loads may act on it while it is not there. Joints that soften may snap where a support settles, and tell what energy that took.
MAY_SAY = {"velocity_dropped", "time_step_over_load", "unusual_value"}
MAY_SAY_IN_CONSTRUCTION = {"load_on_absent_stones"}
MAY_SAY_OF_SOFTENING = {"lost_in_jump"}
SNAP = 0.05  # of the largest energy: five times what is told at all; more is no joint that snaps but a structure that falls


class Work:
    """Forces times ways of one run, from the mesh, the scene and what the run wrote of motion and of supports."""

    def __init__(self, posed, run):
        self.posed, self.rows = posed, run.history
        with h5py.File(run.folder / "fields.h5") as file:
            self.place = file["mesh/coordinates"][:]
            self.cells = file["mesh/cells"][:]
            names = [n.decode().strip("\0 ") if isinstance(n, bytes) else n for n in file["mesh/block_set_names"][:]]
            block_set, block_of_cell = file["mesh/block_set"][:], file["mesh/block_of_cell"][:]
            self.steps = [file["steps"][key]["displacement"][:] for key in sorted(file["steps"])]
        self.is_cap = np.array([names[s] == "cap" if s >= 0 else False for s in block_set])[block_of_cell]
        assert self.is_cap.any() and not self.is_cap.all()

    def loads(self):
        """Nodal forces of every load at factor one [N]; the cap apart, since it is not always there."""
        return {(load, cap): forces for cap in (False, True)
                for load, forces in self.posed.nodal_forces(self.place, self.cells[self.is_cap == cap], cap).items()}

    def mean(self, load, stage, start, end, t):
        """Mean factor of a load over a step between two shares of a stage that begins at time t, and its factor at the end."""
        posed = self.posed
        duration = posed.stages[stage].get("duration", 0.0)
        value = lambda share: posed.factor(load, stage, share) * (  # noqa: E731
            posed.pulse(t + share * duration) if load == "pulse" else 1.0)
        if not duration:
            return None, value(end)
        cuts = sorted({start, end, *((p - t) / duration for p, _ in posed.function if start < (p - t) / duration < end)})
        total = 0.0  # the product of two straight lines: Simpson's rule is exact
        for a, b in zip(cuts, cuts[1:]):
            total += (b - a) / 6 * (value(a) + 4 * value((a + b) / 2) + value(b))
        return total / (end - start), value(end)

    def of_the_run(self):
        """Work of loads and supports after every step [J]; nothing after a load step that follows time steps and moves a
        support, since no row tells what it bore at the start of that."""
        shapes, posed = self.loads(), self.posed
        before, reaction = {key: 0.0 for key in shapes}, {}
        u, total, t, last, share = np.zeros_like(self.place), 0.0, 0.0, None, 0.0
        ways, works, was_in_time = {}, [], False
        for row, after in zip(self.rows, self.steps, strict=True):
            stage, unknown = row["stage"], False
            if stage != last:
                t += posed.stages[last].get("duration", 0.0) if last else 0.0
                last, share = stage, 0.0
            for key, shape in shapes.items():
                load, cap = key
                there = 1.0 if not cap or posed.present(stage) else 0.0
                mean, end = self.mean(load, stage, share, row["load_factor"], t)
                force = (before[key] + there * end) / 2 if mean is None else there * mean
                total += force * np.sum(shape * (after - u))
                before[key] = there * end
            for name in posed.supports:
                for c in "xyz"[:self.place.shape[1]]:
                    way, now = row[f"u{c}_m of {name}"], row[f"f{c}_N of {name}"]
                    in_time = bool(posed.stages[stage].get("duration"))
                    force = now if in_time else (reaction.get((name, c), 0.0) + now) / 2
                    total += force * (way - ways.get((name, c), 0.0))
                    unknown |= was_in_time and not in_time and way != ways.get((name, c), 0.0)
                    ways[name, c], reaction[name, c] = way, now
            u, share = after, row["load_factor"]
            was_in_time = bool(posed.stages[stage].get("duration"))
            works.append(None if unknown else total)
        return works


class Judge:
    """Runs a scene in its ways and collects what is wrong."""

    def __init__(self, posed, folder):
        self.posed, self.folder, self.faults = posed, folder, []
        self.folder.mkdir(parents=True)
        self.path = posed.write(self.folder)

    def command(self, out, *options, ranks=1):
        launch = [program.MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        return [*launch, program.PROGRAM, f"--xml={self.path}", f"--out={self.folder / out}", *options]

    def run(self, out, *options, ranks=1):
        done = subprocess.run(self.command(out, *options, ranks=ranks), capture_output=True, text=True, check=False,
                              timeout=PATIENCE, env={**os.environ, **program.ENVIRONMENT})
        run = program.Run(self.folder / out, done)
        if run.code != 0 or run.outcome != "equilibrium":
            raise AssertionError(f"{out}: exit code {run.code}, {run.outcome}: {run.words[-300:]}")
        return run

    def judge(self):
        try:
            whole = self.run("whole")
            self.judge_warnings(whole)
            self.judge_work(whole)
            self.judge_restart(whole)
            self.judge_ranks(whole)
        except (AssertionError, subprocess.TimeoutExpired) as error:
            self.faults.append(str(error))
        return self.faults

    def judge_warnings(self, whole):
        may_say = MAY_SAY | (MAY_SAY_IN_CONSTRUCTION if self.posed.construction else set())
        may_say |= MAY_SAY_OF_SOFTENING if self.posed.law != "dry" else set()
        for w in whole.result["warnings"]:
            if w["what"] not in may_say:
                self.faults.append(f"warns: {w['what']}: {w['text'][:200]}")
            elif w["what"] == "lost_in_jump" and w["how_much"] > SNAP * self.largest_energy(whole.history):
                self.faults.append(f"falls: {w['text'][:200]}")

    @staticmethod
    def largest_energy(rows):
        return max(abs(row[key]) for row in rows for key in ("elastic_J", "kinetic_J", "external_work_J", "friction_J"))

    def judge_work(self, whole):
        rows = whole.history
        scale, offset, rebase = self.largest_energy(rows), 0.0, False
        for row, work in zip(rows, Work(self.posed, whole).of_the_run(), strict=True):
            told = row["external_work_J"] - row["work_within_steps_J"]
            if work is None:
                rebase = True
                continue
            if rebase:  # what follows is counted from here
                offset, rebase = told - work, False
                continue
            apart = abs(work + offset - told)
            if apart > SMALL * scale + abs(row["imbalance_J"]):
                self.faults.append(f"step {row['step']:.0f}, stage {row['stage']}: forces times ways are {work:.9g} J, the book "
                                   f"says {told:.9g} J, imbalance {row['imbalance_J']:.2g} J, largest "
                                   f"energy {scale:.3g} J")
                return

    def judge_restart(self, whole):
        rows = len(whole.history)
        stop = self.posed.random.randint(1, max(1, rows - 1))
        process = subprocess.Popen(self.command("stopped"), stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT,
                                   env={**os.environ, **program.ENVIRONMENT})
        history = self.folder / "stopped" / "history.csv"
        until = time.monotonic() + PATIENCE
        while process.poll() is None and time.monotonic() < until:
            if history.exists() and len(history.read_text().splitlines()) > stop:
                break
            time.sleep(0.005)
        process.send_signal(signal.SIGUSR1)
        code = process.wait(timeout=PATIENCE)
        if code not in (0, STOPPED):
            raise AssertionError(f"stopped after step {stop}: exit code {code}")
        if code == 0:
            return  # it was done before the signal came
        again = self.run("stopped", "--restart")
        for mine, theirs in zip(again.history, whole.history, strict=True):
            wrong = [k for k in mine if k != "seconds" and repr(mine[k]) != repr(theirs[k])]
            if wrong:
                raise AssertionError(f"stopped after step {stop} and gone on with, step {mine['step']:.0f} has another "
                                     f"{wrong[0]}: {mine[wrong[0]]!r} for {theirs[wrong[0]]!r}")
        if again.warnings != whole.warnings:
            raise AssertionError(f"gone on with it warns of {again.warnings}, in one run of {whole.warnings}")

    def judge_ranks(self, whole):
        other = self.run("ranks", ranks=self.posed.ranks)
        rows, theirs = whole.history, other.history
        scales = {"_J": self.largest_energy(rows), "_m": max(row["largest_displacement_m"] for row in rows)}
        for mine, its in zip(rows, theirs, strict=True):
            for key in ("elastic_J", "kinetic_J", "external_work_J", "friction_J", "fracture_J", "damping_J",
                        "largest_displacement_m", "load_factor"):
                scale = scales.get(key[-2:], 1.0)
                if not abs(mine[key] - its[key]) <= SMALL * scale:
                    raise AssertionError(f"{self.posed.ranks} ranks, step {mine['step']:.0f}: {key} {its[key]:.9g} for "
                                         f"{mine[key]:.9g}, of {scale:.3g}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("mpiexec")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seeds", type=int, nargs="+", help="these alone")
    parser.add_argument("--space", action="store_true", help="masonry in space")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder to keep the runs in")
    options = parser.parse_args()
    program.PROGRAM, program.MPIEXEC = options.program, options.mpiexec
    posed = PosedInSpace if options.space else Posed
    failed = 0
    seeds = options.seeds or range(options.first, options.first + options.count)
    with tempfile.TemporaryDirectory() as temporary:
        for seed in seeds:
            start = time.monotonic()
            judge = Judge(posed(seed), (options.keep or pathlib.Path(temporary)) / str(seed))
            faults = judge.judge()
            failed += bool(faults)
            print(f"{seed:4} {'FAILS' if faults else 'holds'} {time.monotonic() - start:5.1f} s  {judge.posed}", flush=True)
            for fault in faults:
                print("       ", fault, flush=True)
    print(f"{len(seeds) - failed} hold, {failed} fail")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
