"""Fields of whole runs in ParaView's own reader, of the plane and of space, against fields.h5.

    in_viewers.py PROGRAM MPIEXEC [names of tests]

Expected  Places, cells and every field of every step are the numbers that h5py reads, to the last bit: a viewer that takes a table
          for another, or a vector for a scalar, shows something all the same.
"""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import program  # noqa: E402  (a folder of its own)
import viewers  # noqa: E402


class InViewers(program.SceneTest):
    def check(self, scene, *options):
        run = self.run_scene(ROOT / "xml" / f"{scene}.xml", *options, out=scene)
        self.assertEqual(run.code, 0, run.said)
        print(f"{scene}: {viewers.in_paraview(run.folder)}")

    def test_a_wall_of_the_plane(self):
        self.check("wall")

    def test_a_wall_in_space(self):
        self.check("wall-in-space")

    def test_hexahedra_beside_tetrahedra(self):
        self.check("cross-vault", "--set=selection/mode=bonded")


if __name__ == "__main__":
    program.main()
