#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the module's docstrings of its stubs, each under the signature that inspect.signature() reads.

usage: docstrings.py STUB... OUTPUT.cpp
"""
import ast
import json
import pathlib
import sys

HEAD = """// By docstrings.py, of the stubs.
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace tricover_python {

const char* doc(const char* name) {
  static const std::unordered_map<std::string, const char*> texts = {
"""
TAIL = """  };
  const auto found = texts.find(name);
  if (found == texts.end()) throw std::logic_error(std::string("the stubs have no docstring for ") + name);
  return found->second;
}

}  // namespace tricover_python
"""


def is_named(node, decorator):
    return any(isinstance(one, ast.Name) and one.id == decorator for one in node.decorator_list)


def signature(function):
    arguments = ast.parse(ast.unparse(function.args).join(["def f(", "): 0"])).body[0].args
    for argument in arguments.posonlyargs + arguments.args + arguments.kwonlyargs:
        argument.annotation = None
    return f"{function.name}({ast.unparse(arguments)})"


def documented(body, prefix):
    """Names and texts of what a module's or a class's body has; of overloads, the first one's text and all signatures."""
    for node in body:
        text = ast.get_docstring(node) if isinstance(node, (ast.ClassDef, ast.FunctionDef)) else None
        if not text:
            continue
        if isinstance(node, ast.ClassDef):
            yield prefix + node.name, text
            yield from documented(node.body, prefix + node.name + ".")
        elif is_named(node, "overload"):
            others = [one for one in body if isinstance(one, ast.FunctionDef) and one.name == node.name]
            yield prefix + node.name, "\n".join(signature(one) for one in others) + "\n\n" + text
        elif is_named(node, "property"):
            yield prefix + node.name, text
        else:
            yield prefix + node.name, signature(node) + "\n--\n\n" + text


def main():
    *stubs, output = map(pathlib.Path, sys.argv[1:])
    with open(output, "w") as file:
        file.write(HEAD)
        for stub in stubs:
            for name, text in documented(ast.parse(stub.read_text()).body, "paper." if stub.stem == "paper" else ""):
                file.write(f"      {{{json.dumps(name)}, {json.dumps(text)}}},\n")
        file.write(TAIL)


if __name__ == "__main__":
    main()
