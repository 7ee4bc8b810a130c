#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each \\throws of a public header has a THROWS in tests/docs/throws.cpp or throws_fcl.cpp, of the same header, function and exception, and each
THROWS has its \\throws. A function's overloads count: two that throw have two calls. No header names an exception otherwise.

A comment belongs to the declaration that follows. Members and constructors are Class::name, and what all members of a class throw
is said of the class.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CALLED_BY = {"include/tricover": "throws.cpp", "fcl_adapter/include/tricover_fcl": "throws_fcl.cpp"}
UNCALLED = {
    ("scene.h", "Scene::add", "std::length_error"),  # 2^28 bodies do not fit into memory,
    ("scene_manager.h", "SceneManager", "std::length_error"),  # nor do as many objects
    ("registration.h", "registerNarrowphase", "std::logic_error"),  # only a program that is linked wrongly: tests/consumer
}

THROWS = re.compile(r"\\throws (std::\w+)")
EXCEPTION = re.compile(r"(?<!\\throws )\bstd::\w*(?:error|argument|out_of_range)\b|\bThrows\b|\\throws (?!std::\w)")
CLASS = re.compile(r"^(?:class|struct) (?:TRICOVER\w* )?(\w+)[^;]*$")
DECLARED = re.compile(r"(~?\w+)\(")
CALL = re.compile(r"\bTHROWS\(\s*([\w.]+),\s*([\w:]+),\s*(std::\w+),")


def promises(header):
    """(function, exception) of each \\throws of a header, in order."""
    scope, comment = None, []
    for line in header.read_text().splitlines():
        if line.lstrip().startswith("///"):
            comment.append(line.strip(" /"))
            continue
        opened = CLASS.match(line)
        if opened:
            scope = opened[1]
        declared = opened or DECLARED.search(line)
        if declared or not line.strip():
            name = scope if opened or not declared else f"{scope}::{declared[1]}" if scope else declared[1]
            for exception in THROWS.findall(" ".join(comment)):
                yield name, exception
            comment = []
        if line.startswith("}"):
            scope = None


def main() -> int:
    wrong, count = [], 0
    for folder, source in CALLED_BY.items():
        said = collections.Counter()
        for header in sorted((ROOT / folder).glob("*.h")):
            said.update((header.name, *promise) for promise in promises(header))
            text = re.sub(r"\n *///? ?", " ", header.read_text())
            wrong += [f"{folder}/{header.name}: \"{found}\" is not said by \\throws and its type" for found in EXCEPTION.findall(text)]
        called = collections.Counter(CALL.findall((ROOT / "tests/docs" / source).read_text()))
        wrong += [f"{folder}/{' '.join(promise)}: {times} \\throws, {called[promise]} calls in {source}"
                  for promise, times in sorted(said.items()) if called[promise] < times and promise not in UNCALLED]
        wrong += [f"{folder}/{' '.join(call)}: is called in {source}, and no \\throws says so" for call in sorted(called.keys() - said.keys())]
        count += sum(said.values())
    if count < 100:
        wrong.append(f"only {count} \\throws were found")
    print("\n".join(wrong) or f"each of {count} \\throws has its call")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
