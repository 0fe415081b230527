#!/usr/bin/python3
"""A check that cannot fail is none: each rule of scripts/check_includes.py is broken once in a small made tree."""
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
import check_includes  # noqa: E402

GOOD = {
    "include/berm/core/pose.hpp": "#pragma once\n#include <Eigen/Core>\n#include <vector>\n",
    "include/berm/io/reader.hpp": '#pragma once\n#include "berm/core/pose.hpp"\n',
    "include/berm/ground/ground.hpp": '#pragma once\n#include "berm/core/pose.hpp"\n',
    "src/core/pose.cpp": '#include "berm/core/pose.hpp"\n',
    "src/io/CMakeLists.txt": "berm_module(io\n  SOURCES reader.cpp\n  DEPENDS core\n  PUBLIC fmt::fmt)\n",
    "src/io/bytes.hpp": "#pragma once\n#include <fmt/format.h>\n",
    "src/io/reader.cpp": '#include "berm/io/reader.hpp"\n#include "bytes.hpp"\n',
    "src/ground/ground.cpp": '#include "berm/ground/ground.hpp"\n',
    "tests/io/reader_test.cpp": '#include "berm/io/reader.hpp"\n#include "io/bytes.hpp"\n#include <gtest/gtest.h>\n',
    "apps/berm/main.cpp": '#include "berm/io/reader.hpp"\n#include <CLI/CLI.hpp>\n',
}


class CheckIncludes(unittest.TestCase):
    def problems(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            for name, text in {**GOOD, **changes.get("files", {})}.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return check_includes.check(root)

    def assert_one(self, name, text, expected):
        problems = self.problems(files={name: text})
        self.assertEqual(len(problems), 1, problems)
        self.assertIn(name, problems[0])
        self.assertIn(expected, problems[0])

    def test_tree_that_follows_the_table_passes(self):
        self.assertEqual(self.problems(), [])

    def test_include_against_the_direction(self):
        self.assert_one("src/core/pose.cpp", '#include "berm/io/reader.hpp"\n', "core may include no other module")

    def test_algorithm_that_reads_files(self):
        self.assert_one("include/berm/ground/ground.hpp", "#include <berm/io/reader.hpp>\n", "not io")

    def test_dependency_in_cmake(self):
        self.assert_one("src/io/CMakeLists.txt", "berm_module(io SOURCES a.cpp DEPENDS core ground)", "depend on ground")

    def test_private_header_of_another_module(self):
        self.assert_one("src/ground/ground.cpp", '#include "bytes.hpp"\n', "not a private header of src/ground")

    def test_private_header_by_a_path_upwards(self):
        self.assert_one("src/ground/ground.cpp", '#include "../io/bytes.hpp"\n', "leaves the folder")

    def test_private_header_in_a_public_one(self):
        self.assert_one("include/berm/io/reader.hpp", '#include "bytes.hpp"\n', "public headers only")

    def test_private_header_in_tests_of_another_module(self):
        self.assert_one("tests/core/pose_test.cpp", '#include "io/bytes.hpp"\n', "private to io")

    def test_program_with_a_private_header(self):
        self.assert_one("apps/berm/main.cpp", '#include "io/bytes.hpp"\n', "not a private header")

    def test_heavy_library_in_a_lean_module(self):
        self.assert_one("src/ground/ground.cpp", "#include <pcl/point_cloud.h>\n", "pcl/point_cloud.h")
        self.assert_one("include/berm/core/pose.hpp", "#include <yaml.h>\n", "yaml.h")

    def test_header_that_does_not_exist(self):
        self.assert_one("src/io/reader.cpp", '#include "berm/core/gone.hpp"\n', "no such public header")

    def test_module_that_is_not_in_the_table(self):
        problems = self.problems(files={"src/extra/a.cpp": ""})
        self.assertEqual(len(problems), 1)
        self.assertIn("extra", problems[0])

    def test_documentation_shows_the_same_table(self):
        rows = {}
        for line in (ROOT / "docs/design.md").read_text(encoding="utf-8").splitlines():
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if len(cells) == 3 and cells[0] in check_includes.TABLE:
                rows[cells[0]] = set() if cells[2] == "-" else set(cells[2].split(", "))
        self.assertEqual(rows, check_includes.TABLE)


if __name__ == "__main__":
    unittest.main()
