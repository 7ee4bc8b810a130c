# SPDX-License-Identifier: BSD-3-Clause
"""Lets CMake build the module: the same one that `cmake --install` installs. pip runs this file."""
import atexit
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parents[2]


def version():
    """The headers': they say which version this is."""
    header = ROOT / "include/tricover/version.h"
    if not header.is_file():
        sys.exit(f"{header} is missing: pip needs the whole repository, as in `pip install ./src/python`")
    numbers = dict(re.findall(r"^#define TRICOVER_VERSION_(MAJOR|MINOR|PATCH) (\d+)$", header.read_text(), re.M))
    return "{MAJOR}.{MINOR}.{PATCH}".format(**numbers)


class Build(build_ext):
    def build_extension(self, ext):
        module = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        work = pathlib.Path(self.build_temp).resolve()
        work.mkdir(parents=True, exist_ok=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        options = ["-DTRICOVER_BUILD_PYTHON=ON", "-DTRICOVER_BUILD_FCL=OFF", "-DTRICOVER_INSTALL=OFF", "-DBUILD_SHARED_LIBS=OFF",
                   "-DCMAKE_BUILD_TYPE=Release", f"-DPython_EXECUTABLE={sys.executable}",
                   f"-DTRICOVER_PYTHON_OUTPUT={module.parent}"]
        subprocess.run(["cmake", "-S", ROOT, "-B", work, *options], check=True)
        subprocess.run(["cmake", "--build", work, "--target", "tricover_python", "-j", jobs], check=True)


# Nothing is left beside the sources.
work = tempfile.mkdtemp(prefix="tricover-")
atexit.register(shutil.rmtree, work, ignore_errors=True)
setup(version=version(), ext_modules=[Extension("tricover._tricover", [])], cmdclass={"build_ext": Build},
      options={"build": {"build_base": work}, "egg_info": {"egg_base": work}})
