#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each program, and each part of one, in README.md and fcl_adapter/README.md is in a file that CTest runs, line by line.

Indentation that all lines of a part share doesn't count.
"""
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = ("README.md", "fcl_adapter/README.md")
PROGRAMS = [path for folder, ending in (("tests/examples", "cpp"), ("tests/examples", "py"), ("fcl_adapter/examples", "cpp"))
            for path in sorted((ROOT / folder).glob("*." + ending))]
BLOCK = re.compile(r"^```(cpp|python)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def holds(lines, part):
    """Whether the part's lines follow each other in a program, however far all of them are indented."""
    def shape(run):
        return textwrap.dedent("\n".join(run))
    return any(shape(lines[i:i + len(part)]) == shape(part) for i in range(len(lines) - len(part) + 1))


def main() -> int:
    programs = [path.read_text().splitlines() for path in PROGRAMS]
    count, wrong = 0, []
    for document in DOCUMENTS:
        for _, block in BLOCK.findall((ROOT / document).read_text()):
            count += 1
            if not any(holds(lines, block.splitlines()) for lines in programs):
                wrong.append(f"{document}: no example has\n{block}")
    print("\n".join(wrong) or f"{count} programs and parts of programs are those of examples")
    return 1 if wrong or count < 4 else 0


if __name__ == "__main__":
    sys.exit(main())
