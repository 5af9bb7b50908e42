"""Jobs that people have, done from a script as they would do them: stones and keys in, an answer and a page out."""

import pathlib
import subprocess
import sys

import program
import sweeps

ROOT = pathlib.Path(__file__).resolve().parents[2]


def package():
    voussoir = sweeps.package()
    import voussoir.stones

    return voussoir


class JobTest(sweeps.SweepTest):
    def write_job(self, name, drawn, keys, element_size=0.25):
        """The scene of a job beside its drawing; its path."""
        scene = package().Scene(name)
        scene["title"] = type(self).__name__ + ": " + name.replace("_", " ")
        scene["mesh"] = drawn.write(self.folder / f"{name}.geo", element_size=element_size)
        for key, value in keys.items():
            scene[key] = value
        scene.write(self.folder / f"{name}.xml")
        return self.folder / f"{name}.xml"

    def run_job(self, name, drawn, keys, element_size=0.25, **options):
        path = self.write_job(name, drawn, keys, element_size)
        return package().run(path, out=self.folder / name, overwrite=True, ranks=1, **options)

    def page(self, result):
        """The report of a run; all of it was drawn."""
        subprocess.run([sys.executable, "-B", ROOT / "drivers" / "report" / "make_report.py", result.folder], check=True, stdout=subprocess.DEVNULL)
        page = (pathlib.Path(result.folder) / "report.html").read_text(encoding="utf-8")
        self.assertNotIn("could not be", page)
        return page


__all__ = ["JobTest", "package", "program"]
