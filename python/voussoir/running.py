"""One run of the program: started, watched, stopped, read.

    result = voussoir.run("xml/arch.xml", ranks=2, progress=print)
"""

import pathlib
import queue
import tempfile
import threading
import time

from . import program
from .result import Result

GRACE = 60.0  # s that a run which was asked to stop may take for its last solve and its checkpoint


class Progress:
    """What a run has said last and how long it has been at it."""

    def __init__(self, line, seconds):
        self.line, self.seconds = line, seconds

    def __str__(self):
        return f"[{self.seconds:.0f} s] {self.line}"


def options_of(set=None, **options):
    """Options of the program as it takes them: set={"joints/dry/cohesion": 1e5}, overwrite=True, at_most="5min"."""
    words = [word for path, value in (set or {}).items() for word in ("--set", f"{path}={value_text(value)}")]
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            words.append(option)
        elif value is not None and value is not False:
            words.append(f"{option}={value}")
    return words


def value_text(value):
    """As a scene writes it: the shortest text that reads back as the same number."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) or hasattr(value, "dtype"):
        number = float(value)
        return str(int(number)) if number.is_integer() and abs(number) < 1e15 else repr(number)
    return str(value)


def run(scene, out=None, ranks=1, progress=None, report=False, **options):
    """Computes a scene and returns its Result, whatever its outcome; InputError where the program refuses it.

    scene     a Scene, or the path of one
    out       folder of the results (default: out/ and the name of the scene)
    progress  is called with a Progress for every line that the program says
    report    whether the report is drawn
    options   those of the program: set={path: value}, overwrite, restart, restart_from, limit_analysis, trust, at_most,
              verbose

    Ctrl-C makes the program save its state and end; KeyboardInterrupt goes on when it has, and restart=True goes on with
    the run. A second one kills it.
    """
    with tempfile.TemporaryDirectory() as place:
        path = scene.write(pathlib.Path(place) / f"{scene.name}.xml") if hasattr(scene, "write") else program.find_scene(scene)
        folder = pathlib.Path(out if out is not None else pathlib.Path("out") / path.stem)
        code, said = _go(path, folder, ranks, progress, options_of(**options))
    result = Result(folder, code, said)
    if code == program.WRONG_INPUT:
        raise program.InputError(said.strip())
    if code not in (program.DONE, program.NO_CONVERGENCE, program.STOPPED):
        raise program.ResourceError(said.strip() or f"the program ended with code {code}")
    if report:
        result.report()
    return result


def _go(path, folder, ranks, progress, options):
    """Exit code and words of a run that has ended."""
    import subprocess

    began, said, lines = time.monotonic(), [], queue.Queue()
    process = program.start([f"--xml={path}", f"--out={folder}", *options], ranks, subprocess.PIPE)

    def listen():
        with process.stdout:
            for line in process.stdout:
                lines.put(line)
        lines.put(None)

    threading.Thread(target=listen, daemon=True).start()
    try:
        for line in iter(lines.get, None):
            said.append(line)
            if progress and line.strip():
                progress(Progress(line.rstrip(), time.monotonic() - began))
        return process.wait(), "".join(said)
    except BaseException:  # Ctrl-C, and what the callback throws
        program.ask_to_stop(process)
        try:
            process.wait(GRACE)
        except BaseException:
            program.kill(process)
            raise
        raise
    finally:
        if process.poll() is None:
            program.kill(process)


def validate(scene, set=None, trust=False):
    """What the program understood of a scene; InputError with its words where it refuses it."""
    with tempfile.TemporaryDirectory() as place:
        path = scene.write(pathlib.Path(place) / f"{scene.name}.xml") if hasattr(scene, "write") else program.find_scene(scene)
        return program.answer(f"--xml={path}", "--validate", *options_of(set=set, trust=trust))
