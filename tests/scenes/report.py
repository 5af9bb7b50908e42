"""The report of a run: one page that needs no other file, whatever the user calls things, with the numbers of the run.

    report.py PROGRAM

Three stones under their weight and pressed from above, with a title, stages and a set of stones named to break a page.
"""

import base64
import csv
import html.parser
import json
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path("report").resolve()
PROGRAM = None

TITLE = """Stones <script>alert("title")</script> & 'quotes' $x$"""
STAGES = ("<b>weight</b> & more", "</td></table><img src=x onerror=alert(1)>")
STONES = 'ring <script>alert("set")</script>'
PLACE = '=1+1 <svg onload=alert(2)>, $top$ "quoted"'

SCENE = """
<ParameterList name="stones">
  <Parameter name="title" type="string" value="{title}"/>
  <ParameterList name="mesh">
    <Parameter name="type" type="string" value="gmsh"/>
    <ParameterList name="gmsh">
      <Parameter name="file" type="string" value="stones.geo"/>
      <Parameter name="element size" type="double" value="0.25"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="materials">
    <ParameterList name="stone">
      <Parameter name="Young modulus" type="double" value="10e9"/>
      <Parameter name="Poisson ratio" type="double" value="0.2"/>
      <Parameter name="density" type="double" value="2000"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="joints">
    <ParameterList name="dry"><Parameter name="friction coefficient" type="double" value="0.6"/></ParameterList>
  </ParameterList>
  <ParameterList name="supports">
    <ParameterList name="ground"><Parameter name="on" type="string" value="bottom"/></ParameterList>
  </ParameterList>
  <ParameterList name="loads">
    <ParameterList name="weight">
      <Parameter name="type" type="string" value="self weight"/>
      <Parameter name="gravity" type="double" value="9.81"/>
    </ParameterList>
    <ParameterList name="press">
      <Parameter name="type" type="string" value="traction"/>
      <Parameter name="on" type="string" value="top"/>
      <Parameter name="pressure" type="double" value="1e5"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="steps">
    <ParameterList name="stages">
      <ParameterList name="{first}">
        <ParameterList name="loads"><Parameter name="weight" type="double" value="1"/></ParameterList>
      </ParameterList>
      <ParameterList name="{second}">
        <Parameter name="increments" type="int" value="2"/>
        <ParameterList name="loads"><Parameter name="press" type="double" value="1"/></ParameterList>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="observations">
    <ParameterList name="{place}"><Parameter name="place" type="string" value="mean"/></ParameterList>
  </ParameterList>
  <ParameterList name="selection"><Parameter name="mode" type="string" value="all"/></ParameterList>
</ParameterList>
"""

# What html_page.py writes; anything else came in from outside.
TAGS = set("html head meta title style body header h1 h2 h3 span div ul li dl dt dd small p figure img figcaption table thead "
           "tbody tr th td wbr footer nav a picture source canvas script label input button output".split())
ATTRIBUTES = {"lang", "charset", "name", "content", "class", "width", "alt", "src", "id", "href", "media", "srcset", "role", "type", "value",
              "min", "max", "aria-label", "aria-live"}
EMBEDDED = "data:image/png;base64,"
UNITS = {"m": 1.0, "mm": 1e-3, "µm": 1e-6}


class Page(html.parser.HTMLParser):
    """Tags, attributes, texts by tag, tables and pictures of a page."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.attributes, self.open = set(), set(), []
        self.pictures, self.narrow, self.texts, self.tables, self.declarations = [], [], {}, [], []
        self.anchors, self.links = [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        self.attributes |= {name for name, _ in attrs}
        if tag == "img":
            self.pictures.append(dict(attrs))
        elif tag == "source":
            self.narrow.append(dict(attrs))
        if "id" in dict(attrs):
            self.anchors.append(dict(attrs)["id"])
        if tag == "a":
            self.links.append(dict(attrs)["href"])
        if tag not in ("meta", "wbr", "img", "source", "input"):
            self.open.append(tag)
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        if tag in ("td", "th"):
            self.tables[-1][-1].append("")
        self.texts.setdefault(tag, []).append("")

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-1:]}"
        self.open.pop()

    def handle_data(self, data):
        if not self.open:
            return
        self.texts[self.open[-1]][-1] += data
        if self.open[-1] in ("td", "th"):
            self.tables[-1][-1][-1] += data

    def facts(self):
        """Name -> words of the figures asked first."""
        return dict(zip(self.texts["dt"], self.texts["dd"]))


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def content_of(picture):
    return base64.b64decode(picture["src"].split(",", 1)[1], validate=True)


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        FOLDER.mkdir(exist_ok=True)
        geo = (ROOT / "tests/scenes/geo/three_stones.geo").read_text()
        name = STONES.replace('"', "'")  # gmsh ends a name at a double quote
        (FOLDER / "stones.geo").write_text(f'{geo}Physical Surface("{name}") = {{1, 2, 3}};\n')
        scene = FOLDER / "stones.xml"
        scene.write_text(SCENE.format(title=escaped(TITLE), first=escaped(STAGES[0]), second=escaped(STAGES[1]),
                                      place=escaped(PLACE)))
        cls.out = FOLDER / "out"
        subprocess.run([PROGRAM, f"--xml={scene}", f"--out={cls.out}", "--overwrite", "--quiet"], check=True)
        subprocess.run([sys.executable, "-B", ROOT / "drivers/report/make_report.py", cls.out], check=True,
                       stdout=subprocess.DEVNULL)
        cls.text = (cls.out / "report.html").read_text(encoding="utf-8")
        cls.page = Page(cls.text)
        cls.result = json.loads((cls.out / "result.json").read_text())
        with open(cls.out / "history.csv", newline="", encoding="utf-8") as file:
            cls.history = list(csv.DictReader(file))

    def test_every_tag_is_ours_and_is_closed(self):
        self.assertEqual(self.page.tags - TAGS, set())
        self.assertEqual(self.page.attributes - ATTRIBUTES, set())
        self.assertEqual(self.page.open, [])

    def test_names_of_the_user_are_shown_as_they_are(self):
        self.assertEqual(self.page.texts["h1"], [TITLE])
        self.assertEqual(self.page.texts["title"], [TITLE])
        stages = [row[1] for row in next(t for t in self.page.tables if "Krylov" in t[0])[1:]]
        self.assertEqual(stages, [STAGES[0], STAGES[1], STAGES[1]])
        blocks = next(t for t in self.page.tables if "opening [mm]" in t[0] or "slip [mm]" in t[0])
        self.assertIn(STONES.replace('"', "'"), blocks[1][1])

    def test_nothing_is_loaded_from_elsewhere(self):
        for source in [p["src"] for p in self.page.pictures] + [p["srcset"] for p in self.page.narrow]:
            self.assertTrue(source.startswith(EMBEDDED), source[:60])
        self.assertTrue(all(link.startswith("#") for link in self.page.links))
        style = "".join(self.page.texts["style"])
        for word in ("url(", "@import", "http:", "https:"):
            self.assertNotIn(word, style)

    def test_words_in_tables_break_between_words_alone(self):
        # "anywhere" counts every letter as a place to break, so that a wide table squeezes a column to one letter.
        rule = re.search(r"td\.words \{([^}]*)\}", "".join(self.page.texts["style"])).group(1)
        self.assertNotIn("anywhere", rule)
        self.assertNotIn("break-all", rule)
        self.assertIn("min-width", rule)

    def test_names_without_blanks_break_at_underscores(self):
        sys.path.insert(0, str(ROOT / "drivers/report"))
        import html_page

        page = html_page.Page("long names")
        page.table(["stage", "file"], [["the_western_pier", "a_b"]], words=(0,))
        self.assertIn("the_<wbr>western_<wbr>pier", page.parts[0])
        self.assertIn("<td>a_b</td>", page.parts[0])

    def test_a_column_of_long_names_is_wide(self):
        sys.path.insert(0, str(ROOT / "drivers/report"))
        import html_page

        page = html_page.Page("long names")
        page.table(["stage", "set"], [["western pier settles and tilts", "ring"], ["push", "pier"]], words=(0, 1))
        self.assertEqual(page.parts[0].count('class="words long"'), 3)  # its heading and two rows
        self.assertIn(".long { min-width", html_page.STYLE)

    def test_pictures_are_whole_and_captioned(self):
        # Structure, loads, deformed shape, stages, joints, forces, selection, places, energy, history; phases where there is
        # time to show. The player has a caption too.
        self.assertGreaterEqual(len(self.page.pictures), 10)
        self.assertEqual(len(self.page.texts["figcaption"]), len(self.page.pictures) + 1)
        for picture in self.page.pictures:
            content = content_of(picture)
            self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
            self.assertEqual(content[-8:-4], b"IEND")
            self.assertGreater(int.from_bytes(content[16:20], "big"), 500)  # pixels: wide enough for a page

    def test_every_picture_has_one_for_narrow_screens_whose_letters_are_as_high(self):
        # Drawn on 5 inches instead of 10: on 370 pixels letters of 10 points are 10 pixels high, of 9 points 9.
        self.assertEqual(len(self.page.narrow), len(self.page.pictures))
        for source in self.page.narrow:
            content = base64.b64decode(source["srcset"].split(",", 1)[1], validate=True)
            self.assertLessEqual(int.from_bytes(content[16:20], "big"), 5 * 160)
            self.assertIn("max-width", source["media"])

    def test_the_contents_lead_to_every_section(self):
        self.assertEqual(len(self.page.texts["a"]), len(self.page.texts["h2"]))
        self.assertEqual(self.page.texts["a"], self.page.texts["h2"])
        for link in self.page.links:
            self.assertIn(link[1:], self.page.anchors)
        self.assertEqual(len(set(self.page.anchors)), len(self.page.anchors))

    def test_an_observed_place_has_columns_under_its_name(self):
        columns = [key for key in self.history[0] if key.startswith(("ux_m of ", "uy_m of "))]
        self.assertEqual(columns, [f"ux_m of {PLACE}", f"uy_m of {PLACE}"])
        # Pressed from above, the stones sink.
        self.assertLess(float(self.history[-1][columns[1]]), float(self.history[0][columns[1]]))

    def test_nothing_failed_to_be_drawn(self):
        self.assertNotIn("could not be drawn", self.text)
        self.assertNotIn("What this report lacks", self.text)

    def test_the_figures_asked_first_are_those_of_the_result(self):
        facts, result = self.page.facts(), self.result
        value, unit = facts["Largest displacement"].split()
        # Shown with three digits: half a unit of the third is 0.5 %.
        self.assertAlmostEqual(float(value) * UNITS[unit] / result["largest_displacement_m"], 1, delta=5e-3)
        self.assertEqual(facts["Open / slipping / sticking points"],
                         f"{result['open_points']} / {result['slip_points']} / {result['stick_points']}")
        self.assertEqual(facts["Blocks / joints"], f"{result['blocks']} / {result['joints']}")
        self.assertEqual(facts["Unknowns"], str(result["unknowns"]))
        self.assertEqual(facts["Selected as contact"], "100.0 %")
        self.assertEqual(self.page.texts["span"], [result["outcome"]])
        self.assertIn('class="outcome good"', self.text)

    def test_the_tables_hold_every_step_of_the_history(self):
        table = next(t for t in self.page.tables if "Krylov" in t[0])
        column = {name: table[0].index(name) for name in ("step", "open", "Newton", "Krylov", "displacement [m]")}
        self.assertEqual(len(table) - 1, len(self.history))
        for row, step in zip(table[1:], self.history):
            for name, key in (("step", "step"), ("open", "open_points"), ("Newton", "newton_iterations"),
                              ("Krylov", "krylov_iterations")):
                self.assertEqual(row[column[name]], step[key])
            shown, known = float(row[column["displacement [m]"]]), float(step["largest_displacement_m"])
            self.assertAlmostEqual(shown / known, 1, delta=5e-3)
        energy = next(t for t in self.page.tables if "imbalance [J]" in t[0])
        self.assertEqual(len(energy) - 1, len(self.history))


class InTime(unittest.TestCase):
    """Two bars that collide, the first ten of their time steps, every second recorded."""

    @classmethod
    def setUpClass(cls):
        cls.out = FOLDER / "in-time"
        settings = ["steps/stages/impact/duration=2.5e-5", "output/every=2"]
        subprocess.run([PROGRAM, f"--xml={ROOT / 'xml/impact-bars.xml'}", f"--out={cls.out}", "--overwrite", "--quiet"]
                       + [f"--set={s}" for s in settings], check=True)
        subprocess.run([sys.executable, "-B", ROOT / "drivers/report/make_report.py", cls.out], check=True,
                       stdout=subprocess.DEVNULL)
        cls.text = (cls.out / "report.html").read_text(encoding="utf-8")
        cls.page = Page(cls.text)

    def test_the_course_of_energies_places_and_the_motion_are_drawn(self):
        self.assertNotIn("could not be drawn", self.text)
        for heading in ("Over time", "The motion"):
            self.assertIn(heading, self.page.texts["h2"])
        self.assertIn('id="motion"', self.text)
        self.assertNotIn("oad factor", re.sub(r"<script.*?</script>", "", self.text, flags=re.DOTALL))
        for name in ("energy", "places"):
            self.assertTrue((self.out / f"pictures/{name}.png").exists())

    def test_the_energy_book_shows_what_moves(self):
        table = next(t for t in self.page.tables if "kinetic [J]" in t[0])
        # The flying bar: 1 m x 0.02 m x 1 m of 7800 kg/m3 at 1 m/s has 78 J, before it touches and after.
        column = table[0].index("kinetic [J]")
        self.assertEqual(float(table[1][column]), 78)


class Warned(unittest.TestCase):
    """A block that slides farther than a cell: the report says what that leaves open before anything else."""

    @classmethod
    def setUpClass(cls):
        cls.out = FOLDER / "warned"
        subprocess.run([PROGRAM, f"--xml={ROOT / 'xml/sliding-block.xml'}", f"--out={cls.out}", "--overwrite", "--quiet",
                        "--set=steps/stages/sliding/duration=0.15"], check=True)
        cls.result = json.loads((cls.out / "result.json").read_text())

    def report(self, result):
        (self.out / "result.json").write_text(json.dumps(result))
        subprocess.run([sys.executable, "-B", ROOT / "drivers/report/make_report.py", self.out], check=True,
                       stdout=subprocess.DEVNULL)
        return (self.out / "report.html").read_text(encoding="utf-8")

    def test_warnings_come_first_with_place_time_and_kind_and_names_are_shown_as_they_are(self):
        (slip,) = self.result["warnings"]
        self.assertEqual(slip["what"], "slip_beyond_cell")
        hostile = {"what": "kind", "where": TITLE, "when": "", "how_much": 1, "text": STAGES[1]}
        text = self.report({**self.result, "warnings": [slip, hostile]})
        page = Page(text)
        said = page.texts["li"]
        self.assertEqual(said[0].strip(), f"{slip['where']}, {slip['when']}: {slip['text']}.")
        self.assertEqual(said[1].strip(), f"{TITLE}: {STAGES[1]}.")
        self.assertEqual(page.tags - TAGS, set())
        self.assertIn("slip_beyond_cell", page.texts["small"][0])
        self.assertLess(text.index("What this result leaves open"), text.index("<dl>"))
        self.assertLess(text.index("What this result leaves open"), text.index("<h2 "))
        self.assertIn('class="outcome warn"', text)

    def test_where_a_run_left_the_range_of_the_model_the_reason_comes_first(self):
        text = self.report({**self.result, "outcome": "out_of_range", "message": "the stone has left the table", "warnings": []})
        self.assertIn("the stone has left the table", Page(text).texts["li"][0])
        self.assertIn('class="outcome bad"', text)

    def test_without_warnings_there_is_no_box(self):
        self.assertFalse("What this result leaves open" in self.report({**self.result, "warnings": []}))


class Collapse(unittest.TestCase):
    """How far an arch can be pushed: four hinges in its mechanism, forces of the last equilibrium."""

    @classmethod
    def setUpClass(cls):
        cls.out = FOLDER / "collapse"
        subprocess.run([PROGRAM, f"--xml={ROOT / 'xml/oppenheim-arch.xml'}", f"--out={cls.out}", "--overwrite", "--quiet"],
                       check=True)
        subprocess.run([sys.executable, "-B", ROOT / "drivers/report/make_report.py", cls.out], check=True,
                       stdout=subprocess.DEVNULL)
        cls.text = (cls.out / "report.html").read_text(encoding="utf-8")
        cls.page = Page(cls.text)
        cls.result = json.loads((cls.out / "result.json").read_text())

    def table(self, heading):
        return next(t for t in self.page.tables if heading in t[0])

    def test_the_bracket_and_every_attempt_are_shown(self):
        self.assertNotIn("could not be drawn", self.text)
        found = self.result["collapse"]
        self.assertEqual(self.page.facts()["Collapse load factor"], f"{found['lower']:.4g} to {found['upper']:.4g}")
        self.assertIn("How far the loads can be raised", self.page.texts["h2"])
        rows = self.table("found")[1:]
        self.assertEqual([row[1] for row in rows], [a["outcome"] for a in found["attempts"]])

    def test_the_mechanism_has_four_hinges_in_turn(self):
        rows = self.table("hinge at")[1:]
        self.assertEqual([row[3] for row in rows], ["intrados", "extrados", "intrados", "extrados"])

    def test_margins_and_reactions_are_those_of_the_last_equilibrium(self):
        statics = self.result["statics"]
        self.assertEqual(self.page.facts()["Hinges / sliding joints"], f"{statics['hinges']} / {statics['sliding_joints']}")
        margins = self.table("edge margin")
        with open(self.out / "joints.csv", newline="", encoding="utf-8") as file:
            least = min(float(row["edge_margin"]) for row in csv.DictReader(file))
        self.assertAlmostEqual(float(margins[1][margins[0].index("edge margin")]), least, delta=1e-9)
        reaction = self.table("vertical [kN]")[1]  # to four digits
        self.assertAlmostEqual(1e3 * float(reaction[2]) / statics["reactions"]["ground"]["y_N"], 1, delta=1e-3)
        # A line of thrust that touches an edge leaves nothing of the thickness.
        arch = self.table("geometrical factor of safety")
        self.assertEqual(arch[1][-1], "1")


class DamagedResults(unittest.TestCase):
    def test_a_report_of_an_empty_folder_names_what_is_missing(self):
        empty = FOLDER / "empty"
        empty.mkdir(parents=True, exist_ok=True)
        subprocess.run([sys.executable, "-B", ROOT / "drivers/report/make_report.py", empty], check=True,
                       stdout=subprocess.DEVNULL)
        page = Page((empty / "report.html").read_text(encoding="utf-8"))
        lacks = " ".join(page.texts["li"])
        for name in ("result.json", "history.csv", "fields.h5", "scene.xml"):
            self.assertIn(f"{name} is missing", lacks)
        self.assertTrue(re.search(r"\w", page.texts["h1"][0]))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
