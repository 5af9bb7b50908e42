"""Runs of one system on several numbers of ranks: started, kept, and told in one table.

A run is the program `scaling` with one system of a scene, every contact point selected, solved to 1e-8. It is kept in
DIR/runs/KIND-RANKS-REPETITION; what is there is not run again, so that jobs of a batch system may each bring their own
numbers of ranks to the same folder. rank_model.py predicts what the table tells.
"""
import csv
import io
import json
import math
import shutil
import subprocess
import sys
import xml.etree.ElementTree as tree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))
import rank_model  # noqa: E402
from geometry import counted  # noqa: E402
from voussoir import program  # noqa: E402

WALLS = ("wall", "wall in space")
ASKED, DONE = "asked.json", "done.json"  # of a study, of a run
LEAST_COURSES = 8
# Of the run on each number of ranks; what is counted of one iteration is of all ranks together.
COLUMNS = ("kind", "ranks", "blocks", "unknowns", "points", "clock_s", "processor_s", "work_s", "efficiency",
           "work_efficiency", "predicted_efficiency", "iterations", "messages", "predicted_messages", "kB", "predicted_kB",
           "sums", "memory_MB", "memory_over_share", "structure_over_share", "unknowns_imbalance", "points_imbalance", "seconds_imbalance", "cores")
SHOWN = {"clock_s": "s", "work_s": "work s", "efficiency": "efficiency", "work_efficiency": "of work",
         "predicted_efficiency": "predicted", "memory_MB": "MB", "memory_over_share": "over share", "structure_over_share": "without program",
         "unknowns_imbalance": "unknowns", "points_imbalance": "points", "seconds_imbalance": "seconds"}


def mesh_type(scene, changes):
    """Of a scene, with changes of the user; None where it names none."""
    for change in reversed(changes):
        path, _, value = change.partition("=")
        if path.strip() == "mesh/type":
            return value.strip()
    try:
        found = tree.parse(scene).getroot().find("ParameterList[@name='mesh']/Parameter[@name='type']")
    except tree.ParseError as error:
        raise program.InputError(f"scene = {scene}\n  is no XML: {error}.\n  Give the path of a scene.") from None
    return None if found is None else found.get("value")


def courses_of(blocks):
    """Of a wall as high as it is long in blocks."""
    return max(LEAST_COURSES, round(math.sqrt(blocks)))


class RankStudy:
    """What is asked of all runs of a folder.

    blocks  of the wall of each kind: "strong" of all ranks together, "weak" of each; of a scene that cannot grow None
    launch  words before the number of ranks, or none: mpirun, and one rank without it
    """

    def __init__(self, folder, scene, blocks, changes=(), launch=(), repeat=1, overwrite=False, say=print):
        self.folder, self.scene, self.blocks, self.changes = Path(folder), Path(scene), blocks, list(changes)
        self.launch, self.repeat, self.overwrite, self.say = list(launch), repeat, overwrite, say

    def system(self, kind, ranks):
        """Words for the program."""
        words = [f"--scene={self.scene}"] + [word for change in self.changes for word in ("--set", change)]
        if self.blocks[kind] is None:
            return ["--systems=scene", *words]
        courses = courses_of(self.blocks[kind] * (ranks if kind == "weak" else 1))
        return ["--systems=blocks", f"--smallest={courses}", f"--largest={courses}", *words]

    def go(self, ranks):
        """Runs what is not there yet."""
        found = program.find_program().parent / "scaling"
        if not found.exists():
            raise program.ResourceError(f"{found}\n  is not there, so that nothing can be measured.\n"
                                        "  Build it beside voussoir: ninja -C build/release scaling")
        self.remember({"program": program.digest(found), "scene": program.digest(self.scene), "--set": self.changes,
                       **{f"blocks ({kind})": blocks for kind, blocks in self.blocks.items()}})
        for kind in self.blocks:
            for number in ranks:
                for repetition in range(self.repeat):
                    self.run(found, kind, number, self.folder / "runs" / f"{kind}-{number}-{repetition}")

    def remember(self, asked):
        """All runs of a folder are of one program, scene and size; whoever asks for others is refused, or begins anew."""
        file = self.folder / ASKED
        before = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        other = [name for name, value in asked.items() if before.get(name, value) != value]
        if other and not self.overwrite:
            raise program.InputError(f"{self.folder}\n  holds runs with another {' and '.join(other)}.\n"
                                     "  Give another folder in --out, or --overwrite to compute all again.")
        if other:
            shutil.rmtree(self.folder / "runs", ignore_errors=True)
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            program.write_atomically(file, json.dumps({**({} if other else before), **asked}, indent=1) + "\n")
        except OSError as error:
            raise program.ResourceError(f"--out = {self.folder}\n  cannot be written to: {error.strerror}.") from None

    def run(self, found, kind, ranks, folder):
        if (folder / DONE).exists() and not self.overwrite:
            return
        self.say(f"{kind} scaling, {ranks} {'rank' if ranks == 1 else 'ranks'} ...")
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        self.start([*self.before(ranks), str(found), *self.system(kind, ranks), f"--out={folder}"], ranks, folder / "log")
        program.write_atomically(folder / DONE, json.dumps({"cores": program.physical_cores()}) + "\n")

    def before(self, ranks):
        return [*self.launch, str(ranks)] if self.launch else program.launch(ranks)

    @staticmethod
    def start(command, ranks, log):
        several = {"OMPI_MCA_mpi_yield_when_idle": "1"} if ranks > program.physical_cores() else {}
        with open(log, "w", encoding="utf-8") as output:
            try:
                process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                           start_new_session=True, env={**program.environment(), **several})
            except OSError as error:
                raise program.ResourceError(f"{command[0]}\n  cannot be started: {error.strerror}.\n"
                                            "  Give in --launch what starts ranks here, their number left out at its end.") from None
            try:
                code = process.wait()
            except BaseException:
                program.kill(process)
                raise
        if code == program.DONE:
            return
        said = log.read_text(encoding="utf-8", errors="replace").strip()
        if code == program.WRONG_INPUT:
            raise program.InputError(said)
        raise program.ResourceError(f"{' '.join(command)}\n  ended with code {code}; {log} holds what it said:\n"
                                    + "\n".join(said.splitlines()[-5:]))

    def runs(self, kind):
        """The fastest of each number of ranks that is there, fewest first, with the cores of its machine."""
        found = {}
        for done in (self.folder / "runs").glob(f"{kind}-*/{DONE}"):
            row = json.loads((done.parent / "systems.json").read_text(encoding="utf-8"))[0]
            row.update(json.loads(done.read_text(encoding="utf-8")))
            before = found.setdefault(row["ranks"], row)
            if row["solve_clock_s"] < before["solve_clock_s"]:
                found[row["ranks"]] = row
        return [found[ranks] for ranks in sorted(found)]


class Predicted:
    """What the model says of the runs of one kind, or nothing where it knows none of them."""

    def __init__(self, runs, network):
        several = [run for run in runs if run["ranks"] > 1 and run["level_rows"]]
        self.known = bool(several) and runs[0]["ranks"] == 1 and runs[0]["family"] != "scene" and bool(runs[0]["level_rows"])
        if not self.known:
            return
        fewest = min(run["ranks"] for run in several)
        self.widths = rank_model.Widths([run for run in several if run["ranks"] == fewest])
        self.machine = rank_model.Machine(runs, network)
        self.alone = runs[0]

    def seconds(self, run):
        return sum(rank_model.seconds(run["blocks"], run["ranks"], self.machine, self.widths, run["iterations"]).values())

    def of(self, run):
        if not self.known:
            return {}
        told = {"predicted_efficiency": rate(self.alone["blocks"], 1, self.seconds(self.alone), run, self.seconds(run))}
        if run["ranks"] > 1:
            counts = rank_model.predicted(run, self.widths)
            told["predicted_messages"] = sum(counts[f"{part} messages"] for part in rank_model.PARTS)
            told["predicted_kB"] = sum(counts[f"{part} bytes"] for part in rank_model.PARTS) / 1e3
        return told


def rate(blocks, ranks, seconds, run, of_run):
    """Blocks that a rank solves in a second, over those of the run compared with: efficiency of either kind."""
    return run["blocks"] / run["ranks"] / of_run / (blocks / ranks / seconds)


def row_of(kind, run, alone, predicted):
    counts = rank_model.measured(run)
    row = {"kind": kind, "ranks": run["ranks"], "blocks": run["blocks"], "unknowns": run["unknowns"],
           "points": run["candidate_points"], "clock_s": run["solve_clock_s"], "processor_s": run["solve_s"],
           "work_s": run["solve_work_s"], "iterations": run["iterations"],
           "messages": sum(counts[f"{part} messages"] for part in rank_model.PARTS),
           "kB": sum(counts[f"{part} bytes"] for part in rank_model.PARTS) / 1e3,
           "sums": counts["collectives"], "memory_MB": run["peak_memory_MB"],
           "unknowns_imbalance": run["unknowns_imbalance"], "points_imbalance": run["points_imbalance"],
           "seconds_imbalance": run["seconds_imbalance"], "cores": run["cores"], **predicted}
    if alone:
        for name, seconds in (("efficiency", "solve_clock_s"), ("work_efficiency", "solve_work_s")):
            row[name] = rate(alone["blocks"], 1, alone[seconds], run, run[seconds])
        for name, bare in (("memory_over_share", 0), ("structure_over_share", 1)):
            here, there = (r["peak_memory_MB"] - bare * r["bare_memory_MB"] for r in (run, alone))
            row[name] = rate(run["blocks"], run["ranks"], here, alone, there)
    return {name: row.get(name) for name in COLUMNS}


def table(study, network):
    """Rows of all runs that are there."""
    rows = []
    for kind in ("strong", "weak"):
        runs = study.runs(kind)
        if not runs:
            continue
        predicted = Predicted(runs, network)
        alone = runs[0] if runs[0]["ranks"] == 1 else None
        rows += [row_of(kind, run, alone, predicted.of(run)) for run in runs]
    return rows


def write(rows, folder):
    text = io.StringIO()
    writer = csv.DictWriter(text, fieldnames=COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows({name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()} for row in rows)
    program.write_atomically(folder / "ranks.csv", text.getvalue())


def cell(name, value):
    if value is None:
        return "-"
    if name.endswith("efficiency"):
        return f"{100 * value:.0f} %"
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def tell(rows, say):
    names = [name for name in COLUMNS if name not in ("kind", "processor_s", "cores")]
    for kind in ("strong", "weak"):
        cells = [[SHOWN.get(name, name.replace("_", " ")) for name in names]]
        cells += [[cell(name, row[name]) for name in names] for row in rows if row["kind"] == kind]
        if len(cells) == 1:
            continue
        widths = [max(len(line[k]) for line in cells) for k in range(len(names))]
        say(f"\n{kind} scaling: one linear solve, every point selected; messages, kB and sums of one iteration, all ranks;\n"
            "memory of the busiest rank, over its share of one rank's, and both without what the program takes before it has a\n"
            "structure; busiest rank over the mean of unknowns, points, seconds of work")
        for line in cells:
            say("  ".join(word.rjust(width) for word, width in zip(line, widths)))
    shared = sorted({row["ranks"] for row in rows if row["ranks"] > row["cores"]})
    if shared:
        last = counted(shared[-1], "rank") if len(shared) == 1 else f"{', '.join(map(str, shared))} ranks"
        say(f"\n{last} shared {counted(rows[0]['cores'], 'core')}: their seconds by the clock are none of a machine that\n"
            "has as many; counts, memory and seconds of work (of the processor outside MPI) hold.")
    if not any(row["efficiency"] for row in rows):
        say("\nEfficiency is over one rank, which is not there: run 1 rank into the same folder.")
