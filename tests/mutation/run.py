#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Breaks the kernel in one place at a time and asks the test suite to notice.

usage: tests/mutation/run.py [--only TEXT] [--scale 0.1] [--work DIR]

Copies the project to DIR (default: a temporary one), builds the core's tests there and, for every mutation below, applies it, rebuilds and
runs them. Prints a line a mutation (killed by which test, or SURVIVED) and the totals; exits 1 if one survived that isn't marked
as equivalent. Not part of ctest: it takes about a minute a mutation.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]

# (file, text as it stands there, replacement, what it breaks); the text must occur exactly once.
MUTATIONS = [
    # Predicates: the filter's sign and each term of its bound.
    ("src/predicates.h", "if (det > bound) return 1;", "if (det > bound) return -1;", "filter: sign of a left turn"),
    ("src/predicates.h", "if (-det > bound) return -1;", "if (-det > bound) return 1;", "filter: sign of a right turn"),
    ("src/predicates.h", "if (det > bound) return 1;", "if (det >= 0) return 1;", "filter: no bound"),
    ("src/predicates.h", "const double det = left - right;", "const double det = left + right;", "filter: determinant"),
    ("src/predicates.h", "5 * kUlp * (std::abs(left)", "0.5 * kUlp * (std::abs(left)", "filter: rounding term too small"),
    ("src/predicates.h", "(ew * (std::abs(ux) + std::abs(uy))", "(0 * (std::abs(ux) + std::abs(uy))", "filter: error of r"),
    ("src/predicates.h", "eu * (std::abs(wx) + std::abs(wy) + 2 * ew)", "0 * (std::abs(wx) + std::abs(wy) + 2 * ew)", "filter: error of q"),
    ("src/predicates.h", "eu = p.error + q.error", "eu = p.error", "filter: q's error dropped"),
    ("src/predicates.h", "ew = p.error + r.error", "ew = r.error", "filter: p's error dropped"),
    ("src/predicates.h", "constexpr double kTiny = 0x1p-1010;", "constexpr double kTiny = 0;", "filter: underflow term"),
    ("src/predicates.h", "return square > 0x1p-960 &&", "return square > 0 &&", "discs: squares of denormals trusted"),
    ("src/predicates.h", "&& square <= std::numeric_limits<double>::max() ?", "?", "discs: overflowed squares trusted"),
    ("src/predicates.h", "return sign != kUncertain ? sign : orientExact({nullptr, p}, {nullptr, q}, {nullptr, r});", "return sign != kUncertain ? sign : 0;", "orientation: no exact stage"),
    # Exact stage.
    ("src/predicates.cpp", "return u.x * w.y - u.y * w.x;", "return u.x * w.y + u.y * w.x;", "exact: cross product"),
    ("src/predicates.cpp", "return u.x * w.x + u.y * w.y;", "return u.x * w.x - u.y * w.y;", "exact: dot product"),
    ("src/predicates.cpp", " + Dyadic(m(axis, 2));", ";", "exact: translation dropped"),
    ("src/predicates.cpp", "Dyadic(m(axis, 1))", "Dyadic(m(1, axis))", "exact: rotation transposed"),
    ("src/predicates.cpp", "compareExact(p, v, 0) * compareExact(p, w, 0) <= 0 &&", "", "between: x ignored"),
    ("src/predicates.cpp", "&& compareExact(p, v, 1) * compareExact(p, w, 1) <= 0", "", "between: y ignored"),
    ("src/predicates.cpp", "compareExact(p, w, 0) <= 0", "compareExact(p, w, 0) < 0", "between: ends excluded"),
    ("src/predicates.cpp", "if (dot(from_v, u).sign() <= 0)", "if (dot(from_v, u).sign() > 0)", "within: wrong end"),
    ("src/predicates.cpp", "if (dot(from_w, u).sign() >= 0)", "if (false)", "within: far end forgotten"),
    ("src/predicates.cpp", "return (area * area - square * dot(u, u)).sign() <= 0;", "return (area * area - square * dot(u, u)).sign() < 0;", "within: equality"),
    ("src/predicates.cpp", "if (dot(from_v, u).sign() <= 0) return (dot(from_v, from_v) - square).sign() <= 0;", "if (dot(from_v, u).sign() <= 0) return (dot(from_v, from_v) - square).sign() < 0;", "within: equality at an end"),
    ("src/dyadic.h", "return a.at(i) > b.at(i) ? 1 : -1;", "return a.at(i) > b.at(i) ? -1 : 1;", "dyadic: comparison"),
    ("src/dyadic.h", "if (!Subtract && carry)", "if (false)", "dyadic: lost carry"),
    ("src/dyadic.h", "result.sign_ = a.sign_ * b.sign_;", "result.sign_ = a.sign_;", "dyadic: sign of a product"),
    ("src/dyadic.h", "(field != 0 ? field : 1)", "field", "dyadic: denormals"),
    # Relative pose.
    ("src/posed_pair.cpp", "error = 16 * kUlp *", "error = 0 *", "relative pose: no error"),
    ("src/posed_pair.cpp", "handed = det < 0 ? -1 : 1;", "handed = 1;", "mirrored poses: exact signs"),
    ("src/posed_pair.cpp", "m01 = (ra(1, 1) * rb(0, 1) - ra(0, 1) * rb(1, 1)) / det;", "m01 = (ra(1, 1) * rb(0, 1) + ra(0, 1) * rb(1, 1)) / det;", "relative pose: entry"),
    ("src/posed_pair.cpp", "ty = (ra(0, 0) * dy - ra(1, 0) * dx) / det;", "ty = (ra(0, 0) * dy - ra(1, 0) * dx);", "relative pose: determinant forgotten"),
    ("src/posed_pair.cpp", "slack = 4 * error", "slack = -1e-3 * a.radius + 4 * error", "slack: negative"),
    ("src/posed_pair.cpp", "scale_defect = rigidDefect(ra(0, 0), ra(1, 0), ra(0, 1), ra(1, 1));", "scale_defect = 0;", "scale defect"),
    # The edge test.
    ("src/posed_pair.cpp", "bool sameSide(int s, int t) { return s == t && (s == 1 || s == -1); }", "bool sameSide(int s, int t) { return s == t; }", "edge test: zero or uncertain taken as a side"),
    ("src/posed_pair.cpp", "if (p != 0 || q != 0 || v != 0 || w != 0) return true;", "return true;", "repair 6: collinear edges always meet"),
    ("src/posed_pair.cpp", "return ends.between(0, 2, 3) || ends.between(1, 2, 3) || ends.between(2, 0, 1) || ends.between(3, 0, 1);", "return false;", "repair 6: collinear edges never meet"),
    ("src/posed_pair.cpp", "|| ends.between(2, 0, 1) || ends.between(3, 0, 1);", ";", "repair 6: one edge within the other"),
    ("src/posed_pair.cpp", "w = ends.resolve(w, 2, 3, 1);", "w = ends.resolve(w, 2, 3, 0);", "edge test: wrong end"),
    ("src/posed_pair.cpp", "if (meet(ends)) return true;", "", "margin: crossing edges"),
    ("src/posed_pair.cpp", "if ((d - err) * (1 - pair.scale_defect) > reach) return false;", "if (d > reach) return false;", "margin: no error at the lower bound"),
    ("src/posed_pair.cpp", "if ((d + err) * (1 + pair.scale_defect) <= reach + tolerance) return true;", "if (d <= reach + tolerance) return true;", "margin: no error at the upper bound"),
    ("src/posed_pair.cpp", "withinExact(x[3], x[0], x[1], reach)", "false", "margin: one end forgotten"),
    # Algorithm 1.
    ("src/locate.cpp", "sum += d_v != 0 && d_w != 0 ? 2 * g : g;", "sum += 2 * g;", "Algorithm 1: rays count twice"),
    ("src/locate.cpp", "const int side = g * signs(v, w);", "const int side = signs(v, w);", "Algorithm 1: sign of the triangle"),
    ("src/locate.cpp", "if (side == 0) return false;", "", "Algorithm 1: boundary"),
    ("src/locate.cpp", "if (signs(v, w) == 0 && signs.between(v, w)) return false;", "", "repair 5: edges collinear with S"),
    ("src/locate.cpp", "sum / 2 % 2 != 0 : sum != 0", "sum == 2 : sum == 2", "repair 4: winding +1 only"),
    ("src/locate.cpp", "sum / 2 % 2 != 0 : sum != 0", "sum / 2 % 2 != 0 : sum / 2 % 2 != 0", "fill rule ignored"),
    ("src/locate.cpp", "if (!off_origin && signs.isPoint(*s)) s = &polygon.path.front();", "", "the point at S"),
    ("src/locate.cpp", "same_zone = same_zone && bits == cache.signs[word];", "", "Algorithm 2: mask not compared"),
    ("src/locate.cpp", "same_zone = same_zone && sign != 0;", "", "Algorithm 2: zones on a line trusted"),
    ("src/locate.cpp", "bool same_zone = cache.polygon_id == data.id && cache", "bool same_zone = cache", "Algorithm 2: another polygon's mask"),
    # Influence areas.
    ("src/influence.cpp", "length * std::sqrt(ux * ux + uy * uy) * (1 + 8 * kUlp)", "0.999 * length * std::sqrt(ux * ux + uy * uy)", "influence area: too narrow"),
    ("src/influence.cpp", "const double beyond = std::max(at - std::max(from, to), std::min(from, to) - at);", "const double beyond = std::max(at - std::max(from, to), std::min(from, to) - at) + 0.01 * length;", "influence area: cut too near"),
    ("src/influence.cpp", "<= 0 && detail::inExtendedArea", ">= 0 && detail::inExtendedArea", "repair 3: one-sided area on the wrong side"),
    # Strategies.
    ("src/paper.cpp", "if (known && mask == cache->mask) return false;", "if (known && !cache->mask.empty()) return false;", "repair 7: mask not compared"),
    ("src/paper.cpp", "if (cache != nullptr) cache->mask.clear();", "if (known && mask == cache->mask) return false;\n  if (cache != nullptr) cache->mask = mask;", "repair 1: unchanged mask inside an influence area"),
    ("src/paper.cpp", "if (collides) mask.clear();", "", "mask of a containment kept as free"),
    ("src/paper.cpp", "return detailedTest(pair, held, options) || findContainment(pair).collides;", "return detailedTest(pair, held, options);", "repair 2: paper"),
    ("src/paper.cpp", "const bool collides = locate(pair, pair.b.origin) != Location::Outside;", "const bool collides = false;", "repair 2: paper, outside all areas"),
    ("src/paper.cpp", "|| sign != next || sign == kUncertain", "|| sign != next", "sign-change filter: uncertain signs"),
    ("src/paper.cpp", "const bool any_edge = options.margin > 0 || options.tolerance > 0;", "const bool any_edge = false;", "sign-change filter under a margin"),
    ("src/descend.cpp", "outcome = findContainment(pair);", "", "repair 2: hierarchy"),
    ("src/descend.cpp", "for (std::size_t r = 0; r < pair.b.ringCount(); ++r) {", "for (std::size_t r = 0; r < 1; ++r) {", "repair 2: first ring only"),
    ("src/descend.cpp", "if (outcome.edge_b < 0) outcome.edge_a = ringInside(PosedPair(pair.b, pair.pose_b, pair.a, pair.pose_a));", "", "repair 2: a in b forgotten"),
    ("src/descend.cpp", "b.along * c + b.across * s);\n", "b.along * c);\n", "boxes: extent across forgotten"),
    ("src/descend.cpp", "- pair.slack;\n}", ";\n}", "boxes: no slack"),
    ("src/descend.cpp", "stack[top++] = {visit.a, b.right};", "", "descent: a child forgotten"),
    ("src/descend.cpp", "if (gap > reach || !edgesWithin", "if (!edgesWithin", "leaves: no box test (equivalent: speed only)"),
    ("src/descend.cpp", "(2 * (a.across + b.across) + 4 * pair.slack) * (1 + 2 * pair.scale_defect) <= options.tolerance", "options.tolerance > 0", "tolerance: boxes of any thickness"),
    ("src/descend.cpp", "a.spanned && b.spanned && gap <= 0 &&", "gap <= 0 &&", "tolerance: boxes over several rings"),
    ("src/hierarchy.cpp", "32 * kUlp * polygon.extent + kTiny", "-32 * kUlp * polygon.extent", "boxes rounded inwards"),
    ("src/collide.cpp", "turn * pair.b.radius + ", "", "facts: rotation ignored"),
    ("src/collide.cpp", " + std::sqrt(cx * cx + cy * cy)", "", "facts: translation ignored"),
    ("src/collide.cpp", "if (left > 0 && (cache->overlapping || left > options.margin)) {", "if (left > 0) {", "facts: margin ignored"),
    ("src/collide.cpp", "return cache->overlapping;", "return false;", "facts: overlap answered as free"),
    ("src/collide.cpp", "cache.first_id == pair.a.id && cache.second_id == pair.b.id", "cache.first_id != 0", "facts: another pair's"),
    ("src/collide.cpp", "if (pair.discGap() * (1 - pair.scale_defect) > options.margin) return false;", "if (pair.discGap() > 0) return false;", "discs: margin ignored"),
    ("src/polygon.cpp", "square = std::max(square,", "square = std::min(square + 1e-3,", "bounding radius too small"),
]


def run(command, **kwargs):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **kwargs)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="run mutations whose description or file holds this text")
    parser.add_argument("--scale", default="0.1", help="TRICOVER_TEST_SCALE for the tests")
    parser.add_argument("--work", help="where to copy and build; kept afterwards")
    arguments = parser.parse_args()

    work = pathlib.Path(arguments.work or tempfile.mkdtemp(prefix="tricover-mutation-"))
    source, build = work / "source", work / "build"
    shutil.copytree(ROOT, source, dirs_exist_ok=True, copy_function=shutil.copy, ignore=shutil.ignore_patterns("build*", ".git"))
    configure = ["cmake", "-S", source, "-B", build, "-DTRICOVER_BUILD_FCL=OFF", "-DTRICOVER_BUILD_BENCH=OFF",
                 "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -w"]  # -w: a mutation may leave a variable unused
    compile_all = ["cmake", "--build", build, "-j", str(os.cpu_count())]
    environment = dict(os.environ, TRICOVER_TEST_SCALE=arguments.scale)
    tests = ["ctest", "--test-dir", build, "--stop-on-failure", "--timeout", "300"]
    for step in (configure, compile_all):
        result = run(step)
        if result.returncode != 0:
            sys.exit(result.stdout)
    result = run(tests, env=environment)
    if result.returncode != 0:
        sys.exit("the unmutated tests fail:\n" + result.stdout)

    tried = survived = equivalent = 0
    for file, old, new, what in MUTATIONS:
        if arguments.only not in what and arguments.only not in file:
            continue
        path = source / file
        original = path.read_text()
        if original.count(old) != 1:
            sys.exit(f"{file}: {original.count(old)} times in the file: {old}")
        path.write_text(original.replace(old, new))
        built = run(compile_all + ["--", "-k"])
        path_error = next((line for line in built.stdout.splitlines() if "error:" in line), None)
        if built.returncode != 0 and path_error:
            sys.exit(f"{what}: does not compile: {path_error}")
        tested = run(tests, env=environment)
        path.write_text(original)
        tried += 1
        failed = re.search(r"\d+ - (\S+) \((Failed|Timeout|SEGFAULT|Subprocess aborted|Bus error|SIG\w+)\)", tested.stdout)
        verdict = f"killed by {failed.group(1)}" if failed else "SURVIVED"
        if not failed:
            equivalent += "(equivalent" in what
            survived += "(equivalent" not in what
        print(f"{verdict:40} {file}: {what}", flush=True)
    print(f"{tried} mutations, {survived} survived, {equivalent} equivalent")
    return 1 if survived else 0


if __name__ == "__main__":
    sys.exit(main())
