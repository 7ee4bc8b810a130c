#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What our documents tell a user to install is what the build needs and what our scripts install.

README's build line and the tables of options there and in CONTRIBUTING name Debian's packages. They are those of tests/run.sh and bench/run.sh, those that
CMake looks for in the folder that an option builds, and those of every other command in a document that sets the option.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = ("README.md", "bench/README.md", "fcl_adapter/README.md", ".github/CONTRIBUTING.md")

PACKAGES = {  # of what CMake looks for
    "Eigen3": "libeigen3-dev", "fcl": "libfcl-dev", "yaml-cpp": "libyaml-cpp-dev", "PNG": "libpng-dev", "nlohmann_json": "nlohmann-json3-dev", "ompl": "libompl-dev", "TBB": "libtbb-dev",
    "MPI": "libopenmpi-dev", "pybind11": "pybind11-dev", "Python": "python3-dev", "Python3": "python3", "GTest": "libgtest-dev",
    "GMP_LIBRARY": "libgmp-dev", "GMPXX_LIBRARY": "libgmp-dev", "CCD_LIBRARY": "libccd-dev", "FCL_LIBRARY": "libfcl-dev",
    "OCTOMAP_LIBRARY": "libfcl-dev", "OCTOMATH_LIBRARY": "libfcl-dev", "Doxygen": "doxygen", "PkgConfig": "pkg-config",
    "benchmark": "libbenchmark-dev", "GEOS": "libgeos++-dev", "box2d": "libbox2d-dev", "Boost": "libboost-dev"}
OPTIONS = (  # which option builds a folder: the first that fits
    ("src/python", "PYTHON"), ("tests/python", "PYTHON"), ("tests/examples", "EXAMPLES"), ("fcl_adapter/examples", "EXAMPLES"),
    ("tests", "TESTS"), ("src/docs.cmake", "TESTS"), ("src/io", "IO"), ("fcl_adapter", "FCL"), ("bench", "BENCH"))
LOOKS_FOR = re.compile(r"^\s*(?:find_package|find_library)\(([\w+-]+)", re.MULTILINE)
ROW = re.compile(r"^\| `TRICOVER_BUILD_(\w+)`.*\| `([^`]*)` \|$", re.MULTILINE)
APT = re.compile(r"apt install ((?: ?[a-z][\w+.-]*)+)")
COMMANDS = re.compile(r"(?:^ {4}.*\n)+", re.MULTILINE)


def installedBy(script):
    """The arguments of .ci/install, which go on over lines."""
    text = (ROOT / script).read_text().replace("\\\n", " ")
    packages = set(re.search(r"^bash \.ci/install (.*)$", text, re.MULTILINE)[1].split())
    return packages - {"build-essential"} | {"g++"}


def main() -> int:
    wrong = []
    readme, contributing = ((ROOT / name).read_text() for name in ("README.md", ".github/CONTRIBUTING.md"))
    build = set(APT.search(readme)[1].split())
    rows = collections.defaultdict(set, {option: set(packages.split()) for option, packages in ROW.findall(readme + contributing)})

    def compare(what, named, wanted):
        wrong.extend(f"{what}: {package} is {'missing' if package in wanted else 'not wanted'}" for package in sorted(named ^ wanted))

    compare("README beside tests/run.sh", build.union(*(rows[option] for option in rows if option != "BENCH")), installedBy("tests/run.sh"))
    compare("README beside bench/run.sh", build - {"pkg-config"} | rows["FCL"] | rows["BENCH"], installedBy("bench/run.sh"))

    for path in [ROOT / "CMakeLists.txt", *(path for folder in ("src", "fcl_adapter", "tests", "bench")
                                            for path in (ROOT / folder).rglob("*") if path.suffix in (".cmake", ".txt"))]:
        name = path.relative_to(ROOT).as_posix()
        option = next((option for folder, option in OPTIONS if name.startswith(folder)), None)
        known = build | rows[option or "IO"]
        for wanted in LOOKS_FOR.findall(path.read_text()):
            if wanted != "tricover" and PACKAGES.get(wanted) not in known:
                wrong.append(f"the row of {option}: {PACKAGES.get(wanted)} is missing, for {wanted} of {name}")

    for document in DOCUMENTS:
        for commands in COMMANDS.findall((ROOT / document).read_text()):
            if re.search(r" -j(?!\S| \S)", commands):
                wrong.append(f"{document}: -j without a number of jobs: {commands.strip()}")
            for option in re.findall(r"-DTRICOVER_BUILD_(\w+)=ON", commands):
                if APT.search(commands):
                    compare(f"{document}, {option}", set(APT.search(commands)[1].split()), rows[option])

    print("\n".join(wrong) or "the documents name the packages that the build needs")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
