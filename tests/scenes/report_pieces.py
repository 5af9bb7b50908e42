"""Words and marks of a report that depend on what there is to tell.

    report_pieces.py PROGRAM
"""

import pathlib
import subprocess
import sys
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path("report_pieces").resolve()
PROGRAM = None
sys.path.insert(0, str(ROOT / "drivers" / "report"))
import draw_supports  # noqa: E402  (a folder of its own)
import make_report  # noqa: E402


class Stopped(unittest.TestCase):
    """A run whose time is over before its first step: what is not known is not told as 0."""

    def test_nothing_is_told_of_displacements_and_forces(self):
        out = FOLDER / "stopped"
        done = subprocess.run([PROGRAM, f"--xml={ROOT / 'xml/wall.xml'}", f"--out={out}", "--overwrite", "--quiet", "--at-most=0.001s"],
                              check=False)
        self.assertEqual(done.returncode, 5)
        subprocess.run([sys.executable, "-B", ROOT / "drivers/report/make_report.py", out], check=True, stdout=subprocess.DEVNULL)
        page = (out / "report.html").read_text(encoding="utf-8")
        self.assertIn("<dt>Steps</dt><dd>none", page)
        for absent in ("Largest displacement", "Load factor reached", "Error estimate", ">Tables</h2>"):
            self.assertNotIn(absent, page)


class Palettes(unittest.TestCase):
    """Pictures of lines and stones have palettes; a scale of colours, which would show steps, keeps them all."""

    def test_stresses_keep_all_colours(self):
        out, palette = FOLDER / "palettes", 3  # the kind of a PNG that has one, at byte 25
        subprocess.run([PROGRAM, f"--xml={ROOT / 'xml/arch.xml'}", f"--out={out}", "--overwrite", "--quiet"], check=True)
        subprocess.run([sys.executable, "-B", ROOT / "drivers/report/make_report.py", out], check=True, stdout=subprocess.DEVNULL)
        kinds = {path.stem: path.read_bytes()[25] for path in (out / "pictures").glob("*.png")}
        self.assertEqual({name for name, kind in kinds.items() if kind != palette}, {"stress"})


class Pieces(unittest.TestCase):
    """Words and marks that depend on what there is to tell."""

    def test_what_is_selected_is_told_of_all_some_one_and_none(self):
        words = make_report.selected_words
        self.assertEqual(words(4, 4), "at all of 4 candidate points (dark blue).")
        self.assertIn("1 of 4 candidate points (25.0 %) is selected", words(1, 4))
        self.assertIn("2 of 4 candidate points (50.0 %) are selected", words(2, 4))
        self.assertTrue(words(0, 1).startswith("at none of 1 candidate point: they carry"))

    def test_strokes_along_a_support_are_evenly_apart_whatever_the_order_of_its_edges(self):
        x = np.array([0.0, 0.3, 0.5, 0.9, 1.4])
        ends = np.stack([np.stack([x[:-1], 0.001 * x[:-1]], 1), np.stack([x[1:], 0.001 * x[1:]], 1)], 1)[[2, 0, 3, 1]]
        order = draw_supports.one_after_the_other(ends)
        at, _ = draw_supports.places_along(ends[order], 0.1)
        np.testing.assert_allclose(np.diff(at[:, 0]), 0.1, rtol=1e-5)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
