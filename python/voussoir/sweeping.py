"""One scene computed for many values of its parameters, several runs side by side.

    table = voussoir.sweep("xml/arch.xml", {"joints/dry/friction coefficient": [0.4, 0.5, 0.6]})

A folder holds a sweep: `sweep.csv` with a row for each combination, `sweep.json` with what was asked, `sweep.html`, and
below `runs/` the results of every run with its row. What is done is not run again. A run that was stopped goes on from
its checkpoint; one that found a resource missing, or crashed, is run afresh.
"""

import concurrent.futures
import fcntl
import json
import os
import pathlib
import subprocess
import sys
import time
import xml.etree.ElementTree as tree

from . import program, sweep_inputs, sweep_table
from .program import InputError, write_atomically
from .running import GRACE, options_of, value_text
from .scene import Scene

ROW, LOG, ERRORS = "row.json", "run.log", "errors.log"
PAGE = "drivers/report/make_sweep.py"
POLL = 0.05  # s between two looks at the runs: far below the shortest of them
REMIND = 20.0  # s after which a sweep that has nothing new to say tells that it is still there
DECIDED = (program.DONE, program.WRONG_INPUT, program.NO_CONVERGENCE)  # exit codes of runs that need not be run again


def files_of(scene):
    """The scene and the files it names: its drawing and records, sought as the program seeks them."""
    found = {scene}
    try:
        named = [node.get("value", "") for node in tree.parse(scene).getroot().iter("Parameter") if node.get("type") == "string"]
    except tree.ParseError:
        named = []  # the program says what is wrong with it
    places = (scene.parent, scene.parent.parent, scene.parent.parent / "meshes")
    for name in named:
        paths = [place / name for place in places if name and len(name) < 250]
        there = next((path.resolve() for path in paths if path.exists()), None)
        if there and there.is_file():
            found.add(there)
        elif there:  # stones in space may be a folder of files
            found.update(path for path in there.iterdir() if path.is_file())
    return sorted(found)


class Job:
    """One combination: its folder, its row, and its process while it runs."""

    def __init__(self, sweep, combo, name):
        self.sweep, self.combo, self.name = sweep, combo, name
        self.folder = sweep.out / "runs" / name
        self.process = self.began = self.row = self.lock = None
        self.drawing = False

    def words(self):
        short = sweep_inputs.short_names(list(self.sweep.inputs))
        return ", ".join(f"{short[path]} = {value}" for path, value in zip(self.sweep.inputs, self.combo))

    def options(self):
        sets = [word for path, value in zip(self.sweep.inputs, self.combo) for word in ("--set", f"{path}={value}")]
        return [f"--xml={self.sweep.scene}", *sets, *self.sweep.options]

    def refusal(self):
        """Words of the program, or "" where it takes the combination."""
        if self.row:
            return ""
        try:
            program.answer(*self.options(), "--validate")
        except InputError as refused:
            return str(refused)
        return ""

    def restore(self):
        """The row of an earlier sweep, if this run is done."""
        path = self.folder / ROW
        try:
            row = json.loads(path.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return
        if row.get("exit_code") in DECIDED:
            self.row = row

    def can_start(self):
        """Not while a run of a sweep that was killed is still saving its state here."""
        self.folder.mkdir(parents=True, exist_ok=True)
        held = os.open(self.folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return True
        except OSError:
            return False
        finally:
            os.close(held)

    def start(self, afresh=False):
        stopped = (self.folder / "checkpoint.h5").exists() and not (self.folder / "result.json").exists()
        self.goes_on = stopped and not afresh and "--limit-analysis" not in self.sweep.options
        (self.folder / ROW).unlink(missing_ok=True)
        (self.folder / "report.html").unlink(missing_ok=True)
        self.began = time.monotonic()
        with open(self.folder / LOG, "w", encoding="utf-8") as log, open(self.folder / ERRORS, "w", encoding="utf-8") as errors:
            self.process = program.start([*self.options(), f"--out={self.folder}", "--restart" if self.goes_on else "--overwrite"],
                                         self.sweep.ranks, log, errors)

    def draw(self):
        """The report, as part of the same place among the runs."""
        self.drawing = True
        with open(self.folder / "report.log", "w", encoding="utf-8") as log:
            self.process = subprocess.Popen(["/usr/bin/python3", "-B", str(program.repository() / program.REPORT), str(self.folder)],
                                            stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
                                            start_new_session=True, preexec_fn=program.ends_with_parent)

    def at_work(self):
        return f"report of {self.words()}" if self.drawing else f"{self.words()} ({time.monotonic() - self.began:.0f} s)"

    def wants_report(self):
        return (self.sweep.reports and self.row.get("exit_code") != program.WRONG_INPUT
                and (self.folder / "fields.h5").exists() and not (self.folder / "report.html").exists())

    def ended(self):
        """Takes note of a process that has ended; whether there is nothing more to do."""
        if self.drawing:
            if self.process.returncode == 0:
                (self.folder / "report.log").unlink(missing_ok=True)
            return True
        code = self.process.returncode
        if self.goes_on and code in (program.WRONG_INPUT, program.NO_RESOURCE):
            self.start(afresh=True)  # its checkpoint is of no use
            return False
        self.row = sweep_table.read_row(self.folder, code, self.last_words(), time.monotonic() - self.began)
        write_atomically(self.folder / ROW, json.dumps(self.row, indent=1) + "\n")
        if not self.wants_report() or self.sweep.stopping:
            return True
        self.draw()
        return False

    def last_words(self):
        """Of a run that found no result: its error, else the last paragraph that it said."""
        error, said = ((self.folder / name).read_text(encoding="utf-8", errors="replace").strip() for name in (ERRORS, LOG))
        return error or said.split("\n\n")[-1]

    def table_row(self):
        row = {"run": self.name, **dict(zip(self.sweep.inputs, self.combo)), **(self.row or {"outcome": "not_run"})}
        if (self.folder / "report.html").exists():
            row["report"] = f"runs/{self.name}/report.html"
        return row


class Sweep:
    """What is asked, and the runs that answer it."""

    def __init__(self, scene, inputs, out=None, together=False, jobs=None, ranks=1, reports=True, envelope=False,
                 overwrite=False, options=(), say=print):
        self.scene, self.inputs, self.together = program.find_scene(scene), inputs, together
        self.out = pathlib.Path(out if out is not None else pathlib.Path("out") / f"sweep-{self.scene.stem}").absolute()
        self.ranks, self.reports, self.envelope, self.overwrite = ranks, reports, envelope, overwrite
        self.options, self.say, self.stopping, self.lock = list(options), say, False, None
        self.jobs = jobs or max(1, program.physical_cores() // ranks)
        combos = sweep_inputs.combinations(inputs, together)
        self.all = [Job(self, combo, name) for combo, name in zip(combos, sweep_inputs.folder_names(inputs, combos))]

    # What is wrong is said before anything is computed.

    def refuse_what_is_wrong(self):
        """Every value is shown to the program with the first values of the others, and where it refuses that with the last
        ones; a value that it refuses both times is refused. Combinations that are wrong together become rows."""
        answers = {}
        with_value = [[job for job in self.all if job.combo[position] == value]
                      for position, values in enumerate(self.inputs.values()) for value in values]
        for which in (0, -1):
            asked = list(dict.fromkeys(jobs[which] for jobs in with_value if jobs[which] not in answers))
            with concurrent.futures.ThreadPoolExecutor(self.jobs) as side_by_side:
                answers.update(zip(asked, side_by_side.map(Job.refusal, asked)))
            with_value = [jobs for jobs in with_value if answers[jobs[which]]]
        if with_value:
            raise InputError(answers[with_value[0][0]])

    def asked(self):
        """What an earlier sweep in the same folder must have been asked too."""
        return {"scene": str(self.scene), "files": {str(path): program.digest(path) for path in files_of(self.scene)},
                "program": program.digest(program.find_program()), "options": self.options}

    def open_folder(self):
        """One sweep at a time; one of another scene or program is not mixed with this one."""
        (self.out / "runs").mkdir(parents=True, exist_ok=True)
        self.lock = os.open(self.out, os.O_RDONLY | os.O_DIRECTORY)
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise program.ResourceError(f"{self.out}: another sweep is at work here\n  and two would run the same.\n"
                                        "  Wait for its end, or give another folder with --out.") from None
        asked, path = self.asked(), self.out / "sweep.json"
        earlier = json.loads(path.read_text(encoding="utf-8")).get("asked") if path.exists() else None
        changed = [what for what in asked if earlier and earlier.get(what) != asked[what]]
        if changed and not self.overwrite:
            named = {"scene": f"another scene ({earlier.get('scene')})", "files": changed_files(earlier, asked), "program": "another program",
                     "options": f"other options ({' '.join(earlier.get('options', [])) or 'none'})"}
            raise InputError(f"{self.out}: holds a sweep with {', '.join(named[what] for what in changed)}\n"
                             "  so that its rows would not belong to these.\n"
                             "  Give another folder with --out, or --overwrite to compute all runs again.")
        if not self.overwrite:
            for job in self.all:
                job.restore()
        return asked

    def write_question(self, asked):
        scene = Scene.read(self.scene)
        units = {path: unit for path in self.inputs if (unit := scene.unit(path))}
        write_atomically(self.out / "sweep.json", json.dumps(
            {"asked": asked, "title": scene["title"] if "title" in scene else "", "inputs": self.inputs, "units": units, "zip": self.together,
             "envelope": self.envelope}, indent=1) + "\n")

    # The runs.

    def go(self):
        """All that is missing is run. The rows; KeyboardInterrupt goes on when all runs have saved their state."""
        try:
            return self._go()
        finally:
            if self.lock is not None:
                os.close(self.lock)  # the same process may sweep here again
                self.lock = None

    def _go(self):
        goes_on = (self.out / "sweep.json").exists()
        if not goes_on:  # what is refused leaves no folder behind
            self.refuse_what_is_wrong()
        asked = self.open_folder()
        if goes_on:
            self.refuse_what_is_wrong()
        self.write_question(asked)
        if self.overwrite:
            for job in self.all:
                (job.folder / ROW).unlink(missing_ok=True)
        waiting, running = [job for job in self.all if not job.row], []
        undrawn = [job for job in self.all if job.row and job.wants_report()]
        self.say(f"{program.counted(len(self.all), 'combination')}, {len(self.all) - len(waiting)} of them done before; "
                 f"{min(self.jobs, max(1, len(waiting)))} at a time on {program.counted(self.ranks, 'rank')} each.")
        self.write()
        try:
            self.work_through(waiting, running, undrawn)
        except BaseException:
            self.stop(running)
            raise
        finally:
            self.write()
        return self.rows()

    def work_through(self, waiting, running, undrawn):
        told = time.monotonic()
        while waiting or running or undrawn:
            self.fill(waiting, running, undrawn)
            for job in [job for job in running if job.process.poll() is not None]:
                computed = not job.drawing
                if job.ended():
                    running.remove(job)
                if computed and job.row:
                    self.write()
                    self.tell(job)
                    told = time.monotonic()
            if time.monotonic() - told > REMIND and running:
                told = time.monotonic()
                self.say(f"... {program.counted(len(waiting), 'waits', 'wait')}, at work: " + "; ".join(job.at_work() for job in running))
            time.sleep(POLL)

    def fill(self, waiting, running, undrawn):
        """Starts as many as there is room for."""
        while undrawn and len(running) < self.jobs:
            running.append(undrawn.pop())
            running[-1].draw()
        for job in list(waiting):
            if len(running) >= self.jobs:
                return
            if job.can_start():
                waiting.remove(job)
                running.append(job)
                job.start()

    def stop(self, running):
        """Runs save their state and end; the second Ctrl-C kills them."""
        self.stopping = True
        computing = sum(not job.drawing for job in running)
        self.say(f"Stopping: {program.counted(computing, 'run saves its state', 'runs save their state')} ...")
        for job in running:
            program.kill(job.process) if job.drawing else program.ask_to_stop(job.process)
        try:
            for job in running:
                if not job.drawing:
                    job.process.wait(GRACE)
                    job.ended()
                    if job.drawing:
                        program.kill(job.process)
        except BaseException:
            for job in running:
                program.kill(job.process)
            raise

    def tell(self, job):
        done = sum(other.row is not None for other in self.all)
        row, words = job.row, job.row["outcome"].replace("_", " ")
        factor = [f"{row[key]:.4g}" for key in ("factor_stands", "factor_falls") if row.get(key) is not None]
        if factor:
            words += f", factor {' to '.join(dict.fromkeys(factor))}"
        elif row.get("largest_displacement_m") is not None:
            words += f", largest displacement {1e3 * row['largest_displacement_m']:.4g} mm"
        if row["outcome"] in ("refused", "no_resource", "crashed"):
            words += f": {row.get('message', '')}"
        self.say(f"[{done}/{len(self.all)}] {job.words()}: {words} ({row['seconds']:.3g} s)")

    # What it leaves behind.

    def rows(self):
        return [job.table_row() for job in self.all]

    def write(self):
        sweep_table.write_table(self.out / "sweep.csv", list(self.inputs), self.rows())

    def draw(self):
        """sweep.html and sweep.svg; the path of the page, or None where the repository with its drawing is not there."""
        self.write()
        if self.envelope:
            found = sweep_table.envelope(list(self.inputs), self.rows())
            write_atomically(self.out / "envelope.json", json.dumps(found, indent=1) + "\n")
        home = program.repository()
        if not home or not (home / PAGE).exists():
            return None
        done = subprocess.run(["/usr/bin/python3", "-B", str(home / PAGE), str(self.out)], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print(f"The page could not be drawn: {done.stderr.strip()}", file=sys.stderr)
            return None
        return self.out / "sweep.html"


def changed_files(earlier, now):
    before, after = earlier.get("files", {}), now["files"]
    names = sorted(pathlib.Path(path).name for path in {**before, **after} if before.get(path) != after.get(path))
    return f"other content of {', '.join(names)}"


def sweep(scene, inputs, together=False, out=None, jobs=None, ranks=1, reports=False, page=True, envelope=False,
          overwrite=False, say=None, **options):
    """Computes a scene for all combinations of values, or with `together` for the first of each, the second of each, ...

    inputs   {"path/of/key": [values]}
    reports  whether the report of every run is drawn; page: whether sweep.html and its picture are
    options  those of the program, as of run(): limit_analysis=True, trust=True

    Returns the rows of sweep.csv as dictionaries. Ctrl-C: the same call goes on where this one was stopped.
    """
    if hasattr(scene, "write"):
        raise InputError("A sweep asks for the file of a scene\n  because it must find it unchanged when it goes on.\n"
                         "  Write the scene with scene.write(path), and give that path.")
    texts = {sweep_inputs.plain_path(path): [value_text(value) for value in values] for path, values in inputs.items()}
    work = Sweep(scene, texts, out, together, jobs, ranks, reports, envelope, overwrite, options_of(**options), say or (lambda _: None))
    rows = work.go()
    if page:
        work.draw()
    return rows
