"""Whatever ends a run ends what it has started: processes of gmsh go with the program, with a rank and with mpirun.

    killed_while_meshing.py PROGRAM MPIEXEC

The drawing takes minutes to mesh; the run is ended some moments after gmsh has begun. Processes are told from others by
a variable of their environment, which the program's own processes share with it.
"""

import os
import pathlib
import signal
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
import stones

INTERRUPTED = 5
MARK = "VOUSSOIR_KILLED_WHILE_MESHING"
PATIENCE = 60  # seconds for what takes a moment on an idle machine
# Quadrilaterals of some 400 000 triangles: their blossom takes minutes.
SLOW = stones.geo({"s": stones.rectangle(0, 0, 1, 1)}, 0.0025, {"ground": ("s", 0)}) + "Recombine Surface{1};\n"


def alive(pid):
    try:
        state = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state not in "ZX"


def wait_until(holds):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if holds():
            return True
        time.sleep(0.05)
    return False


class KilledWhileMeshing(program.SceneTest):
    def processes(self):
        """Numbers and parents of the processes of the program and of voussoir-gmsh that this test has begun."""
        found, mark = {}, f"{MARK}={self.folder}".encode()
        for path in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                name = (path / "cmdline").read_bytes().split(b"\0")[0]
                marked = mark in (path / "environ").read_bytes().split(b"\0")
                parent = int((path / "stat").read_text().rsplit(")", 1)[1].split()[1])
            except (OSError, IndexError):
                continue
            if marked and name.endswith((b"voussoir", b"voussoir-gmsh")) and alive(int(path.name)):
                found[int(path.name)] = parent
        return found

    def begin(self, ranks):
        (self.folder / "stones.geo").write_text(SLOW)
        (self.folder / "slow.xml").write_text(stones.scene("stones.geo", ["ground"], {}, {"own": stones.OWN_WEIGHT}))
        launch = [program.MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        run = subprocess.Popen([*launch, program.PROGRAM, f"--xml={self.folder / 'slow.xml'}",
                                f"--out={self.folder / 'out'}"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               text=True, start_new_session=True, env={**os.environ, **program.ENVIRONMENT, MARK: str(self.folder)})
        self.addCleanup(self.end, run)

        def meshes():  # every rank, and of the first a process that waits and one that meshes, not only looks
            first = set(self.processes())
            time.sleep(0.5)
            return len(first) == ranks + 2 and first == set(self.processes())

        self.assertTrue(wait_until(meshes), self.processes())
        return run

    def end(self, run):
        if run.poll() is None:
            os.killpg(run.pid, signal.SIGKILL)
        run.communicate()

    def nobody_is_left(self):
        self.assertTrue(wait_until(lambda: not self.processes()), self.processes())

    def ranks(self):
        """Processes of the program whose parents are none of it."""
        all_of_them = self.processes()
        return [pid for pid, parent in all_of_them.items() if parent not in all_of_them]

    def test_of_the_program(self):
        run = self.begin(1)
        os.kill(run.pid, signal.SIGKILL)
        self.nobody_is_left()

    def test_of_a_rank(self):
        run = self.begin(2)
        parents = self.processes().values()
        meshing = [pid for pid in self.ranks() if any(parent != pid and self.processes().get(parent) == pid
                                                      for parent in parents)]
        os.kill(meshing[0], signal.SIGKILL)
        self.nobody_is_left()
        self.assertNotEqual(run.wait(timeout=PATIENCE), 0)

    def test_of_mpirun(self):
        run = self.begin(2)
        os.kill(run.pid, signal.SIGKILL)
        self.nobody_is_left()

    def test_a_signal_that_asks_to_stop_is_heard(self):
        for number in (signal.SIGTERM, signal.SIGUSR1):
            run = self.begin(1)
            run.send_signal(number)
            said = run.communicate(timeout=PATIENCE)[0]
            self.assertEqual(run.returncode, INTERRUPTED, said)
            self.assertIn("Stopped while gmsh meshed", said)
            self.nobody_is_left()

    def test_gmsh_that_is_ended_alone_has_not_crashed(self):
        for number, name in ((signal.SIGTERM, "Terminated"), (signal.SIGKILL, "Killed")):
            run = self.begin(1)
            found = self.processes()
            child = [pid for pid, parent in found.items() if found.get(parent) == run.pid]
            os.kill(child[0], number)
            said = run.communicate(timeout=PATIENCE)[0]
            self.assertIn(f"ended by a signal ({name})", said)
            self.assertNotIn("gmsh crash", said)
            self.nobody_is_left()


if __name__ == "__main__":
    program.main()
