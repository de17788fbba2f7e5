#!/usr/bin/env python3
"""Proves that each lint can fail: a small good tree passes, and one fault at a time is found and named."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

LINTS = pathlib.Path(__file__).resolve().parents[2] / "cmake" / "lint"

README = "# Base\n\nNumbers, vectors and matrices that all the other floors are built on.\n"
GOOD = {
    "kernels/base/CMakeLists.txt": "breccia_floor(\n  base\n  LEVEL K0\n  HEADERS\n    vec.hpp)\n",
    "kernels/base/README.md": README,
    "kernels/base/vec.hpp": "#pragma once\n#include <Kokkos_Core.hpp>\n\n#include <cmath>\n",
    "kernels/point/CMakeLists.txt": "breccia_floor(\n  point\n  LEVEL K1\n  HEADERS\n    elastic.hpp)\n",
    "kernels/point/README.md": README + "See [base](../base/README.md).\n",
    "kernels/point/elastic.hpp": '#pragma once\n#include "base/vec.hpp"\n',
    "src/modules/solid/CMakeLists.txt": "breccia_floor(solid LEVEL S4 SOURCES solid.cpp HEADERS solid.hpp)\n",
    "src/modules/solid/README.md": README,
    "src/modules/solid/solid.hpp": '#pragma once\n#include "point/elastic.hpp"\n',
    "src/modules/solid/solid.cpp": '#include "modules/solid/solid.hpp"\n',
    "src/io/CMakeLists.txt": "breccia_floor(io LEVEL S3 SOURCES plot.cpp)\n",
    "src/io/README.md": README,
    "src/io/plot.cpp": '#include "base/vec.hpp"\n\n#include <hdf5.h>\n#include <toml.hpp>\n',
    "tests/unit/CMakeLists.txt": "breccia_test(unit SOURCES vec.cpp)\n",
    "tests/unit/README.md": README,
    "tests/unit/vec.cpp": '#include "base/vec.hpp"\n\n#include <gtest/gtest.h>\n',
    "examples/disc/README.md": README,
    "examples/disc/scene.toml": 'title = "disc"\n',
}


def long_function(lines):
    body = "".join(f"  x += {number};\n" for number in range(lines - 2))
    return f"template <int D>\nstruct A {{\n  A() : a{{1}}, b{{2}} {{}}\n}};\nint f(int x = {{}}) {{\n{body}}}\n"


class LintCase(unittest.TestCase):
    """Runs one lint over the good tree with some files changed."""

    def run_lint(self, lint, changes=None, removed=()):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**GOOD, **(changes or {})}.items():
                if name in removed:
                    continue
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            return subprocess.run(
                [sys.executable, str(LINTS / f"{lint}.py"), "--root", folder], capture_output=True, text=True
            )

    def passes(self, lint, changes=None):
        done = self.run_lint(lint, changes)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def refuses(self, lint, expected, changes=None, removed=()):
        done = self.run_lint(lint, changes, removed)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(expected, done.stdout)


class Floors(LintCase):
    def includes(self, path, *lines):
        return {path: GOOD.get(path, "") + "\n".join(lines) + "\n"}

    def test_good_tree(self):
        self.passes("floors")

    def test_upward(self):
        self.refuses("floors", "base must not see point", self.includes("kernels/base/vec.hpp", '#include "point/elastic.hpp"'))

    def test_template_sources_are_read(self):
        self.refuses("floors", "x.cpp.in:1", {"kernels/base/x.cpp.in": '#include "point/elastic.hpp"\n'})

    def test_kernels_never_see_src(self):
        self.refuses("floors", "must not see", self.includes("kernels/point/elastic.hpp", '#include "modules/solid/solid.hpp"'))

    def test_rooms_of_s3(self):
        files = {"src/step/plan.hpp": '#include "io/plot.hpp"\n', "src/io/plot.hpp": "#pragma once\n"}
        self.refuses("floors", "step must not see io", files)

    def test_modules_never_include_each_other(self):
        files = {"src/modules/contact/contact.hpp": '#include "modules/solid/solid.hpp"\n'}
        self.refuses("floors", "modules never include each other", files)

    def test_module_sees_no_io(self):
        files = {"src/io/plot.hpp": "#pragma once\n", **self.includes("src/modules/solid/solid.cpp", '#include "io/plot.hpp"')}
        self.refuses("floors", "a module must not see io", files)

    def test_nothing_includes_tests(self):
        files = {"tests/harness/help.hpp": "", **self.includes("src/io/plot.cpp", '#include "harness/help.hpp"')}
        self.refuses("floors", "nothing includes tests/", files)

    def test_unknown_own_header(self):
        self.refuses("floors", "is not a file", self.includes("src/io/plot.cpp", '#include "plot.hpp"'))

    def test_doors(self):
        for header in ("mpi.h", "metis.h", "gmsh.h", "CLI/CLI.hpp"):
            self.refuses("floors", "its door is", self.includes("src/io/plot.cpp", f"#include <{header}>"))
        for header in ("hdf5.h", "toml.hpp", "Eigen/Dense", "fmt/format.h", "unistd.h"):
            self.refuses("floors", "its door is", self.includes("kernels/base/vec.hpp", f"#include <{header}>"))
        self.refuses("floors", "its door is", {"src/mesh/mesh.cpp": "#include <hdf5.h>\n"})

    def test_unknown_library(self):
        self.refuses("floors", "no door is known", self.includes("src/io/plot.cpp", "#include <boost/any.hpp>"))

    def test_law_stays_pure(self):
        self.refuses("floors", "does not belong in a law", self.includes("kernels/point/elastic.hpp", "Kokkos::View<double*> v;"))

    def test_comments_do_not_count(self):
        self.passes("floors", self.includes("kernels/base/vec.hpp", "// #include <mpi.h>", "/* throw View< */"))


class Sizes(LintCase):
    def test_good_tree(self):
        self.passes("sizes")

    def test_limits_are_inclusive(self):
        self.passes("sizes", {"kernels/base/vec.hpp": long_function(60)})
        self.passes("sizes", {"kernels/base/vec.hpp": "\n" * 400})
        self.passes("sizes", {"kernels/base/vec.hpp": "/" * 100 + "\n"})

    def test_long_function(self):
        self.refuses("sizes", "f has 61 lines", {"kernels/base/vec.hpp": long_function(61)})

    def test_long_member_function_and_constructor(self):
        body = "    x();\n" * 60
        member = "namespace n {\nclass A : public B {\n public:\n  void g() const override {\n" + body + "  }\n};\n}\n"
        self.refuses("sizes", "g has 62 lines", {"src/io/plot.cpp": member})
        maker = "A::A(int x)\n    : a_{x}, b_(x) {\n" + body + "}\n"
        self.refuses("sizes", "A::A has 63 lines", {"src/io/plot.cpp": maker})

    def test_braces_in_text_do_not_count(self):
        self.passes("sizes", {"src/io/plot.cpp": 'int f() {\n  return g("}{{", \'{\', R"(\n{{{)");\n}\n' + "\n" * 80})

    def test_tables_are_no_functions(self):
        self.passes("sizes", {"src/io/plot.cpp": "const int table[] = {\n" + "  1,\n" * 80 + "};\n"})

    def test_long_file(self):
        self.refuses("sizes", "401 lines", {"kernels/base/vec.hpp": "\n" * 401})

    def test_wide_line(self):
        self.refuses("sizes", "101 columns", {"kernels/base/vec.hpp": "/" * 101 + "\n"})


class Readmes(LintCase):
    def test_good_tree(self):
        self.passes("readmes")

    def test_missing(self):
        for folder in ("kernels/base", "src/modules/solid", "tests/unit", "examples/disc"):
            self.refuses("readmes", f"{folder}: no README.md", removed=(f"{folder}/README.md",))

    def test_empty(self):
        self.refuses("readmes", "says nothing", {"kernels/base/README.md": "# Base\n"})


class Format(LintCase):
    def setUp(self):
        if self.run_lint("format").returncode == 77:
            self.skipTest("clang-format 14 is not installed")
        style = (LINTS.parents[1] / ".clang-format").read_text(encoding="utf-8")
        self.style = {".clang-format": style}

    def test_good_file(self):
        self.passes("format", self.style)

    def test_bad_file(self):
        self.refuses("format", "plot.cpp: not formatted", {**self.style, "src/io/plot.cpp": "int  x=1;\n"})


class Labels(LintCase):
    def source(self, *lines):
        return {"src/io/plot.cpp": "void f() {\n" + "\n".join(lines) + "\n}\n"}

    def test_good(self):
        lines = (
            'Kokkos::parallel_for("breccia::solid::force", policy, f);',
            "Kokkos::parallel_for(\n    label, policy, f);",
            'exec.fence("breccia::output");',
            "Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), f);",
            'View<double*> v(Kokkos::view_alloc(exec, "breccia::x"), 3);',
            '// Kokkos::parallel_for("x", n, f);',
        )
        self.passes("labels", self.source(*lines))

    def test_bad(self):
        for line in (
            'Kokkos::parallel_for("force", policy, f);',
            "Kokkos::parallel_reduce(policy, f, sum);",
            "Kokkos::fence();",
            'Kokkos::Profiling::ScopedRegion region("step");',
            'View<double*> v(Kokkos::view_alloc(exec, "x"), 3);',
        ):
            self.refuses("labels", '"breccia::..."', self.source(line))


class Docs(LintCase):
    def test_good_tree(self):
        self.passes("docs", {"docs/a.md": "[x](../README.md#y) [w](https://x.y) `[a](b)`\n", "README.md": "x\n"})

    def test_dead_link(self):
        self.refuses("docs", "gone.md does not exist", {"docs/a.md": "[x](gone.md)\n"})


class Listed(LintCase):
    def test_good_tree(self):
        self.passes("listed")

    def test_forgotten(self):
        self.refuses("listed", "plot2.cpp: not named", {"src/io/plot2.cpp": ""})
        self.refuses("listed", "more.cpp: not named", {"tests/unit/more.cpp": ""})


if __name__ == "__main__":
    unittest.main()
