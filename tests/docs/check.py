#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The API reference has every public free function and class, and each of their descriptions shows an example, as does each of
Scene's functions; what says what it throws says first what it does; the files and headings that our documents name exist; the front
page is short.

usage: tests/docs/check.py HTML   (the directory that Doxygen wrote)

A free function's declaration begins in the first column, as clang-format leaves it. Of overloads, one example is enough.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECLARED = re.compile(r"((?:^///[^\n]*\n)*)(?:^template[^\n]*\n)?^(?!using|extern|template|struct|enum|namespace|static_assert)"
                      r"[A-Za-z][\w:<>,&* ]*?[ &*](\w+)\(", re.MULTILINE)
DETAIL = re.compile(r"^namespace detail \{.*?^\}  // namespace detail$", re.MULTILINE | re.DOTALL)  # no part of the interface
CLASS = re.compile(r"((?:^///[^\n]*\n)+)(?:^template[^\n]*\n)?^class (?:TRICOVER\w* )?(\w+)", re.MULTILINE)

INVENTED = {"app.cpp", "src/room/file.cpp"}  # in commands that a user types
DOCUMENTS = (
    "README.md",
    "src/README.md",
    "src/mainpage.md",
    "bench/README.md",
    "bench/data/README.md",
    "fcl_adapter/README.md",
    ".github/CONTRIBUTING.md",
)
FRONT_PAGE = 160  # lines, at the most
NAMED = re.compile(r"(?<![\w/<>*.-])((?:[\w.]+/)*\w+\.(?:h|cpp|py|sh|cmake|md))(?![\w.-])")
METHOD = re.compile(r"((?:^  ///[^\n]*\n)+)^  (?:const )?[\w:<>&]+ (\w+)\(", re.MULTILINE)
THROWS_FIRST = re.compile(r"^(?! *///)[^\n]*\n *///<? (\\throws|See)|///< (\\throws|See)", re.MULTILINE)
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]+))?\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)


def anchors(document):
    """Of headings, as GitHub makes them."""
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in HEADING.findall(document.read_text())}


def dead_links():
    for document in DOCUMENTS:
        for file, anchor in LINK.findall((ROOT / document).read_text()):
            target = (ROOT / document).parent / file if file else ROOT / document
            if "://" not in file and not (target.is_file() and (not anchor or anchor in anchors(target))):
                yield f"{document}: there is no {file}{'#' + anchor if anchor else ''}"


def long_front_page():
    lines = (ROOT / "README.md").read_text().count("\n")
    if lines > FRONT_PAGE:
        yield f"README.md has {lines} lines: what a newcomer doesn't need on the first day belongs into the README.md of its folder"


def undescribed(header):
    """Functions of a header that say what they throw, or where to look, before what they do; of Scene, those without an example."""
    text = DETAIL.sub("", header.read_text())
    name = header.relative_to(ROOT)
    for found in THROWS_FIRST.finditer(text):
        yield f"{name}:{text.count(chr(10), 0, found.end()) + 1}: says what is thrown before what is done"
    if header.name == "scene.h":
        for comment, method in METHOD.findall(text[text.index("class TRICOVER_EXPORT Scene"):]):
            if "\\snippet" not in comment:
                yield f"{name}: Scene::{method} shows no example"


def strangers():
    """Files that a document names, by the end of their path, and that there aren't."""
    known = {"/" + path.relative_to(ROOT).as_posix() for folder in ("src", "include", "fcl_adapter", "tests", "bench", ".github")
             for path in (ROOT / folder).rglob("*")} | {"/" + path.name for path in ROOT.iterdir()}
    for document in DOCUMENTS:
        for name in sorted(set(NAMED.findall((ROOT / document).read_text())) - INVENTED):
            if not any(path.endswith("/" + name.removeprefix("../")) for path in known):
                yield f"{document}: there is no {name}"


def main() -> int:
    html = pathlib.Path(sys.argv[1])
    wrong = [*strangers(), *dead_links(), *long_front_page()]
    for folder, namespace in ((ROOT / "include/tricover", "tricover"), (ROOT / "fcl_adapter/include/tricover_fcl", "tricover_fcl")):
        page = html / f"namespace{namespace.replace('_', '__')}.html"
        inner = sorted(html.glob(f"{page.stem}_1_1*.html"))  # namespaces within it
        listed = "".join(path.read_text() for path in [page, *inner] if path.exists())
        descriptions = {}
        for header in sorted(folder.glob("*.h")):
            wrong += undescribed(header)
            text = DETAIL.sub("", header.read_text())
            for comment, name in DECLARED.findall(text) + CLASS.findall(text):
                descriptions.setdefault(name, []).append((header, comment))
        if not descriptions:
            wrong.append(f"{folder}: declares nothing")
        for name, found in descriptions.items():
            header = found[0][0].relative_to(ROOT)
            if f">{name}<" not in listed:
                wrong.append(f"{header}: {namespace}::{name} is not in {page.name}")
            if not any("\\snippet" in comment for _, comment in found):
                wrong.append(f"{header}: {namespace}::{name} shows no example")
            for path, comment in found:
                if not comment:
                    wrong.append(f"{path.relative_to(ROOT)}: {namespace}::{name} has an overload without a description")
    print("\n".join(wrong) or "every function and class is listed and shows an example; every file that is named exists")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
