"""Everything public has a docstring, whose examples run, and stands in the stubs."""
import ast
import doctest
import inspect
import pathlib
import subprocess
import sys
import unittest

import numpy as np
import tricover as tc

FOLDER = pathlib.Path(tc.__file__).parent


def public():
    """Names and objects: what the package exports, and what its classes have of their own."""
    yield "tricover", tc
    yield "tricover.paper", tc.paper
    for module, names in ((tc, [name for name in tc.__all__ if name != "paper"]), (tc.paper, tc.paper.__all__)):
        for name in names:
            value = getattr(module, name)
            if not callable(value):
                continue
            yield name, value
            if inspect.isclass(value):
                fields = getattr(value, "_fields", ()) + tuple(getattr(value, "__members__", ()))
                for own in vars(value):
                    # Of fields and members the class says what they are.
                    if (not own.startswith("_") or own == "__geo_interface__") and own not in fields:
                        yield f"{name}.{own}", getattr(value, own)


class Docstrings(unittest.TestCase):
    def test_everything_has_one_with_an_example(self):
        without = [name for name, value in public() if ">>>" not in (inspect.getdoc(value) or "")]
        self.assertEqual(without, [])
        self.assertGreater(len(list(public())), 100)

    def test_fields_have_texts(self):
        for name in tc.__all__:
            for field in getattr(getattr(tc, name), "_fields", ()):
                self.assertRegex(getattr(getattr(tc, name), field).__doc__, r"[\w)`]\.$", f"{name}.{field}")

    def test_examples_run(self):
        parser, runner = doctest.DocTestParser(), doctest.DocTestRunner(verbose=False, optionflags=doctest.ELLIPSIS)
        for name, value in public():
            given = {"tc": tc, "tricover": tc, "np": np}
            test = parser.get_doctest(inspect.getdoc(value) or "", given, name, None, None)
            report = []
            runner.run(test, out=report.append)
            with self.subTest(name):
                self.assertEqual(report, [], "".join(report))
        self.assertGreater(runner.tries, 100)

    def test_signatures_are_read(self):
        self.assertEqual(list(inspect.signature(tc.collide).parameters)[:4], ["a", "pose_a", "b", "pose_b"])
        self.assertEqual(inspect.signature(tc.Scene.collides).parameters["margin"].default, 0.0)


class Stubs(unittest.TestCase):
    def test_they_list_the_module(self):
        tree = ast.parse((FOLDER / "_tricover.pyi").read_text())

        def named(body):
            names = {node.name for node in body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
            return names | {node.target.id for node in body if isinstance(node, ast.AnnAssign)}

        there = {name for name in dir(tc._tricover) if not name.startswith("_")} | {"__version__"}
        self.assertEqual(named(tree.body), there)
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                has = {name for name in vars(getattr(tc, node.name)) if not name.startswith("_")}
                listed = {name for name in named(node.body) if not name.startswith("_")}
                self.assertEqual(listed, has, node.name)

    def test_stubtest(self):
        try:
            import mypy  # noqa: F401
        except ImportError:
            self.skipTest("mypy is not installed")
        run = subprocess.run([sys.executable, "-m", "mypy.stubtest", "tricover", "--allowlist", __file__.replace("test_docs.py", "stubtest.txt")],
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
