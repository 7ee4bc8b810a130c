#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the sources to the drawing: every room includes only the rooms above it, and nothing is longer than it may be.

usage: tests/rooms.py [ROOT]

A public header belongs to the room that defines its functions, and is included by that room and later ones alone.

Fails on an #include that leads to a later room, between two rooms that must not see each other, or from the adapter
into the core's private headers, but for numbers; on a cycle between files; on a function that one room declares and another defines; on a
file or a function that is too long.
"""
import pathlib
import re
import sys

# First to last; rooms that share a line don't see each other.
CORE = [["numbers"], ["polygon"], ["hierarchy"], ["pair"], ["convex"], ["overlay"], ["distance", "impact"], ["penetration"],
        ["contact", "paper"], ["depth"], ["scene"], ["drawing", "io"], ["python"]]
# Public headers by the room that defines their functions. All others define none: types, options and results.
PUBLIC = {
    "numbers": ["motion", "pose", "trajectory"],
    "polygon": ["outline", "pair_cache", "polygon"],
    "hierarchy": ["locate"],
    "overlay": ["validity"],
    "distance": ["distance"],
    "impact": ["ray"],
    "penetration": ["penetration"],
    "contact": ["contacts"],
    "paper": ["paper"],
    "depth": ["collide", "conflicts", "covers", "depth", "least_distance", "prepare", "signed_distance", "time_of_impact"],
    "scene": ["scene"],
    "drawing": ["recording", "svg"],
    "io": ["geojson", "occupancy_grid_io", "rasterize", "wkt"],
}
TYPES = ["collide_options", "export", "impact", "location", "ray_hit", "touching", "tricover", "version"]
ADAPTER = [["shape"], ["shadow"], ["queries"], ["broadphase", "entry"]]

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
# At a namespace's level: a function's name, and ';' after a declaration or '{' after a definition.
FUNCTION = re.compile(
    r"^(?=\S)(?:[\w:&*<>,\[\] ]+[ &*>])?((?:\w+::)*~?\w+)\([^;{}]*\)(?: const| noexcept)*\s*"
    r"(?:: [^;{}]*(?:\{[^{}]*\}[^;{}]*)*)?([;{])", re.M)
CLASS = re.compile(r"^(?:struct|class) (?:alignas\(\w+\) )?(\w+)[^;{]*\{(.*?)^\};", re.M | re.S)
MEMBER = re.compile(r"^  (?:[\w:&*<>, ]+[ &*>])?(~?\w+)\([^;{}]*\)(?: const| noexcept)*;", re.M)
MOST_LINES = {"file": 500, "function": 65}
# Where a function's body begins, and its last line, indented alike.
BODY = re.compile(r"^( *)(?![ :}]|namespace|struct|class|enum|extern|union|#)[^\n;{}]*\([^;]*?\{\n.*?^\1\}", re.M | re.S)


def uncommented(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)


class House:
    """The files of one source directory, by the name that an #include gives them."""

    def __init__(self, directory, rows, guest=None, owners=None):
        self.guest = guest  # a room of another house that all rooms see
        self.owners = owners or {}  # of public headers
        self.rank = {room: i for i, row in enumerate(rows) for room in row}
        self.rank[""] = -1  # a file outside of the rooms sees none of them
        self.files = {}
        for path in sorted(directory.rglob("*")):
            if path.suffix in (".h", ".cpp"):
                self.files[path.relative_to(directory).as_posix()] = uncommented(path.read_text())

    def includes(self, file):
        return INCLUDE.findall(self.files[file])

    def faults(self, include_directories):
        headers = [path for directory in include_directories for path in directory.rglob("*.h")]
        public = {name for path in headers for name, end in FUNCTION.findall(uncommented(path.read_text()).replace(" = {}", ""))}
        for file in self.files:
            room = self.room(file)
            if room not in self.rank:
                yield f"{file} is in no room"
                continue
            for name in self.includes(file):
                if name in self.files:
                    other = self.room(name)
                    if not self.sees(room, other):
                        yield f'{file} includes "{name}", but {room} does not see {other}'
                elif self.guest and name.startswith(self.guest.name + "/") and (self.guest.parent / name).is_file():
                    continue
                elif name in self.owners and not self.sees(room, self.owners[name]):
                    yield f'{file} includes "{name}", but {room} does not see {self.owners[name]}, which defines it'
                elif not any((directory / name).is_file() for directory in include_directories):
                    yield f'{file} includes "{name}", which is neither in a room nor public'
        yield from self.cycles()
        yield from self.strangers(public)

    def sees(self, room, other):
        return other == room or self.rank.get(other, len(self.rank)) < self.rank[room]

    @staticmethod
    def room(file):
        return file.split("/")[0] if "/" in file else ""

    def cycles(self):
        """Depth first; a file that is met again on the way to itself closes a cycle."""
        done = set()

        def visit(file, way):
            if file in way:
                yield "a cycle of includes: " + " -> ".join(way[way.index(file):] + [file])
            elif file not in done:
                for name in self.includes(file):
                    if name in self.files:
                        yield from visit(name, way + [file])
                done.add(file)

        for file in self.files:
            yield from visit(file, [])

    def strangers(self, public):
        """Functions that a header of one room declares and a source of another defines. A name that is public, too, may
        be an overload of what the public header declares."""
        declared = {}
        for file, text in self.files.items():
            if file.endswith(".h"):
                for name, end in FUNCTION.findall(text):
                    if end == ";":
                        declared.setdefault(name, set()).add(self.room(file))
                for owner, body in CLASS.findall(text):
                    for name in MEMBER.findall(body):
                        declared.setdefault(f"{owner}::{name}", set()).add(self.room(file))
        for file, text in self.files.items():
            if not file.endswith(".cpp"):
                continue
            for name, end in FUNCTION.findall(without_unnamed(text)):
                rooms = declared.get(name)
                if end == "{" and rooms and self.room(file) not in rooms and name not in public:
                    yield f"{file} defines {name}, which {'/'.join(sorted(rooms))} declares"


def without_unnamed(text):
    """Without what unnamed namespaces hold, which no header declares."""
    result, at = "", 0
    while (start := text.find("namespace {", at)) >= 0:
        result += text[at:start]
        at, depth = start + len("namespace {"), 1
        while depth:
            depth += {"{": 1, "}": -1}.get(text[at], 0)
            at += 1
    return result + text[at:]


def strays(include):
    """Public headers that PUBLIC and TYPES don't name once, or types that declare a function after all."""
    named = sorted(sum(PUBLIC.values(), []) + TYPES)
    there = sorted(path.stem for path in include.glob("*.h"))
    if named != there:
        yield f"public headers: PUBLIC and TYPES should name {sorted(set(named) ^ set(there))}"
    for name in TYPES:
        if re.search(r"^TRICOVER_EXPORT", uncommented((include / f"{name}.h").read_text()), re.M) and name != "version":
            yield f"{name}.h declares a function, and belongs to no room"


def too_long(root):
    """Files, and functions of the libraries; in tests and bench a function may be a table."""
    for folder in ("src", "include", "fcl_adapter", "tests", "bench"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp", ".py", ".cmake"):
                continue
            text = path.read_text()
            if text.count("\n") > MOST_LINES["file"]:
                yield f"{path.relative_to(root)} has {text.count(chr(10))} lines"
            if folder in ("src", "fcl_adapter"):
                for found in BODY.finditer(uncommented(text)):
                    if (lines := found.group(0).count("\n") + 1) > MOST_LINES["function"]:
                        yield f"{path.relative_to(root)}: a function of {lines} lines, {found.group(0).split(chr(10))[0].strip()}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[1])
    own, fcl = root / "include", root / "fcl_adapter/include"
    owners = {f"tricover/{name}.h": room for room, names in PUBLIC.items() for name in names}
    faults = list(House(root / "src", CORE, owners=owners).faults([own]))
    faults += strays(own / "tricover")
    faults += House(root / "fcl_adapter/src", ADAPTER, root / "src/numbers").faults([own, fcl])
    faults += too_long(root)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
