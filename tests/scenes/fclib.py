"""Contact problems that were hard, as files of the FCLib collection: what is written is the problem, and is solved.

    fclib.py PROGRAM MPIEXEC
    fclib.py --check FILE.hdf5 ...     prints how far the solutions of files are from their problems

Set-up    Scenes whose problems the first way does not close: a doorway that is pushed sideways (plane), a wall with
          returns (space), a wall that slides on mortar, a wall that is shaken. Files are read by h5py alone, matrices are
          of scipy, and the problem is that of the FCLib report (INRIA RT-444):

              M v = H r + f,   u = H^T v + w,   K* contains u + mu |u_T| n, which is normal to r in K = {|r_T| <= mu r_N}

Expected  Every file with a solution satisfies it; a file whose solution is changed does not, nor one whose friction is.
          Problems do not depend on the number of ranks. The library of FCLib, where it is installed, reads the same.
Tolerance TOLERANCE, ten times what the scenes are solved to: the natural map is measured here with a stiffness of each
          point that is made from M and H, which differs from that of the program by a small factor.
"""

import ctypes
import pathlib
import sys
import unittest

import h5py
import numpy as np
import scipy.sparse

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import program  # noqa: E402  (a folder of its own)
from stones import xml  # noqa: E402

TOLERANCE = 1e-7  # of the largest contact force
LIBRARY = "libfclib.so.0"  # of Debian's package libfclib0


class Problem:
    """A global problem of a file."""

    def __init__(self, path):
        with h5py.File(path) as file:
            top = file["fclib_global"]
            self.components = int(top["spacedim"][0])
            self.m, self.h = self.matrix(top["M"]), self.matrix(top["H"])
            self.f, self.w, self.mu = (top["vectors"][name][:] for name in ("f", "w", "mu"))
            self.words = {key: value[0].decode() for key, value in top["info"].items()}
            self.solved = "solution" in file
            if self.solved:
                self.v, self.u, self.r = (file["solution"][name][:] for name in ("v", "u", "r"))
        assert self.m.shape == (len(self.f), len(self.f)) and self.h.shape == (len(self.f), len(self.w))
        assert len(self.w) == self.components * len(self.mu)

    @staticmethod
    def matrix(group):
        rows, columns, kind, count = (int(group[name][0]) for name in ("m", "n", "nz", "nzmax"))
        assert kind == -1 and len(group["x"]) == len(group["i"]) == count, "compressed columns"
        return scipy.sparse.csc_matrix((group["x"][:], group["i"][:], group["p"][:]), shape=(rows, columns))

    def stiffness_at_points(self):
        """[N/m] what a point feels of the nodes it holds on to, each alone."""
        give = (self.h.power(2).T @ (1 / self.m.diagonal())).reshape(-1, self.components)
        return 1 / give.max(axis=1)

    def project(self, r):
        """The nearest points of the cones |r_T| <= mu r_N."""
        normal, shear = r[:, 0], np.linalg.norm(r[:, 1:], axis=1)
        inside, polar = shear <= self.mu * normal, self.mu * shear <= -normal
        onto = (normal + self.mu * shear) / (1 + self.mu**2)
        there = np.column_stack([onto, (self.mu * onto / np.where(shear > 0, shear, 1))[:, None] * r[:, 1:]])
        return np.where(inside[:, None], r, np.where(polar[:, None], 0, there))

    def off(self):
        """How far the solution is from the problem, relative to the largest contact force: balance, motion, law."""
        scale = np.abs(self.r).max()
        k = self.stiffness_at_points()
        r, u = self.r.reshape(-1, self.components), self.u.reshape(-1, self.components)
        modified = u.copy()
        modified[:, 0] += self.mu * np.linalg.norm(u[:, 1:], axis=1)
        return {"balance": np.abs(self.m @ self.v - self.h @ self.r - self.f).max() / scale,
                "motion": np.abs((self.h.T @ self.v + self.w - self.u).reshape(-1, self.components) * k[:, None]).max() / scale,
                "law": np.abs(r - self.project(r - k[:, None] * modified)).max() / scale}


def library():
    try:
        return ctypes.CDLL(LIBRARY)
    except OSError:
        return None


class Matrix(ctypes.Structure):
    """As the interface of the library declares it."""
    _fields_ = [("nzmax", ctypes.c_int), ("m", ctypes.c_int), ("n", ctypes.c_int), ("p", ctypes.POINTER(ctypes.c_int)),
                ("i", ctypes.POINTER(ctypes.c_int)), ("x", ctypes.POINTER(ctypes.c_double)), ("nz", ctypes.c_int),
                ("info", ctypes.c_void_p)]


class Global(ctypes.Structure):
    _fields_ = [("M", ctypes.POINTER(Matrix)), ("H", ctypes.POINTER(Matrix)), ("G", ctypes.POINTER(Matrix)),
                *((name, ctypes.POINTER(ctypes.c_double)) for name in ("mu", "f", "b", "w")), ("spacedim", ctypes.c_int),
                ("info", ctypes.POINTER(ctypes.c_char_p))]


class Solution(ctypes.Structure):
    _fields_ = [(name, ctypes.POINTER(ctypes.c_double)) for name in ("v", "u", "r", "l")]


WALL_MASS = 6 * 4 * 0.5 * 0.25 * 2000.0  # [kg], a 24th of it at the nodes that are held


def wall(stages=None, friction=0.4, internals=None, newton=None, **law):
    """A wall that is pushed, with every point as contact. Active sets are given one solve, so that every problem is hard."""
    return xml("wall", {
        "mesh": {"type": "wall", "wall": {"courses": 6, "blocks per course": 4, "block length": 0.5, "block height": 0.25,
                                          "cells along": 2, "cells up": 2, "cells": "quadrilateral"}},
        "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
        "joints": {"dry": {"friction coefficient": friction, **law}}, "supports": {"ground": {"on": "base"}},
        "loads": {"weight": {"type": "self weight"}, "push": {"type": "acceleration", "ax": 9.81}},
        "steps": {"stages": stages or {"rest": REST, "push": PUSH}}, "selection": {"mode": "all"},
        "newton": newton or {}, "internals": internals or {"contact solver": {"fast solves": 1, "back off": False}}}) + "\n"


REST, PUSH = {"loads": {"weight": 1.0}}, {"loads": {"weight": 1.0, "push": 0.3}}


class Fclib(program.SceneTest):
    def hard(self, scene, *options, out="out", ranks=1):
        run = self.run_scene(scene, f"--fclib={self.folder}/{out}.hdf5", *options, out=out, ranks=ranks)
        self.assertIn(run.code, (0, 3), run.said)
        return run, [Problem(path) for path in sorted(self.folder.glob(f"{out}-*.hdf5"))]

    def check(self, problem):
        off = problem.off()
        self.assertLess(max(off.values()), TOLERANCE, off)
        self.assertLess(abs(problem.m - problem.m.T).max(), 1e-12 * abs(problem.m).max())

    def test_plane_and_space(self):
        for name, components in (("doorway", 2), ("wall-with-returns", 3)):
            with self.subTest(name):
                run, problems = self.hard(ROOT / "xml" / f"{name}.xml", out=name)
                solved = [p for p in problems if p.solved]
                self.assertGreater(len(solved), 0, run.said)
                self.assertIn("hard", run.words)
                for problem in solved:
                    self.assertEqual(problem.components, components)
                    self.assertIn(name, problem.words["title"])
                    self.assertIn("A solution was found in", problem.words["description"])
                    self.check(problem)

    def test_mortar_is_a_spring_with_an_unknown_of_its_own(self):
        mortar = {"normal stiffness": 5e9, "tangential stiffness": 2e9}
        _, dry = self.hard(wall(), out="dry")
        _, springs = self.hard(wall(**mortar), out="springs")
        self.assertEqual(len(springs), 2)
        for problem in springs:
            self.check(problem)
            self.assertEqual(problem.m.shape[0], dry[0].m.shape[0] + len(problem.w))

    def test_a_time_step_is_a_problem_with_inertia(self):
        shaken = {"rest": REST, "shake": {**PUSH, "duration": 0.02, "time step": 0.005}}
        _, (at_rest, *_) = self.hard(wall(), out="rest")
        _, problems = self.hard(wall(shaken), out="time")
        self.assertGreater(len(problems), 2)
        for problem in problems:
            self.check(problem)
            self.assertIn("positive definite", problem.words["math_info"])
            inertia = problem.m - at_rest.m  # 4 / dt^2 of the masses that no support holds, along x and along y
            self.assertLess(abs(inertia.sum() / 2 / (4 / 0.005**2) / (WALL_MASS * 23 / 24) - 1), 0.03)

    def test_what_is_given_up_is_a_problem_without_a_solution(self):
        run, problems = self.hard(wall({"rest": REST}, newton={"largest iterations": 5}))
        self.assertEqual(run.outcome, "not_converged", run.said)
        self.assertGreater(len(problems), 0)
        for problem in problems:
            self.assertFalse(problem.solved)
            self.assertIn("No solution is given", problem.words["description"])

    def test_ranks_state_the_same(self):
        runs = {ranks: self.hard(wall(), out=f"ranks{ranks}", ranks=ranks)[1] for ranks in (1, 2, 4)}
        for ranks in (2, 4):
            self.assertEqual(len(runs[ranks]), len(runs[1]))
            for one, other in zip(runs[1], runs[ranks]):
                self.check(other)
                for name in ("m", "h"):
                    a, b = getattr(one, name), getattr(other, name)
                    self.assertLess(abs(a - b).max(), 1e-12 * abs(a).max(), name)
                np.testing.assert_array_equal(one.mu, other.mu)
                self.assertLess(np.abs(one.f - other.f).max(), 1e-9 * np.abs(one.r).max())
                self.assertLess(np.abs(one.w - other.w).max(), 1e-6 * np.abs(one.v).max())

    def test_what_is_no_solution_is_found_out(self):
        _, problems = self.hard(wall())
        pushed = problems[-1]
        self.check(pushed)
        slips = np.linalg.norm(pushed.u.reshape(-1, 2)[:, 1:], axis=1) > 1e-6
        self.assertTrue(slips.any())
        for name, factor in (("r", 1.001), ("v", 1.001), ("u", 1.1), ("mu", 0.99)):
            kept = getattr(pushed, name)
            setattr(pushed, name, factor * kept)
            self.assertGreater(max(pushed.off().values()), 100 * TOLERANCE, name)
            setattr(pushed, name, kept)

    @unittest.skipIf(library() is None, f"{LIBRARY} is not installed")
    def test_the_library_of_fclib_reads_it(self):
        _, problems = self.hard(wall())
        read, solution = library().fclib_read_global, library().fclib_read_solution
        read.restype, solution.restype = ctypes.POINTER(Global), ctypes.POINTER(Solution)
        path = str(self.folder / "out-0002.hdf5").encode()
        theirs, ours = read(path).contents, problems[1]
        self.assertEqual(theirs.spacedim, 2)
        for name, matrix in (("M", ours.m), ("H", ours.h)):
            a = getattr(theirs, name).contents
            self.assertEqual((a.m, a.n, a.nz, a.nzmax), (*matrix.shape, -1, matrix.nnz))
            self.assertEqual(a.x[:a.nzmax], list(matrix.data))
            self.assertEqual(a.i[:a.nzmax], list(matrix.indices))
        self.assertEqual(theirs.w[:len(ours.w)], list(ours.w))
        self.assertEqual(theirs.mu[:len(ours.mu)], list(ours.mu))
        self.assertEqual(theirs.info[0].decode(), ours.words["title"])
        self.assertEqual(solution(path).contents.v[:len(ours.v)], list(ours.v))

    def test_nothing_is_overwritten_and_a_restart_goes_on(self):
        whole = wall()
        first, _ = self.hard(wall({"rest": REST}))
        before = (self.folder / "out-0001.hdf5").read_bytes()
        again = self.run_scene(whole, f"--fclib={self.folder}/out.hdf5", "--overwrite")
        self.assertEqual(again.code, 2, again.said)
        for words in ("out-0001.hdf5", "nothing is overwritten", "Give another name"):
            self.assertIn(words, again.words)
        more, problems = self.hard(whole, "--restart")
        self.assertEqual(len(problems), 2, first.said + more.said)
        self.assertEqual((self.folder / "out-0001.hdf5").read_bytes(), before)
        self.assertIn("1 contact problem was hard", more.words)

    def test_what_cannot_be_is_refused(self):
        for name, words in (("hard.txt", "ends with .hdf5 or .h5"), ("hard", "ends with .hdf5 or .h5"), (".hdf5", "ends with"),
                            ("none/hard.hdf5", "which is not there")):
            run = self.run_scene(wall(), f"--fclib={self.folder}/{name}")
            self.assertEqual(run.code, 2, run.said)
            self.assertIn(words, run.words)
        for law, words in (({"cohesion": 1e5}, "joints > dry > cohesion = 100000 [Pa]"),
                           ({"tension strength": 1e5}, "joints > dry > tension strength = 100000 [Pa]"),
                           ({"friction": float("inf")}, "joints > dry > friction coefficient = inf")):
            run = self.run_scene(wall(**law), f"--fclib={self.folder}/hard.hdf5", ranks=2)
            self.assertEqual(run.code, 2, run.said)
            self.assertIn(words, run.words)
            self.assertIn("Coulomb's friction alone", run.words)
        run = self.run_scene(wall(), f"--fclib={self.folder}/hard.hdf5", "--limit-analysis")
        self.assertEqual(run.code, 2, run.said)
        self.assertIn("--limit-analysis and --fclib", run.words)
        self.assertEqual(list(self.folder.glob("hard*")), [])

    def test_a_file_that_cannot_be_written_is_told_with_its_own_option(self):
        """Of these problems alone: results go elsewhere, and --out would not help."""
        (self.folder / "hard-0001.hdf5.part").mkdir()
        run = self.run_scene(wall(), f"--fclib={self.folder}/hard.hdf5")
        self.assertEqual(run.code, 4, run.said)
        self.assertIn("hard-0001.hdf5.part: cannot be written", run.words)
        self.assertIn("give another file with --fclib=FILE.hdf5", run.words)
        self.assertNotIn("--out", run.words)

    def test_where_nothing_is_hard_nothing_is_written(self):
        run, problems = self.hard(wall({"rest": REST}, internals={"contact solver": {"fast solves": 30}}))
        self.assertEqual(problems, [])
        self.assertIn("No contact problem was hard", run.words)


if __name__ == "__main__":
    if sys.argv[1] == "--check":
        for path in sys.argv[2:]:
            one = Problem(path)
            sizes = f"{one.m.shape[0]} unknowns, {len(one.mu)} points"
            print(f"{path}: {sizes}: " + (", ".join(f"{key} {value:.1e}" for key, value in one.off().items())
                                          if one.solved else "no solution"))
    else:
        program.main()
