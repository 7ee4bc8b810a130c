#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Breaks the code in one place at a time and asks the test suite to notice.

usage: tests/mutation/run.py [--check] [--adapter] [--only REGEX] [--jobs N] [--scale 0.1] [--tests REGEX] [--work DIR] [--again]
       tests/mutation/run.py --random N [--files FILE...] [--seed S] ...

For every mutation of lists/<room>.py (with --adapter: of lists/adapter.py, on fcl_test, which needs FCL): applies it to a
copy of the project, builds the library and runs one test after the other until one fails, those first that noticed the last
mutations of the same file, then the quickest. Prints a line a mutation (killed by which test, or SURVIVED) and a table at the end;
exits 1 if one survived that isn't marked as equivalent, or doesn't compile. What was found is kept in DIR (default: build/mutation):
a run that was stopped goes on where it was, and a mutation is tried again when its file or its text has changed, or with --again.

--check only looks whether every text occurs exactly once in its file. That is a CTest; a run is not, since it takes an hour.

--random tries N random mutations of the files instead (default: all of src): a comparison, a sign or a constant that is another one, a
statement left out. A seed means the same ones as long as the files stay. Those that survive are holes in the tests, or change nothing.
"""
import argparse
import hashlib
import json
import os
import pathlib
import random
import re
import resource
import runpy
import shutil
import subprocess
import sys
import threading
import time

sys.dont_write_bytecode = True

ROOT = pathlib.Path(__file__).resolve().parents[2]
LISTS = {path.stem: runpy.run_path(str(path))["MUTATIONS"] for path in sorted((pathlib.Path(__file__).parent / "lists").glob("*.py"))}
CORE = [mutation for room, mutations in LISTS.items() if room != "adapter" for mutation in mutations]
ADAPTER = LISTS["adapter"]
# Neither the reference nor the workloads see the library's faults, and what stops by the clock finds other ones each time.
LEFT_OUT = re.compile(r"exact_reference_test|^reference_laws_test|workloads|fuzz_|soak_|fcl_alone|fcl_with_tricover")
# Compiled once instead of in every file: what no mutation changes.
CMAKE_CODE = """cmake_language(DEFER CALL target_precompile_headers tricover PRIVATE <Eigen/Core> <Eigen/Geometry> <Eigen/LU>
  <algorithm> <atomic> <cmath> <functional> <limits> <memory> <mutex> <queue> <stdexcept> <string> <vector>)
"""
MADE_OF = {"recording_in_chromium": "recording_page"}  # tests that are no executables: what they need
MEMORY = 6 << 30  # bytes: a mutation may allocate without end


def run(command, **kwargs):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", **kwargs)


def wrong_texts(mutations):
    """What stands in the way of applying them."""
    seen = set()
    for file, old, new, what in mutations:
        path = ROOT / file
        count = path.read_text().count(old) if path.exists() else 0
        if count != 1:
            yield f"{file}: {count} times in the file: {old}"
        if old == new or (file, old, new) in seen:
            yield f"{file}: changes nothing, or stands here twice: {what}"
        seen.add((file, old, new))


def key_of(mutation):
    file, old, new, _ = mutation
    return hashlib.sha256("\0".join((file, old, new, (ROOT / file).read_text())).encode()).hexdigest()[:16]


# What may stand in a line of code, and what it becomes.
SWAPS = {"<": ["<="], "<=": ["<"], ">": [">="], ">=": [">"], "==": ["!="], "!=": ["=="], "&&": ["||"], "||": ["&&"],
         "+": ["-"], "-": ["+"], "+=": ["-="], "-=": ["+="], "*": ["/"], "true": ["false"], "false": ["true"],
         "std::min": ["std::max"], "std::max": ["std::min"]}
# Operators stand between blanks (clang-format), which templates' brackets and pointers don't.
OPERATOR = re.compile(r"(?<= )(?:<=|>=|==|!=|&&|\|\||\+=|-=|[<>+*-])(?= )|\b(?:true|false|std::min|std::max)\b")
NUMBER = re.compile(r"(?<![\w.\[])(\d+)(?=[;,) ])")
NEGATION = re.compile(r"(?<=[( ])[-!](?=[\w(])")
STATEMENT = re.compile(r"^ +(?:if \(.*\) .*;|[\w.\[\]>-]+(?:\(.*\)| [-+*/|&]?= .*);|(?:\+\+|--)[\w.\[\]]+;)$")
NO_CODE = re.compile(r"^\s*(?://|#|static_assert|assert|using|template|namespace|\}|$)")


def random_mutations(files, count, seed):
    """That many, each (file, text that stands there once, replacement, what it is)."""
    drawn, found = random.Random(seed), []
    for file in files:
        lines = (ROOT / file).read_text().split("\n")
        text = "\n".join(lines)
        for i, line in enumerate(lines):
            code = line.split("//")[0].rstrip()
            if NO_CODE.match(line):
                continue
            changed = [(m.start(), m.group(), new) for m in OPERATOR.finditer(code) for new in SWAPS[m.group()]]
            changed += [(m.start(), m.group(), str(int(m.group()) + 1)) for m in NUMBER.finditer(code)]
            changed += [(m.start(), m.group(), "") for m in NEGATION.finditer(code)]
            mutants = [(line[:at] + new + line[at + len(old):], f"{old} -> {new or 'nothing'}") for at, old, new in changed]
            begins = next((above for above in reversed(lines[:i]) if above.strip()), "{").split("//")[0].rstrip()[-1:] in ";{}"
            if begins and STATEMENT.match(code):
                mutants.append(("", "left out"))
            # As many lines before it as it takes to be the only place.
            start = next(k for k in range(i, -1, -1) if text.count("\n".join(lines[k:i + 1]) + "\n") == 1 or k == 0)
            before = "\n".join(lines[start:i]) + "\n" * (start < i)
            found += [(file, before + line + "\n", before + new + "\n", f"line {i + 1}, {what}: {line.strip()}")
                      for new, what in mutants]
    return drawn.sample(found, min(count, len(found)))


class Tests:
    """The executables in the order in which they are tried: shared by all workers."""

    def __init__(self):
        self.seconds = {}
        self.kills = {}
        self.lock = threading.Lock()

    def order(self, file):
        with self.lock:
            kills = self.kills.get(file, {})
            # The same tests on other lanes: nothing else that they see differs.
            wanted = [t for t in self.seconds if file.startswith("src/hierarchy/") or not t.endswith("_portable")]
            return sorted(wanted, key=lambda test: (-kills.get(test, 0), self.seconds[test]))

    def killed(self, file, test):
        with self.lock:
            kills = self.kills.setdefault(file, {})
            kills[test] = kills.get(test, 0) + 1


class Worker:
    """A copy of the project with a build of its own."""

    def __init__(self, directory, arguments, tests):
        self.source, self.build = directory / "source", directory / ("build_fcl" if arguments.adapter else "build")
        self.adapter, self.scale, self.tests, self.wanted = arguments.adapter, arguments.scale, tests, arguments.tests
        self.library = "tricover_fcl" if arguments.adapter else "tricover"
        self.built = set()

    def prepare(self):
        listed = run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT).stdout.split("\n")
        for name in filter(None, listed):
            if not (ROOT / name).is_file():  # deleted
                (self.source / name).unlink(missing_ok=True)
                continue
            path, content = self.source / name, (ROOT / name).read_bytes()
            if not path.exists() or path.read_bytes() != content:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
        self.build.mkdir(parents=True, exist_ok=True)
        code = self.build / "mutation.cmake"
        code.write_text(CMAKE_CODE)
        configure = ["cmake", "-S", self.source, "-B", self.build, "-DCMAKE_BUILD_TYPE=Release",
                     # Asserts stay in, and those of the standard library are turned on: they notice what is read out of bounds.
                     # -w: a mutation may leave a variable unused.
                     "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -w -D_GLIBCXX_ASSERTIONS -DEIGEN_NO_DEBUG",
                     # A mutation of the core then links the library, and not every test.
                     f"-DBUILD_SHARED_LIBS={'OFF' if self.adapter else 'ON'}", "-DTRICOVER_EXPORT_KERNEL=ON",
                     "-DCMAKE_LINK_DEPENDS_NO_SHARED=ON",
                     f"-DCMAKE_PROJECT_tricover_INCLUDE={code}", "-DTRICOVER_BUILD_TESTS=ON",
                     f"-DTRICOVER_BUILD_FCL={'ON' if self.adapter else 'OFF'}"]
        if shutil.which("ninja"):
            configure += ["-G", "Ninja"]
        if shutil.which("ccache"):  # the workers' tests are the same, and so is what was restored after a mutation
            configure += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
            os.environ.update(CCACHE_BASEDIR=str(self.source.parents[1]), CCACHE_NOHASHDIR="1",
                              CCACHE_SLOPPINESS="pch_defines,time_macros")
        configured = run(configure)
        if configured.returncode != 0:
            raise RuntimeError(configured.stdout)
        # A test is named like its executable, whose path CTest doesn't say before it is built; but Chromium looks at a page.
        self.commands, part = {}, "/tests/fcl" if self.adapter else "/tests/"
        for test in json.loads(run(["ctest", "--test-dir", self.build, "--show-only=json-v1"]).stdout)["tests"]:
            directory = next(p["value"] for p in test["properties"] if p["name"] == "WORKING_DIRECTORY")
            program = str(pathlib.Path(directory) / test["name"])
            command = test.get("command", [program])
            if (command == [program] or test["name"] in MADE_OF) and part in directory and not LEFT_OUT.search(test["name"]) \
                    and re.search(self.wanted, test["name"]):
                self.commands[test["name"]] = command

    def make(self, test):
        return run(["cmake", "--build", self.build, "--target", MADE_OF.get(test, test), "-j", "1"])

    def try_test(self, test, seconds):
        """What failed, or nothing."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        environment = dict(os.environ, TRICOVER_TEST_SCALE=self.scale)
        try:
            tested = run([*self.commands[test], "--gtest_break_on_failure", "--gtest_color=no"], env=environment, timeout=seconds,
                         cwd=pathlib.Path(self.commands[test][-1]).parent, preexec_fn=None if test in MADE_OF else limit)
        except subprocess.TimeoutExpired:
            return f"{test} (no end)"
        if tested.returncode in (0, 77):  # 77: there is no Chromium
            return None
        started = re.findall(r"\[ RUN      \] (\S+)", tested.stdout)
        return f"{test}: {started[-1]}" if started else test

    def try_unmutated(self, test):
        built = self.make(test)
        if built.returncode != 0:
            raise RuntimeError(built.stdout)
        start = time.time()
        failed = self.try_test(test, 3600)
        if failed:
            raise RuntimeError(f"fails without a mutation: {failed}")
        self.tests.seconds[test] = time.time() - start

    def verdict(self, file):
        for test in [None, *self.tests.order(file)]:
            # With a shared library a test that is built stays as it is, unless it includes the header.
            kept = not self.adapter and test in self.built and file.endswith(".cpp")
            library = "tricover_io" if file.startswith("src/io/") else self.library
            built = None if kept else self.make(test or library)
            if test:
                self.built.add(test)
            if built and built.returncode != 0:
                if "static assertion failed" in built.stdout:
                    return "killed by static_assert"
                error = next((line for line in built.stdout.splitlines() if "error:" in line), built.stdout[-300:])
                return f"DOES NOT COMPILE: {error.replace(str(self.source), '')}"
            failed = self.try_test(test, 30 + 10 * self.tests.seconds[test]) if test else None
            if failed:
                self.tests.killed(file, test)
                return f"killed by {failed}"
        return "SURVIVED"

    def try_mutation(self, mutation):
        file, old, new, _ = mutation
        path = self.source / file
        original = path.read_text()
        path.write_text(original.replace(old, new))
        try:
            return self.verdict(file)
        finally:
            path.write_text(original)
            if not file.endswith(".cpp"):
                self.built.clear()


def in_parallel(workers, work, items):
    """work(worker, item) for all of them; the first exception ends it."""
    items, lock, raised = list(items), threading.Lock(), []

    def loop(worker):
        while not raised:
            with lock:
                if not items:
                    return
                item = items.pop(0)
            try:
                work(worker, item)
            except Exception as error:
                raised.append(error)

    threads = [threading.Thread(target=loop, args=(worker,)) for worker in workers]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if raised:
        sys.exit(str(raised[0]))


def print_table(found):
    rooms, columns = {}, ["killed", "equivalent", "survived", "broken"]
    for (file, _, _, what), verdict in found.items():
        kind = {"killed": "killed", "DOES": "broken"}.get(verdict.split()[0], "equivalent" if "(equivalent" in what else "survived")
        row = rooms.setdefault(file.rsplit("/", 1)[0], dict.fromkeys(columns, 0))
        row[kind] += 1
    print(f"\n{'room':28}{'mutations':>10}" + "".join(f"{c:>12}" for c in columns))
    for room, row in [*sorted(rooms.items()), ("all", {c: sum(r[c] for r in rooms.values()) for c in columns})]:
        print(f"{room:28}{sum(row.values()):>10}" + "".join(f"{n:>12}" for n in row.values()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="only look for the texts")
    parser.add_argument("--adapter", action="store_true", help="the adapter's mutations instead of the core's")
    parser.add_argument("--only", default="", help="mutations whose line (file: what it breaks) matches this expression")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="mutations at a time, each with a build of its own")
    parser.add_argument("--scale", default="0.1", help="TRICOVER_TEST_SCALE for the tests")
    parser.add_argument("--tests", default="", help="try these tests only: an expression that their names match")
    parser.add_argument("--work", default=ROOT / "build" / "mutation", help="where to copy and build, and what was found is kept")
    parser.add_argument("--again", action="store_true", help="forget what was found")
    parser.add_argument("--random", type=int, default=0, metavar="N", help="so many random mutations instead")
    parser.add_argument("--files", nargs="*", help="of these files (with --random)")
    parser.add_argument("--seed", type=int, default=1, help="which ones (with --random)")
    arguments = parser.parse_args()

    wrong = [*wrong_texts(CORE), *wrong_texts(ADAPTER)]
    if arguments.check and not wrong:
        print(f"{len(CORE)} and {len(ADAPTER)} mutations can be applied")
    if wrong or arguments.check:
        return "\n".join(wrong) if wrong else 0

    mutations = [m for m in (ADAPTER if arguments.adapter else CORE)
                 if re.search(arguments.only, f"{m[0]}: {m[3]}")]
    if arguments.random:
        rooms = ROOT / ("fcl_adapter/src" if arguments.adapter else "src")
        missing = [file for file in arguments.files or [] if not (ROOT / file).is_file()]
        if missing:
            return "no such file: " + ", ".join(missing)
        files = arguments.files or sorted(str(path.relative_to(ROOT)) for path in rooms.rglob("*") if path.suffix in (".h", ".cpp"))
        mutations = random_mutations(files, arguments.random, arguments.seed)
    work = pathlib.Path(arguments.work).resolve()
    work.mkdir(parents=True, exist_ok=True)
    results = work / "results.txt"  # a key and a verdict a line
    if arguments.again:
        results.unlink(missing_ok=True)
    verdicts = dict(line.split(" ", 1) for line in results.read_text().splitlines()) if results.exists() else {}
    keys = {m: key_of(m) for m in mutations}  # now: the project may change while this runs
    # A header that everything includes takes many times as long as a file.
    left = sorted((m for m in mutations if keys[m] not in verdicts), key=lambda m: (not m[0].endswith(".cpp"), m[0]))

    if left:
        tests, lock = Tests(), threading.Lock()
        workers = [Worker(work / str(k), arguments, tests) for k in range(min(arguments.jobs, len(left)))]
        in_parallel(workers, lambda _, worker: worker.prepare(), workers)
        if not workers[0].commands:
            sys.exit("there are no tests")
        on_lanes = any(mutation[0].startswith("src/hierarchy/") for mutation in left)
        wanted = [test for test in sorted(workers[0].commands) if on_lanes or not test.endswith("_portable")]
        in_parallel(workers, Worker.try_unmutated, wanted)
        print(f"without a mutation {len(tests.seconds)} tests pass in {sum(tests.seconds.values()):.0f} s", flush=True)

        def try_one(worker, mutation):
            start = time.time()
            verdict = worker.try_mutation(mutation)
            with lock:
                verdicts[keys[mutation]] = verdict
                with results.open("a") as file:
                    print(keys[mutation], verdict, file=file)
                print(f"{verdict:70} {mutation[0]}: {mutation[3]} ({time.time() - start:.0f} s)", flush=True)

        in_parallel(workers, try_one, left)
    found = {m: verdicts[keys[m]] for m in mutations}
    bad = [m for m in mutations if not found[m].startswith("killed") and "(equivalent" not in m[3]
           and not (arguments.random and found[m].startswith("DOES"))]
    for m in bad:
        print(f"{found[m]}: {m[0]}: {m[3]}")
    for m in mutations:
        if "(equivalent" in m[3] and found[m].startswith("killed"):
            print(f"marked as equivalent, but {found[m]}: {m[0]}: {m[3]}")
    print_table(found)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
