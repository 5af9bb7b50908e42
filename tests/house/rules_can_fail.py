"""The rules of the house refuse what they should: a test that cannot fail proves nothing."""

import pathlib
import subprocess
import tempfile
import unittest

import deciding
import doors
import format as format_rule
import gathering
import headers
import house
import layers
import readme_code
import settings
import sizes
import top_level
import words


def include(path, name):
    return layers.problem_of(pathlib.Path(path), name)


class SettingsInWords(unittest.TestCase):
    KNOWN = settings.settings_of('<ParameterList name="internals"><ParameterList name="active set">'
                                 '<Parameter name="patience" type="int" value="8"/><Parameter name="damping" type="double" value="0.005"/>'
                                 "</ParameterList></ParameterList>")

    def problems(self, text):
        return settings.problems_of_names("x.md", text, self.KNOWN)

    def test_a_number_given_with_a_setting_is_its_value(self):
        for right in ("after eight solves (`active set > patience`) it", "a share of 5e-3 (`active set > damping`)",
                      "`active set > patience` (8 by default)", "12 stones, and 8 solves\n(`active\nset > patience`)",
                      "`active set > patience` = 3 for a study", "| `active set > damping` | 7 stones |"):
            self.assertEqual(self.problems(right), [], right)
        for wrong in ("after ten solves (`active set > patience`) it", "a share of 1e-2 of it (`active set > damping`)",
                      "`active set > patience` (9 by default)"):
            self.assertEqual(len(self.problems(wrong)), 1, wrong)

    def test_a_setting_exists(self):
        self.assertEqual(len(self.problems("as `active sets > patience` says")), 1)
        self.assertEqual(self.problems("`collapse > lower` of result.json"), [])


class NumbersHaveReasons(unittest.TestCase):
    SOURCES = {("nonlinear/patch_parameters.hpp", "trigger"): "0.05", ("ties/tie_parameters.hpp", "patience"): "50"}

    def problems(self, *rows, moves=None):
        table = [dict(zip(("file", "name", "value", "kind", "kept_by", "fails_with"), row)) for row in rows]
        return deciding.problems_of(self.SOURCES, table, moves or {}, most=1, most_open=0)

    def test_an_order_of_magnitude_is_chosen(self):
        row = {"file": "a_parameters.hpp", "name": "a", "value": "1 / order_of_magnitude", "kept_by": "one", "fails_with": ""}
        self.assertIn("is chosen", deciding.problem_of_reason({**row, "kind": "derived"}, {}))
        self.assertIsNone(deciding.problem_of_reason({**row, "kind": "magnitude"}, {}))

    def test_numbers_are_found_as_they_are_written(self):
        text = "struct A {\n  double a = 1e-2;  // = 7\n  static constexpr int b = 2 * c, d = 3;\n  bool e = true;\n};\n"
        self.assertEqual(list(deciding.numbers_of("a_parameters.hpp", text)), [("a", "1e-2"), ("b", "2 * c"), ("d", "3")])
        self.assertEqual(list(deciding.numbers_of("a.cpp", "constexpr double pi = 3.14159, x = f(1, 2);\nint k = 3;\n")),
                         [("x", "f(1, 2)")])

    def test_each_is_listed_with_its_value_and_a_reason_that_holds(self):
        trigger = ("nonlinear/patch_parameters.hpp", "trigger", "0.05", "row", "ablation.csv", "")
        patience = ("ties/tie_parameters.hpp", "patience", "50", "bound", "it ends", "")
        moved = {"patches/trigger": 0.2}
        self.assertEqual(self.problems(trigger, patience, moves=moved), [])
        self.assertEqual(len(self.problems(trigger, moves=moved)), 1)  # one is not listed
        self.assertEqual(len(self.problems(trigger, patience)), 1)  # no row moves anything
        for k, other in ((1, "triggers"), (2, "0.5"), (3, "whim"), (4, "")):
            wrong = trigger[:k] + (other,) + trigger[k + 1:]
            self.assertNotEqual(self.problems(wrong, patience, moves=moved), [], other)

    def test_they_do_not_become_more(self):
        principle = ("nonlinear/patch_parameters.hpp", "trigger", "0.05", "principle", "physics", "")
        also = ("ties/tie_parameters.hpp", "patience", "50", "principle", "cost", "")
        self.assertEqual(len(self.problems(principle, also)), 1)
        self.assertEqual(len(self.problems(principle[:3] + ("open", "none", ""), also[:3] + ("bound", "it ends", ""))), 1)

    def test_a_test_that_keeps_one_exists(self):
        bound = ("ties/tie_parameters.hpp", "patience", "50", "bound", "it ends", "")
        named = ("nonlinear/patch_parameters.hpp", "trigger", "0.05", "test")
        here = "tests/house/rules_can_fail.py NumbersHaveReasons.test_a_test_that_keeps_one_exists"
        self.assertEqual(self.problems((*named, here, "1"), bound), [])
        self.assertEqual(len(self.problems((*named, "tests/house/no.py A.test_b", "1"), bound)), 1)


class IncludesPointDown(unittest.TestCase):
    def test_a_module_may_include_itself_and_what_is_below(self):
        self.assertIsNone(include("src/mesh/mesh.hpp", "mesh/cell.hpp"))
        self.assertIsNone(include("src/joints/joint.hpp", "mesh/mesh.hpp"))
        self.assertIsNone(include("src/run/simulation.cpp", "output/history.hpp"))
        self.assertIsNone(include("drivers/voussoir.cpp", "scene/scene.hpp"))

    def test_ranks_may_be_asked_everywhere(self):
        self.assertIsNone(include("src/mesh/partition.cpp", "linalg/agree.hpp"))
        self.assertIn("points up", include("src/mesh/partition.cpp", "linalg/linear_solver.hpp"))

    def test_a_module_may_not_include_what_is_above_or_beside(self):
        self.assertIn("points up", include("src/mesh/mesh.hpp", "joints/joint.hpp"))
        self.assertIn("points up", include("src/base/log.hpp", "mesh/mesh.hpp"))
        self.assertIn("points up", include("src/base/log.hpp", "linalg/agree.hpp"))
        self.assertIn("points up", include("src/nonlinear/newton.cpp", "output/history.hpp"))
        self.assertIn("points up", include("src/mesh/mesh.cpp", "scene/scene.hpp"))

    def test_the_scene_sees_parameters_but_not_their_modules(self):
        self.assertIsNone(include("src/scene/scene.hpp", "mesh/mesh_parameters.hpp"))
        self.assertIn("points up", include("src/scene/scene.hpp", "mesh/mesh.hpp"))

    def test_parameters_are_plain_data(self):
        self.assertIsNone(include("src/mesh/mesh_parameters.hpp", "base/parameter_section.hpp"))
        self.assertIn("points up", include("src/joints/joint_parameters.hpp", "joints/joint.hpp"))

    def test_paths_start_at_src(self):
        self.assertIn("must start at src/", include("src/mesh/mesh.cpp", "mesh.hpp"))

    def test_methods_are_given_settings_and_no_scene(self):
        def problems(path, text):
            return layers.problems_of_scenes(pathlib.Path(path), text)

        self.assertEqual(len(problems("src/run/run.cpp", "return model.scene().output;\n")), 1)
        self.assertEqual(len(problems("src/step/release.cpp", "long release(const Scene& all) {\n")), 1)
        self.assertEqual(problems("src/run/run.cpp", "Run::Run(const Scene& scene) {  // of scene()\n"), [])
        self.assertEqual(problems("src/step/release.cpp", "// as the Scene asks\nreturn model.settings().selection;\n"), [])
        self.assertEqual(problems("src/scene/scene_printer.cpp", "print(all.scene());\n"), [])

    def test_a_library_has_one_owner_and_it_is_no_header(self):
        text = "#include <MueLu_Hierarchy.hpp>\n"
        one = (pathlib.Path("src/linalg/amg.cpp"), text)
        two = (pathlib.Path("src/linalg/other.cpp"), text)
        header = (pathlib.Path("src/linalg/amg.hpp"), text)
        self.assertEqual(layers.problems_of_libraries([one]), [])
        self.assertEqual(len(layers.problems_of_libraries([one, two])), 1)
        self.assertEqual(len(layers.problems_of_libraries([header])), 1)

    def test_gmsh_is_known_to_its_folder(self):
        within, beyond = [(pathlib.Path(f"src/{name}.cpp"), "#include <gmsh.h>\n")
                          for name in ("gmsh/gmsh_step", "stones/skins")]
        self.assertEqual(layers.problems_of_libraries([within]), [])
        self.assertEqual(len(layers.problems_of_libraries([within, beyond])), 1)


class PointsHaveADoor(unittest.TestCase):
    def problems(self, path, text):
        return doors.problems_of(pathlib.Path(path), text)

    def test_nodes_of_points_are_named_in_joints_and_unknowns_alone(self):
        for text in ("const int k = p.node_i;", "for (const auto& s : p.shares_j)", "x = a[nodes_i];"):
            self.assertEqual(len(self.problems("src/model/model.cpp", text)), 1, text)
            self.assertEqual(self.problems("src/joints/contact_points.cpp", text), [], text)
            self.assertEqual(self.problems("src/homogenisation/merged_space.cpp", text), [], text)

    def test_names_of_tables_and_words_are_none(self):
        for text in ('write("/joints/node_i", points);', "// of node_i", "s.node_id()[i]", "points.at(k).each(add);"):
            self.assertEqual(self.problems("src/output/fields_file.cpp", text), [], text)


class ListsOfAllRanks(unittest.TestCase):
    def problems(self, text):
        return gathering.problems_of(pathlib.Path("src/step/a.cpp"), text, {"src/loads/b.cpp"})

    def test_only_those_who_are_named_bring_them_to_every_rank(self):
        for wrong in ("const auto all = all_gather(mine, comm, why);", "x = largest_of_list(comm, marks, why);",
                      "all_gather<double>(mine, comm, why)", "broadcast_values(comm, words);",
                      "Teuchos::gatherAll(comm, 1, &one, ranks, all.data());", "MPI_Allgatherv(a, n, t, b, c, d, t, comm);",
                      "Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, size(), a, b);",
                      "Teuchos::reduceAll(comm, how, static_cast<int>(a.size()), a.data(), b.data());"):
            self.assertEqual(len(self.problems(wrong)), 1, wrong)
            self.assertEqual(gathering.problems_of(pathlib.Path("src/loads/b.cpp"), wrong, {"src/loads/b.cpp"}), [], wrong)
        for right in ("// all_gather(mine)", "total_over_ranks(comm, mine);",
                      "Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, 1, &mine, &all);"):
            self.assertEqual(self.problems(right), [], right)

    def test_only_those_who_are_named_bring_them_to_the_first_rank(self):
        for wrong in ("const auto all = gather_on_first(mine, comm);",
                      "for (const auto& p : exchange_parcels<int>({{0, mine}}, comm)) use(p);"):
            self.assertEqual(len(self.problems(wrong)), 1, wrong)
            self.assertEqual(gathering.problems_of(pathlib.Path("src/a.cpp"), wrong, set(), {"src/a.cpp"}), [], wrong)
        self.assertEqual(self.problems("exchange_parcels<int>({{owner, mine}}, comm)"), [])

    def test_sums_of_a_fixed_few_are_of_no_list(self):
        few = "std::array<double, 2> mine{}; const auto all = total_of_each(comm, mine);"
        self.assertEqual(self.problems(few), [])
        for wrong in (few.replace("std::array<double, 2> mine{}", "std::vector<double> mine(n, 0.0)"),
                      "std::vector<int> mine(n + 1, 0), all(n + 1); all = largest_of_each(*s.comm(), mine);",
                      "std::vector<int> mine(n), all(n); all = largest_of_each(*s.comm(), all);"):
            self.assertEqual(len(self.problems(wrong)), 1, wrong)

    def test_who_no_longer_does_is_not_named(self):
        texts = {"src/a.cpp": "all_gather(mine, comm, why);", "src/b.cpp": "total_over_ranks(comm, mine);"}
        self.assertEqual(len(gathering.idle_callers({"src/a.cpp", "src/b.cpp", "src/c.cpp"}, texts)), 2)


class CodeOfReadmes(unittest.TestCase):
    def problems(self, code):
        return readme_code.problems_of("README.md", f"Text.\n\n{code}\n\nMore.\n", {"drivers/run": {"--out"}})

    def test_a_command_has_a_line_of_its_own(self):
        good = "    drivers/run A.xml --out B    # first\n    drivers/run C.xml \\\n    --out D"
        self.assertEqual(self.problems(good), [])
        self.assertEqual(len(self.problems("    drivers/run A.xml --out B # first drivers/run C.xml\n    --out D")), 2)
        self.assertEqual(len(self.problems("```\ndrivers/run A.xml drivers/run C.xml\n```")), 1)
        self.assertEqual(self.problems("Not code: drivers/run, then drivers/run."), [])

    def test_its_options_are_those_of_the_program(self):
        self.assertEqual(len(self.problems("    drivers/run A.xml --outt B")), 1)


class TheTopLevel(unittest.TestCase):
    def test_what_a_test_left_there_is_named(self):
        self.assertEqual(top_level.problems_of(["README.md", "src/mesh/mesh.hpp", ".gitignore"]), [])
        self.assertEqual(len(top_level.problems_of(["src/a.cpp", "copy-np1.h5", "fields-np1/fields.h5"])), 2)


class FilesAreShort(unittest.TestCase):
    def test_the_limit_itself_is_allowed(self):
        path = pathlib.Path("src/mesh/mesh.cpp")
        self.assertEqual(sizes.problems_of(path, "x\n" * 400), [])
        self.assertEqual(len(sizes.problems_of(path, "x\n" * 401)), 1)
        self.assertEqual(sizes.problems_of(path, "x" * 120), [])
        self.assertEqual(len(sizes.problems_of(path, "x" * 121)), 1)

    def test_a_function_is_short_and_branches_little(self):
        path = pathlib.Path("src/nonlinear/some.cpp")

        def problems(lines):
            text = "namespace {\n\ntemplate <int dim>\nint Some<dim>::sum(int n,\n    int m) {\n"
            return sizes.problems_of_functions(path, text + lines + "}\n\n}  // namespace\n")

        self.assertEqual(problems("  n += m;\n" * 56), [])
        self.assertIn("Some::sum has 61 lines", problems("  n += m;\n" * 57)[0])
        self.assertEqual(problems("  if (n > m && m > 0) ++n;  // if\n" * 7), [])
        self.assertIn("16 branches", problems("  if (n > m && m > 0) ++n;  // if\n" * 8)[0])
        self.assertEqual(problems("  VOUSSOIR_EXPECT((n > m || m > 0) &&\n    \"positive\");\n" * 8), [])

    def test_files_are_found_at_all(self):
        self.assertIn(pathlib.Path("src/mesh/mesh.hpp"), house.code_files(".hpp"))
        self.assertIn(pathlib.Path("drivers/run"), house.scripts())


class WordsSayWhatIs(unittest.TestCase):
    def test_history_is_refused_in_markdown_and_comments_only(self):
        readme, code = pathlib.Path("src/mesh/README.md"), pathlib.Path("src/mesh/mesh.cpp")
        self.assertEqual(len(words.problems_of_words(readme, "13 solves (prototype)")), 1)
        self.assertEqual(len(words.problems_of_words(code, "// 13 when this was written\n")), 1)
        self.assertEqual(words.problems_of_words(code, "int prototype;\n"), [])
        self.assertEqual(words.problems_of_words(readme, "the state before the step"), [])

    def test_paths_that_are_named_exist(self):
        readme = pathlib.Path("src/mesh/README.md")
        there = "[a](../../README.md), `mesh/border`, tests/house/words.py, `--set mesh/none=1`, https://a.b/src/none"
        self.assertEqual(words.problems_of_paths(readme, there), [])
        self.assertEqual(words.problems_of_scenes("| `wall.xml` |", ["wall.xml"]), [])
        self.assertEqual(len(words.problems_of_scenes("| `wall.xml` |", ["wall.xml", "arch.xml"])), 1)
        for missing in ("[a](none.md)", "src/mesh/none.md", "`mesh/no_such_thing`"):
            self.assertEqual(len(words.problems_of_paths(readme, missing)), 1, missing)


class FilesAreFormatted(unittest.TestCase):
    def test_each_file_that_differs_is_named_once(self):
        said = "\n".join(f"src/a.cpp:{line}:7: warning: code should be clang-formatted [-Wclang-format-violations]"
                         for line in (3, 9))
        self.assertEqual(len(format_rule.problems_of(said)), 1)
        self.assertIn("src/a.cpp:3:", format_rule.problems_of(said)[0])
        self.assertEqual(format_rule.problems_of(""), [])

    def test_clang_format_finds_what_is_not_formatted(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "unformatted.cpp"
            path.write_text("int  f( ){return 1;}\n", encoding="utf-8")
            asked = subprocess.run(format_rule.command([path]), capture_output=True, text=True, check=True)
            self.assertEqual(len(format_rule.problems_of(asked.stderr)), 1)
            subprocess.run(format_rule.command([path], write=True), check=True)
            self.assertEqual(path.read_text(encoding="utf-8"), "int f() { return 1; }\n")


class HeadersCompileAlone(unittest.TestCase):
    def test_a_header_that_is_not_there_is_noticed(self):
        command = ["c++", "-fsyntax-only", "-x", "c++", "-"]
        self.assertIn("does not compile alone", headers.compile_alone("mesh/no_such_header.hpp", command))

    def test_a_change_below_a_header_is_a_change(self):
        self.assertIn("base/ids.hpp", headers.headers_below("mesh/mesh.hpp", {}))
        self.assertNotEqual(headers.digest("mesh/mesh.hpp", ["c++"]), headers.digest("mesh/mesh.hpp", ["c++", "-O2"]))


if __name__ == "__main__":
    unittest.main()
