"""`pip install` of the package in a virtual environment, without a network; then an import and an answer from there.

usage: installs_by_pip.py SOURCE WORK. Leaves with 77, a skipped test, where venv, pip or setuptools are missing.
"""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

PROGRAM = "import tricover as tc; print(tc.__file__, tc.__version__, tc.Polygon.box(2, 3).area)"


def main():
    source, work = sys.argv[1], pathlib.Path(sys.argv[2])
    if missing := [name for name in ("venv", "ensurepip", "setuptools", "wheel") if not importlib.util.find_spec(name)]:
        print("skipped: there is no", ", ".join(missing))
        return 77
    shutil.rmtree(work, ignore_errors=True)
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", work], check=True)
    python = work / "bin/python"
    subprocess.run([python, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", source], check=True)
    without = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    said = subprocess.run([python, "-c", PROGRAM], check=True, capture_output=True, text=True, env=without, cwd=work).stdout
    print(said)
    file, version, area = said.split()
    return 0 if pathlib.Path(file).is_relative_to(work.resolve()) and version[0].isdigit() and area == "6.0" else 1


if __name__ == "__main__":
    sys.exit(main())
