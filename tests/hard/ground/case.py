"""A case of the proving ground: a scene, what it must come to, and what its results are compared with."""

import csv
import dataclasses
import json
import math
import os
import re
import shutil
import signal
import subprocess
import time
import typing

import scenes

CONVERGED, COLLAPSE, INPUT_ERROR, STOPPED = "converged", "collapse", "input error", "stopped"
OUTCOMES = {(0, "equilibrium"): CONVERGED, (0, "collapse"): COLLAPSE, (3, "collapse"): COLLAPSE,
            (3, "not_converged"): STOPPED, (2, None): INPUT_ERROR, (4, None): STOPPED}
# Contact is closed to this share of the largest force unless a scene asks for less (newton > tolerance).
TOLERANCE = 1e-8
ENERGIES = ("elastic_J", "kinetic_J", "external_work_J", "friction_J")


class Near(typing.NamedTuple):
    """A comparison: |got - want| <= tolerance, relative to want unless want is zero."""
    what: str
    got: float
    want: float
    tolerance: float

    def deviation(self):
        return abs(self.got - self.want) / (abs(self.want) or 1.0)

    def holds(self):
        return math.isfinite(self.got) and self.deviation() <= self.tolerance


class Most(typing.NamedTuple):
    """A comparison: got <= most."""
    what: str
    got: float
    most: float

    def deviation(self):
        return self.got

    def holds(self):
        return math.isfinite(self.got) and self.got <= self.most


# What tests of several ranks need where cores are few and users are root; see cmake/voussoir_add_test.cmake.
ENVIRONMENT = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
               "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_hwloc_base_binding_policy": "none"}


@dataclasses.dataclass
class Case:
    group: str
    name: str
    scene: typing.Callable[[], dict]
    expect: str = CONVERGED
    words: str = ""  # regular expression that what the program says must hold
    check: typing.Callable = None  # of a Run; yields Near and Most
    quick: bool = False  # part of the default tests
    ranks: int = 1
    seconds: int = 120  # after which a case counts as hanging
    fails: str = ""  # what goes wrong, where that is known

    @property
    def title(self):
        return f"{self.group}: {self.name}"


CASES = []


def case(group, name, scene, expect=CONVERGED, **how):
    CASES.append(Case(group, name, scene, expect, **how))


class Run:
    """One run of the program and what it left behind."""

    def __init__(self, program, folder, content, ranks, seconds, mpiexec):
        self.how = (program, mpiexec)
        self.folder, self.limit = folder, seconds
        self.out = folder / "out"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        path = content if isinstance(content, os.PathLike) else scenes.write(content, folder)
        launch = [mpiexec, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        start = time.monotonic()
        with open(folder / "said.txt", "w", encoding="utf-8") as said:
            # A group of processes of its own, so that ranks do not outlive a time limit.
            process = subprocess.Popen([*launch, program, f"--xml={path}", f"--out={self.out}"], stdout=said,
                                       stderr=subprocess.STDOUT, start_new_session=True,
                                       env={**os.environ, **ENVIRONMENT})
            try:
                self.code = process.wait(timeout=seconds)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                self.code = None
        self.seconds = time.monotonic() - start
        self.said = (folder / "said.txt").read_text(encoding="utf-8", errors="replace")
        file = self.out / "result.json"
        self.result = json.loads(file.read_text()) if file.exists() else {}
        self.outcome = OUTCOMES.get((self.code, self.result.get("outcome")), self.crash())

    def crash(self):
        if self.code is None:
            return f"no end within {self.limit} s"
        return f"exit code {self.code}"

    def again(self, content, name="again"):
        """A run of another scene to compare with; it must not fail."""
        other = Run(self.how[0], self.folder / name, content, 1, self.limit, self.how[1])
        if other.outcome not in (CONVERGED, COLLAPSE):
            raise AssertionError(f"the scene to compare with: {other.outcome}")
        return other

    def message(self):
        """What the program said last of why it ended, in one line."""
        if "message" in self.result:
            return self.result["message"]
        lines = [line.strip() for line in self.said.splitlines() if line.strip()]
        return " ".join(lines[-4:])

    def history(self):
        with open(self.out / "history.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return [{key: number(value) for key, value in row.items()} for row in rows]

    def in_time(self):
        """Rows of the history that belong to time steps."""
        return [row for row in self.history() if row["time_s"] > 0]

    def reaction(self, component="y"):
        """Of all supports on the structure [N]."""
        return sum(r[f"{component}_N"] for r in self.result["statics"]["reactions"].values())

    def table(self, name, step=-1):
        """A table of fields.h5, of the last step unless told otherwise."""
        import h5py
        with h5py.File(self.out / "fields.h5") as file:
            if "/" in name:
                return file[name][:]
            return file["steps"][sorted(file["steps"])[step]][name][:]

    def imbalance(self):
        """Relative to the largest energy of the run: of time steps where it has some, else of load steps."""
        rows = self.history()
        scale = max((abs(row[key]) for row in rows for key in ENERGIES
                     if not math.isnan(row[key])), default=0)
        last = self.result["energy"]["imbalance_in_time_J" if self.result.get("time_s") else "imbalance_J"]
        return abs(last) / scale if scale else 0.0

    def faults(self):
        """What must not be in any result: numbers that are none, contact not met."""
        if not self.result:
            return
        for key in ("complementarity_residual", "largest_penetration_m", "largest_displacement_m"):
            if self.result.get(key) is None:
                yield f"{key} is no number"
        if any(value is None for value in self.result["energy"].values()):
            yield "an energy is no number"
        if self.outcome == CONVERGED and (self.result.get("complementarity_residual") or 0) > TOLERANCE:
            yield f"contact is open to {self.result['complementarity_residual']:.1e} of the largest force"


def number(text):
    try:
        return float(text)
    except ValueError:
        return text or math.nan


@dataclasses.dataclass
class Verdict:
    case: Case
    outcome: str
    faults: list
    worst: object
    run: Run

    @property
    def passed(self):
        return not self.faults

    @property
    def unexpected(self):
        return not self.passed and not self.case.fails


def judge(c, program, folder, mpiexec):
    """Runs a case and says what is wrong with its outcome."""
    run = Run(program, folder / re.sub(r"\W+", "-", c.title), c.scene(), c.ranks, c.seconds, mpiexec)
    faults, worst = [], None
    if run.outcome != c.expect:
        faults.append(f"{run.outcome} instead of {c.expect}: {run.message()[-300:]}")
    if c.words and not re.search(c.words, " ".join((run.said + run.result.get("message", "")).split())):
        faults.append(f"no words like '{c.words}' in: {run.message()[-300:]}")
    faults += run.faults()
    if not faults and c.check:
        try:
            comparisons = list(c.check(run))
        except Exception as error:  # a case that cannot be compared has failed; the others go on
            return Verdict(c, run.outcome, [f"could not be compared: {error!r}"], None, run)
        for comparison in comparisons:
            if not comparison.holds():
                faults.append(str(comparison))
        worst = max(comparisons, key=lambda x: x.deviation() / (x[-1] or 1e-300), default=None)
    return Verdict(c, run.outcome, faults, worst, run)
