#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Breaks the kernel in one place at a time and asks the test suite to notice.

usage: tests/mutation/run.py [--only TEXT] [--scale 0.1] [--work DIR]

Copies the project to DIR (default: a temporary one), builds the core's tests there and, for every mutation below, applies it, rebuilds and
runs them. Prints a line a mutation (killed by which test, or SURVIVED) and the totals; exits 1 if one survived that isn't marked
as equivalent. Not part of ctest: it takes up to a minute a mutation.
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
    ("src/numbers/predicates.h", "if (det > bound) return 1;", "if (det > bound) return -1;", "filter: sign of a left turn"),
    ("src/numbers/predicates.h", "if (-det > bound) return -1;", "if (-det > bound) return 1;", "filter: sign of a right turn"),
    ("src/numbers/predicates.h", "if (det > bound) return 1;", "if (det >= 0) return 1;", "filter: no bound"),
    ("src/numbers/predicates.h", "const double det = left - right;", "const double det = left + right;", "filter: determinant"),
    ("src/numbers/predicates.h", "5 * kUnitRoundoff * (std::abs(left)", "0.5 * kUnitRoundoff * (std::abs(left)", "filter: rounding term too small"),
    ("src/numbers/predicates.h", "(ew * (std::abs(ux) + std::abs(uy))", "(0 * (std::abs(ux) + std::abs(uy))", "filter: error of r"),
    ("src/numbers/predicates.h", "eu * (std::abs(wx) + std::abs(wy) + 2 * ew)", "0 * (std::abs(wx) + std::abs(wy) + 2 * ew)", "filter: error of q"),
    ("src/numbers/predicates.h", "eu = p.error + q.error", "eu = p.error", "filter: q's error dropped"),
    ("src/numbers/predicates.h", "ew = p.error + r.error", "ew = r.error", "filter: p's error dropped"),
    ("src/numbers/predicates.h", "constexpr double kTiny = 0x1p-1010;", "constexpr double kTiny = 0;", "filter: underflow term"),
    ("src/numbers/predicates.h", "return square > 0x1p-960 &&", "return square > 0 &&", "discs: squares of denormals trusted"),
    ("src/numbers/predicates.h", "&& square <= std::numeric_limits<double>::max() ?", "?", "discs: overflowed squares trusted"),
    ("src/numbers/predicates.h", "return sign != kUncertain ? sign : orientExact({nullptr, p}, {nullptr, q}, {nullptr, r});", "return sign != kUncertain ? sign : 0;", "orientation: no exact stage"),
    # Exact stage.
    ("src/numbers/predicates.cpp", "return u.x * w.y - u.y * w.x;", "return u.x * w.y + u.y * w.x;", "exact: cross product"),
    ("src/numbers/predicates.cpp", "return u.x * w.x + u.y * w.y;", "return u.x * w.x - u.y * w.y;", "exact: dot product"),
    ("src/numbers/predicates.cpp", " + Number(m(axis, 2));", ";", "exact: translation dropped"),
    ("src/numbers/predicates.cpp", "Number(m(axis, 1))", "Number(m(1, axis))", "exact: rotation transposed"),
    ("src/numbers/predicates.cpp", "compareExact(p, v, 0) * compareExact(p, w, 0) <= 0 &&", "", "between: x ignored"),
    ("src/numbers/predicates.cpp", "&& compareExact(p, v, 1) * compareExact(p, w, 1) <= 0", "", "between: y ignored"),
    ("src/numbers/predicates.cpp", "compareExact(p, w, 0) <= 0", "compareExact(p, w, 0) < 0", "between: ends excluded"),
    ("src/numbers/predicates.cpp", "if (dot(from_v, u).sign() <= 0)", "if (dot(from_v, u).sign() > 0)", "within: wrong end"),
    ("src/numbers/predicates.cpp", "if (dot(from_w, u).sign() >= 0) return (dot", "if (false) return (dot", "within: far end forgotten"),
    ("src/numbers/predicates.cpp", "return (area * area - square * dot(u, u)).sign() <= 0;", "return (area * area - square * dot(u, u)).sign() < 0;", "within: equality"),
    ("src/numbers/predicates.cpp", "if (dot(from_v, u).sign() <= 0) return (dot(from_v, from_v) - square).sign() <= 0;", "if (dot(from_v, u).sign() <= 0) return (dot(from_v, from_v) - square).sign() < 0;", "within: equality at an end"),
    ("src/numbers/dyadic.h", "return a.at(i) > b.at(i) ? 1 : -1;", "return a.at(i) > b.at(i) ? -1 : 1;", "dyadic: comparison"),
    ("src/numbers/dyadic.h", "if (!Subtract && carry)", "if (false)", "dyadic: lost carry"),
    ("src/numbers/dyadic.h", "result.sign_ = a.sign_ * b.sign_;", "result.sign_ = a.sign_;", "dyadic: sign of a product"),
    ("src/numbers/dyadic.h", "(field != 0 ? field : 1)", "field", "dyadic: denormals"),
    # Relative pose.
    ("src/pair/posed_pair.h", "error = 16 * kUnitRoundoff *", "error = 0 *", "relative pose: no error"),
    ("src/pair/posed_pair.h", "handed = det < 0 ? -1 : 1;", "handed = 1;", "mirrored poses: exact signs"),
    ("src/pair/posed_pair.h", "m1 = (diagonal * b1 - off * swapped(b1)) * d;", "m1 = (diagonal * b1 + off * swapped(b1)) * d;", "relative pose: entry"),
    ("src/pair/posed_pair.h", "t = (diagonal * shift - off * swapped(shift)) * d;", "t = (diagonal * shift - off * swapped(shift));", "relative pose: determinant forgotten"),
    ("src/pair/posed_pair.h", "scale_defect = Gram(a0, a1).defect();", "scale_defect = 0;", "scale defect"),
    ("src/pair/posed_pair.h", "defect = Gram(m0, m1).defect();", "defect = 0;", "defect of the relative pose"),
    ("src/pair/posed_pair.h", "length * (1 + 2 * scale_defect)", "length", "margin in a's frame: scale forgotten"),
    ("src/pair/posed_pair.cpp", "return 4 * error", "return -1e-3 * a.radius + 4 * error", "slack: negative"),
    # What is rigid.
    ("src/numbers/rigidity.h", " + (finite[0] + finite[1]) <= kRigidTolerance", " <= kRigidTolerance", "hot path: infinite translations"),
    ("src/numbers/rigidity.h", "gram.norms[0] + gram.norms[1] + gram.dot", "gram.norms[0] + gram.norms[1]", "hot path: shear"),
    ("src/numbers/rigidity.h", "std::max(norms[0], norms[1]) + dot + 16 * kUnitRoundoff", "std::max(norms[0], norms[1])", "defect: shear"),
    ("src/numbers/rigidity.h", "kLargestDefect = 2.1 * kRigidTolerance", "kLargestDefect = 0", "largest defect"),
    ("src/numbers/pose.cpp", " && gram.dot <= kRigidTolerance", "", "checkPose: shear"),
    ("src/numbers/pose.cpp", "gram.norms[1] <= kRigidTolerance", "true", "checkPose: a column's length"),
    # The edge test.
    ("src/pair/posed_pair.cpp", "bool sameSide(int s, int t) { return s == t && (s == 1 || s == -1); }", "bool sameSide(int s, int t) { return s == t; }", "edge test: zero or uncertain taken as a side"),
    ("src/pair/posed_pair.cpp", "if (p != 0 || q != 0 || v != 0 || w != 0) return true;", "return true;", "repair 6: collinear edges always meet"),
    ("src/pair/posed_pair.cpp", "return ends.between(0, 2, 3) || ends.between(1, 2, 3) || ends.between(2, 0, 1) || ends.between(3, 0, 1);", "return false;", "repair 6: collinear edges never meet"),
    ("src/pair/posed_pair.cpp", "|| ends.between(2, 0, 1) || ends.between(3, 0, 1);", ";", "repair 6: one edge within the other"),
    ("src/pair/posed_pair.cpp", "w = ends.resolve(w, 2, 3, 1);", "w = ends.resolve(w, 2, 3, 0);", "edge test: wrong end"),
    ("src/pair/posed_pair.cpp", "if (meet(ends)) return true;", "", "margin: crossing edges"),
    ("src/pair/posed_pair.cpp", "if ((d - err) * (1 - pair.scale_defect) > reach) return false;", "if (d > reach) return false;", "margin: no error at the lower bound"),
    ("src/pair/posed_pair.cpp", "if ((d + err) * (1 + pair.scale_defect) <= reach + tolerance) return true;", "if (d <= reach + tolerance) return true;", "margin: no error at the upper bound"),
    ("src/pair/posed_pair.cpp", "||\n         ends.within(3, 0, 1, reach);", ";", "margin: one end forgotten"),
    ("src/pair/posed_pair.cpp", "if (p * q != -1 || v * w != -1) return 0;", "", "crossing depth: of edges that don't cross"),
    ("src/pair/posed_pair.cpp", "const double below = d - 8 * pair.error - 64 * kUnitRoundoff * length;", "const double below = 2 * d;", "crossing depth: too large"),
    ("src/pair/posed_pair.cpp", "const double below = d - 8 * pair.error - 64 * kUnitRoundoff * length;", "const double below = d;", "crossing depth: no error"),
    # Algorithm 1.
    ("src/hierarchy/locate.cpp", "sum += d_v != 0 && d_w != 0 ? 2 * g : g;", "sum += 2 * g;", "Algorithm 1: rays count twice"),
    ("src/hierarchy/locate.cpp", "const int side = g * signs(v, w);", "const int side = signs(v, w);", "Algorithm 1: sign of the triangle"),
    ("src/hierarchy/locate.cpp", "on_boundary = side == 0;", "", "Algorithm 1: boundary"),
    ("src/hierarchy/locate.cpp", "return on_boundary = signs(v, w) == 0 && signs.between(v, w), !on_boundary;", "return true;", "repair 5: edges collinear with S"),
    ("src/polygon/covering.h", "winding % 2 != 0 : winding != 0", "winding == 1 : winding == 1", "repair 4: winding +1 only"),
    ("src/polygon/covering.h", "winding % 2 != 0 : winding != 0", "winding % 2 != 0 : winding % 2 != 0", "fill rule ignored"),
    ("src/hierarchy/locate.cpp", "winding.s = polygon.path.front();", ";", "the point at S"),
    ("src/hierarchy/locate.cpp", "polygon.radius + 2 * approx.error", "polygon.radius", "disc: error of the point"),
    ("src/hierarchy/locate.cpp", "same_zone = same_zone && bits == cache.signs[word];", "", "Algorithm 2: mask not compared"),
    ("src/hierarchy/locate.cpp", "same_zone = same_zone && sign != 0;", "", "Algorithm 2: zones on a line trusted"),
    ("src/hierarchy/locate.cpp", "bool same_zone = cache.polygon_id == data.id && cache", "bool same_zone = cache", "Algorithm 2: another polygon's mask"),
    ("src/hierarchy/locate.cpp", "distance > 0x1p-10 && error < 0x1p-20", "true", "ray: asked for where it is vague (equivalent: its room grows with error / distance, beyond everything in the end)"),
    ("src/hierarchy/locate.cpp", "error * (2 + 16 / distance)}", "0}", "ray: known exactly"),
    ("src/hierarchy/locate.cpp", "error < 0x1p-20 && polygon.radius <= polygon.unit)", "error < 0x1p-20)", "ray: polygons larger than their unit"),
    ("src/hierarchy/locate.cpp", "    data.hierarchy();\n", "    ;\n", "locate: never builds a hierarchy (equivalent: speed only)"),
    # Influence areas.
    ("src/polygon/influence.cpp", "length * std::sqrt(ux * ux + uy * uy) * (1 + 8 * kUnitRoundoff)", "0.999 * length * std::sqrt(ux * ux + uy * uy)", "influence area: too narrow"),
    ("src/polygon/influence.cpp", "const double beyond = std::max(at - std::max(from, to), std::min(from, to) - at);", "const double beyond = std::max(at - std::max(from, to), std::min(from, to) - at) + 0.01 * length;", "influence area: cut too near"),
    ("src/polygon/influence.cpp", "<= 0 && detail::inExtendedArea", ">= 0 && detail::inExtendedArea", "repair 3: one-sided area on the wrong side"),
    # The paper's strategy.
    ("src/pair/collide_by_paper.cpp", "if (known && mask == cache->mask) return false;", "if (known && !cache->mask.empty()) return false;", "repair 7: mask not compared"),
    ("src/pair/collide_by_paper.cpp", "if (cache != nullptr) cache->mask.clear();", "if (known && mask == cache->mask) return false;\n  if (cache != nullptr) cache->mask = mask;", "repair 1: unchanged mask inside an influence area"),
    ("src/pair/collide_by_paper.cpp", "if (collides) mask.clear();", "", "mask of a containment kept as free"),
    ("src/pair/collide_by_paper.cpp", "return detailedTest(pair, held, options) || findContainment(pair).collides;", "return detailedTest(pair, held, options);", "repair 2: paper"),
    ("src/pair/collide_by_paper.cpp", "const bool collides = locate(pair, pair.b.origin) != Location::Outside;", "const bool collides = false;", "repair 2: paper, outside all areas"),
    ("src/pair/collide_by_paper.cpp", "|| sign != next || sign == kUncertain", "|| sign != next", "sign-change filter: uncertain signs"),
    ("src/pair/collide_by_paper.cpp", "const bool any_edge = options.margin > 0 || options.tolerance > 0;", "const bool any_edge = false;", "sign-change filter under a margin"),
    # The hierarchy: what its boxes, discs and half planes say.
    ("src/hierarchy/hierarchy.cpp", "constexpr double kOutwards = 0x1p-21;", "constexpr double kOutwards = 0;", "boxes: not rounded outwards"),
    ("src/hierarchy/hierarchy.cpp", "constexpr double kOutwards = 0x1p-21;", "constexpr double kOutwards = -0x1p-12;", "boxes: rounded inwards"),
    ("src/hierarchy/hierarchy.cpp", "Box{0, 0, 1, 0, -1e30f, -1e30f}", "Box{0, 0, 1, 0, 0, 0}", "boxes: unused lanes near"),
    ("src/hierarchy/hierarchy.cpp", "if (!parts[i].rings) block.spanned", "block.spanned", "tolerance: boxes over several rings"),
    ("src/hierarchy/hierarchy.cpp", "hierarchy.root_spanned = !all.rings;", "hierarchy.root_spanned = true;", "tolerance: root over several rings"),
    ("src/hierarchy/hierarchy.cpp", "for (std::size_t i = begin; i <= end; ++i) {\n        const double u", "for (std::size_t i = begin; i < end; ++i) {\n        const double u", "boxes: a chain's last vertex"),
    ("src/hierarchy/inner_discs.cpp", "std::sqrt(square) - 0x1p-22 - 4 * kUnitRoundoff * (polygon.extent / polygon.unit)", "std::sqrt(square) - 4 * kUnitRoundoff * (polygon.extent / polygon.unit)", "inner discs: rounding in units (equivalent as far as tests see: an ulp of S is more)"),
    ("src/hierarchy/inner_discs.cpp", "std::sqrt(square) - 0x1p-22 - 4 * kUnitRoundoff * (polygon.extent / polygon.unit)", "std::sqrt(square) - 0x1p-22", "inner discs: an ulp of S"),
    ("src/hierarchy/inner_discs.cpp", "== Location::Inside ? radius : 0", "== Location::Inside ? radius : radius", "inner discs: the place of the centre"),
    ("src/hierarchy/inner_discs.cpp", "static_cast<float>(radius * (1 - 0x1p-22))", "static_cast<float>(radius * (1 + 0x1p-22))", "inner discs: radius rounded upwards"),
    ("src/hierarchy/inner_discs.cpp", "std::hypot(discs.x[k], discs.y[k]) + discs.radius[k])", "0.5f * std::hypot(discs.x[k], discs.y[k]) + discs.radius[k])", "inner discs: reach (equivalent: a reach too short only hides discs)"),
    ("src/hierarchy/small_convex.cpp", "return changes == 2 ? direction : 0;", "return direction;", "small convex: twice around"),
    ("src/hierarchy/small_convex.cpp", "if (orientation(p, q, r) != direction) return 0;", "if (orientation(p, q, r) == -direction) return 0;", "small convex: straight vertices"),
    ("src/hierarchy/small_convex.cpp", "(direction / length)", "(1 / length)", "small convex: direction"),
    ("src/hierarchy/small_convex.cpp", "if (!(length > 0x1p-30)) return nullptr;", "", "small convex: an edge too short to have a direction"),
    ("src/hierarchy/small_convex.cpp", "polygon.ringCount() != 1 || ", "", "small convex: several rings (equivalent: the vertex that closes the first is a straight one)"),
    # Descents, eight boxes at a time.
    ("src/hierarchy/wide_body.h", "absolute(dx * q.ux + dy * q.uy) - (along * c + across * s + q.along)", "absolute(dx * q.ux + dy * q.uy) - (along * c + q.along)", "gaps: extent across forgotten"),
    ("src/hierarchy/wide_body.h", "(along * s + across * c + q.across)", "(across * c + q.across)", "gaps: extent along forgotten"),
    ("src/hierarchy/wide_body.h", "(across + s * q.along + c * q.across)", "(across + c * q.across)", "gaps: extent of the query forgotten"),
    ("src/hierarchy/wide_body.h", "const double slack = rounding * (magnitude(x) + magnitude(y) + along + across + 4) + map.error * block.inverse;", "const double slack = map.error * block.inverse;", "one box: no rounding"),
    ("src/hierarchy/wide_body.h", "const double slack = rounding * (magnitude(x) + magnitude(y) + along + across + 4) + map.error * block.inverse;", "const double slack = rounding * (magnitude(x) + magnitude(y) + along + across + 4);", "one box: the map's error"),
    ("src/hierarchy/wide_body.h", "const double slack = d.rounding * (magnitude(x) + magnitude(y) + 4 * size + 4) + map.error * a.inverse;", "const double slack = map.error * a.inverse;", "two blocks: no rounding (equivalent as far as tests see: what pads the boxes hides what two blocks of like sizes round)"),
    ("src/hierarchy/wide_body.h", "const double slack = d.rounding * (magnitude(x) + magnitude(y) + 4 * size + 4) + map.error * a.inverse;", "const double slack = d.rounding * (magnitude(x) + magnitude(y) + 4 * size + 4);", "two blocks: the map's error"),
    ("src/hierarchy/wide_body.h", "static_cast<float>(limit + slack) * (1 + 0x1p-20f)", "static_cast<float>(limit)", "threshold without slack"),
    ("src/hierarchy/wide_body.h", "slack < 1e30f && threshold < cap}", "true}", "overflow taken as known"),
    ("src/hierarchy/wide_body.h", "slack < 1e30f && threshold < cap}", "threshold < cap}", "overflow: slack not asked (equivalent: the threshold is more, and the cap 1e30 at most)"),
    ("src/hierarchy/wide_body.h", "slack < 1e30f && threshold < cap}", "slack < 1e30f}", "cap: boxes beyond it left out (equivalent: the window holds the nearest point at any distance)"),
    ("src/hierarchy/wide_body.h", "if (!step.known) return used;", "if (!step.known) return 0;", "overflow taken as apart"),
    ("src/hierarchy/wide_body.h", "const unsigned used = (1u << block.count) - 1;", "const unsigned used = (1u << (block.count - 1)) - 1;", "entered: a lane dropped"),
    ("src/hierarchy/wide_body.h", "if (d.wants_clearance) least = smaller(least, whereAbove(found, threshold));", "", "clearance: boxes that aren't entered"),
    ("src/hierarchy/wide_body.h", "double low = at - kKept, high = at + kKept;", "double low = at - 0.5, high = at + 0.5;", "clip: window too small"),
    ("src/hierarchy/wide_body.h", "const double at = -(x * ux + y * uy)", "const double at = (x * ux + y * uy)", "clip: window elsewhere"),
    ("src/hierarchy/wide_body.h", "return kKept - 4;", "return 1e30;", "clip: cap ignored (equivalent: the window holds the nearest point at any distance)"),
    ("src/hierarchy/wide_body.h", "along = 0.5 * (high - low);", "along = 0.25 * (high - low);", "clip: too short"),
    ("src/hierarchy/wide_body.h", "(gap > 0 ? gap : 0) + 2.0 * step.slack", "2.0 * step.slack", "tolerance: the boxes' gap"),
    ("src/hierarchy/wide_body.h", "1.4143 * between", "1.0 * between", "tolerance: boxes apart diagonally"),
    ("src/hierarchy/wide_body.h", "2.0 * (across + other_across)", "1.0 * (across + other_across)", "tolerance: half the boxes' thickness"),
    ("src/hierarchy/wide_body.h", "if (d.accept >= 0 && other.spanned)", "if (d.accept >= 0)", "tolerance: one box over several rings"),
    ("src/hierarchy/wide_body.h", "if (d.accept >= 0 && (b.spanned >> j & 1) != 0)", "if (d.accept >= 0)", "tolerance: b's box over several rings"),
    ("src/hierarchy/wide_body.h", "if (proven > d.reach || !edgesWithin", "if (proven < d.reach || !edgesWithin", "leaves: those near skipped"),
    ("src/hierarchy/wide_body.h", "if (proven > d.reach || !edgesWithin", "if (!edgesWithin", "leaves: no box test (equivalent: speed only)"),
    ("src/hierarchy/wide_body.h", "step.known ? (gap - step.slack) * step.in_a : 0", "(gap - step.slack) * step.in_a", "leaves: overflow taken as a gap (equivalent: NaN proves nothing, and keepLeast() has forgotten the clearance)"),
    ("src/hierarchy/wide_body.h", "step.known ? (gap - step.slack) * step.in_a : 0", "step.known ? gap * step.in_a : 0", "leaves: clearance without slack"),
    ("src/hierarchy/wide_body.h", "visits.gap[i] < visits.gap[deepest]", "visits.gap[i] > visits.gap[deepest]", "deepest first (equivalent: order only)"),
    ("src/hierarchy/wide_body.h", "for (int i = 0; i < kLanes; ++i) lowest", "for (int i = 1; i < kLanes; ++i) lowest", "clearance: a lane ignored"),
    ("src/hierarchy/wide_body.h", "const double proven = (lowest - step.slack) * step.in_a;", "const double proven = lowest * step.in_a;", "clearance: without slack"),
    ("src/hierarchy/wide_body.h", "in_a = into_a ? block.scale : block.scale * d.to_a.scale", "in_a = block.scale", "one box: b's units taken for a's"),
    ("src/hierarchy/wide_body.h", "into_a ? d.to_a : inverse(d.to_a)", "d.to_a", "one box: map into b"),
    ("src/hierarchy/wide_shapes.h", "larger(beside, behind), all(room)", "larger(beside, behind), all(0)", "ray: boxes known exactly"),
    ("src/hierarchy/wide_shapes.h", "larger(beside, behind), all(room)", "beside, all(room)", "ray: taken for a line (equivalent: speed only)"),
    ("src/hierarchy/wide_shapes.h", "(magnitude(px) + magnitude(py) + 4) + ray.error * block.inverse", "(magnitude(px) + magnitude(py) + 4)", "ray: its error"),
    ("src/hierarchy/wide_shapes.h", "if (room < 1e30f) {", "{", "ray: overflow taken as known (equivalent: points beyond the bounding disc aren't asked, so nothing overflows)"),
    ("src/hierarchy/wide_shapes.h", "stack[top++] = block.child[i];", "top += i == 7 ? 0 : (stack[top] = block.child[i], 1);", "ray: a child forgotten"),
    ("src/hierarchy/wide_shapes.h", "const float slack = static_cast<float>(8 * rounding + map.error);\n  float x", "const float slack = 0;\n  float x", "convex: no slack"),
    ("src/hierarchy/wide_shapes.h", "const float slack = static_cast<float>(8 * rounding + map.error);\n  float x", "const float slack = static_cast<float>(8 * rounding);\n  float x", "convex: the map's error"),
    ("src/hierarchy/wide_shapes.h", "for (int i = 0; i < b.lanes; i += kLanes) {\n    const Lanes bnx", "for (int i = 0; i < 0; i += kLanes) {\n    const Lanes bnx", "convex: b's edges forgotten"),
    ("src/hierarchy/wide_shapes.h", "inside &= above(all(-slack), out);\n  }\n  for", "inside = above(all(-slack), out);\n  }\n  for", "convex: half of a's edges"),
    ("src/hierarchy/wide_shapes.h", "inside &= above(all(-slack), out);\n  }\n  return", "inside = above(all(-slack), out);\n  }\n  return", "convex: only b's last edges"),
    ("src/hierarchy/wide_shapes.h", "above(all(-slack), out);\n  }\n  return", "above(all(0), out);\n  }\n  return", "convex: meeting without slack"),
    ("src/hierarchy/wide_shapes.h", "const float slack = static_cast<float>(8 * rounding + map.error);\n  const float reach", "const float slack = 0;\n  const float reach", "inner discs: no slack"),
    ("src/hierarchy/wide_shapes.h", "const float slack = static_cast<float>(8 * rounding + map.error);\n  const float reach", "const float slack = static_cast<float>(8 * rounding);\n  const float reach", "inner discs: the map's error"),
    ("src/hierarchy/wide_shapes.h", "store(radius, load(b.radius) * scale - slack);", "store(radius, load(b.radius) * scale * 1.001f);", "inner discs: b's too large"),
    ("src/hierarchy/wide_shapes.h", "(deepest - slack) / (2.0 * ", "(deepest - slack) / (1.0 * ", "inner discs: depth too large"),
    # Both hierarchies descended together.
    ("src/pair/collide_by_hierarchy.cpp", "outcome = findContainment(pair);", "", "repair 2: hierarchy"),
    ("src/pair/collide_by_hierarchy.cpp", "for (std::size_t r = 0; r < pair.b.ringCount(); ++r) {", "for (std::size_t r = 0; r < 1; ++r) {", "repair 2: first ring only"),
    ("src/pair/collide_by_hierarchy.cpp", "if (outcome.edge_b < 0) outcome.edge_a = ringOfAInside(pair);", "", "repair 2: a in b forgotten"),
    ("src/pair/collide_by_hierarchy.cpp", "const double error = 2 * p.error * polygon.inverse_unit + 0x1p-40;", "const double error = 0;", "containment: error outside of the box"),
    ("src/pair/collide_by_hierarchy.cpp", "(pair.radiusB() + 4 * pair.error) * (1 + 16 * kUnitRoundoff)", "pair.radiusB()", "containment: error outside of the disc"),
    ("src/pair/collide_by_hierarchy.cpp", "0x1p-19 + 8 * pair.defect", "0x1p-19", "boxes: taken for rigid (equivalent as far as tests see: the rounding allowed for is as large as the largest defect)"),
    ("src/pair/collide_by_hierarchy.cpp", "return gap - rounding * (std::abs(dx) + std::abs(dy) + 4) - map.error;", "return gap;", "root boxes: no error"),
    ("src/pair/collide_by_hierarchy.cpp", "(a.along + along * c + across * s)", "(a.along + along * c)", "root boxes: extent across forgotten"),
    ("src/pair/collide_by_hierarchy.cpp", "pair.a.radius <= pair.a.unit && pair.b.radius <= pair.b.unit", "true", "units: polygons larger than theirs (equivalent as far as tests see: they are a few units at most)"),
    ("src/pair/collide_by_hierarchy.cpp", "-(r00 * map.tx + r01 * map.ty) * scale", "-(r00 * map.tx + r10 * map.ty) * scale", "the way back"),
    ("src/pair/collide_by_hierarchy.cpp", "gap * pair.a.unit > pair.reach(options.margin) + lookahead", "gap * pair.a.unit > lookahead", "root boxes: margin ignored"),
    ("src/pair/collide_by_hierarchy.cpp", "&& wanted == Wanted::Answer && options.margin == 0", "&& wanted == Wanted::Answer", "convex: under a margin"),
    ("src/pair/collide_by_hierarchy.cpp", "&& wanted == Wanted::Answer && options.margin == 0", "&& options.margin == 0", "convex: asked for edges"),
    ("src/pair/collide_by_hierarchy.cpp", "gap < -deep && wanted != Wanted::Edges", "gap < -deep", "inner discs: asked for edges"),
    ("src/pair/collide_by_hierarchy.cpp", "outcome.clearance = depth * pair.a.unit;", "outcome.clearance = 2 * depth * pair.a.unit;", "inner discs: clearance too large"),
    ("src/pair/collide_by_hierarchy.cpp", "limit = reach + lookahead * unit", "limit = lookahead * unit", "descent: margin not entered"),
    # Facts.
    ("src/pair/facts.h", "std::max(norms[0], norms[1]) + std::abs(product[0] + product[1]) + 0x1p-1000", "0x1p-1000", "facts: rotation ignored"),
    ("src/pair/facts.h", "std::max(norms[0], norms[1]) + std::abs(product[0] + product[1])", "std::max(norms[0], norms[1])", "facts: shear ignored"),
    ("src/pair/facts.h", "square_of_way = squares[0] + squares[1] + 0x1p-1000;", "square_of_way = 0x1p-1000;", "facts: translation ignored"),
    ("src/pair/facts.h", "2 * (square_of_turn * (radius * radius) + square_of_way)", "(square_of_turn * (radius * radius) + square_of_way)", "facts: (x + y)^2 taken for x^2 + y^2"),
    ("src/pair/facts.h", "first_moved ? !second_moved && Change", "first_moved ? Change", "facts: both moved taken for one"),
    ("src/pair/facts.h", "first_moved = !sameAs(cache.first_pose, first_pose)", "first_moved = false", "facts: first polygon's motion"),
    ("src/pair/facts.h", "(cache.clearance - (cache.overlapping ? 0 : margin))", "cache.clearance", "facts: margin ignored at a glance"),
    ("src/pair/facts.h", "if (!direct && !(cache.first_id == b.id && cache.second_id == a.id)) return {};", "", "facts: another pair's"),
    ("src/pair/facts.h", "first_pose = direct ? pose_a : pose_b, &second_pose = direct ? pose_b : pose_a;", "first_pose = pose_a, &second_pose = pose_b;", "facts: poses in another order"),
    ("src/pair/facts.h", "return {true, cache.overlapping, true, 0};", "return {true, false, true, 0};", "facts: overlap answered as free"),
    ("src/pair/facts.cpp", "const double needed = cache.overlapping ? 0 : margin,", "const double needed = 0,", "facts: margin ignored"),
    ("src/pair/facts.cpp", " + (second_change.any() ? second_change.displacement() : 0)", "", "facts: second polygon's motion"),
    ("src/pair/facts.cpp", "change.displacement() + 3 * (now.error + then.error)", "change.displacement()", "facts: relative motion known exactly (equivalent as far as tests see: a fact has left out more when it was found)"),
    ("src/pair/facts.cpp", "(1 - then.scale_defect) * (1 - now.scale_defect) * (1 - 8 * kUnitRoundoff)", "1", "facts: relative motion's scale (equivalent as far as tests see: a fact has left out more when it was found)"),
    ("src/pair/facts.cpp", "  cache = PairCache();\n", "", "facts: another pair's edges kept"),
    # What decides before and after that.
    ("src/pair/discs.h", "(a_.radius + b_.radius) * (1 + kLargestDefect) + error_, apart = sum + margin", "(a_.radius + b_.radius) * (1 + kLargestDefect) + error_, apart = sum", "discs: margin ignored"),
    ("src/pair/discs.h", "(a_.radius + b_.radius) * (1 + kLargestDefect) + error_", "(a_.radius + b_.radius) + error_", "discs: defect of their radii"),
    ("src/pair/discs.h", "(a_.radius + b_.radius) * (1 + kLargestDefect) + error_", "(a_.radius + b_.radius) * (1 + kLargestDefect)", "discs: error of their centres"),
    ("src/pair/discs.h", "- sum * (1 + 8 * kUnitRoundoff)", "- 0.9 * sum", "discs: gap too large"),
    ("src/pair/discs.h", "(tree_a.inner_radius + tree_b.inner_radius) * (1 - kLargestDefect) - error_", "(tree_a.inner_radius + tree_b.inner_radius) - error_", "largest inner discs: defect of their radii (equivalent as far as tests see: the search stops short of the largest disc)"),
    ("src/pair/discs.h", "(tree_a.inner_radius + tree_b.inner_radius) * (1 - kLargestDefect) - error_", "(tree_a.inner_radius + tree_b.inner_radius) * (1 - kLargestDefect)", "largest inner discs: error of their centres (equivalent as far as tests see: the search stops short of the largest disc)"),
    ("src/pair/discs.h", "return reach * (1 - 8 * kUnitRoundoff) - std::sqrt(square) * (1 + 8 * kUnitRoundoff);", "return reach;", "largest inner discs: depth too large"),
    ("src/pair/collide.cpp", "if (cache != nullptr && !by_paper) remember", "if (cache != nullptr) remember", "paper: remembers facts (equivalent: they are true)"),
    ("src/pair/collide.cpp", "clearance * (1 - pair.scale_defect) * (1 - 8 * kUnitRoundoff)", "clearance", "facts: a's frame taken for the world (equivalent as far as tests see: the slack of the boxes is more)"),
    ("src/pair/collide.cpp", "if (edgesWithin(pair, i, j, options.margin, options.tolerance)) return fact", "return fact", "last edges: not asked"),
    ("src/polygon/polygon.cpp", "square = std::max(square,", "square = std::min(square + 1e-3,", "bounding radius too small"),
    # Distance.
    ("src/apart/edge_distance.cpp", "error_ = 66 * kUnitRoundoff * size_;", "error_ = 0;", "distance: no error of rounded distances"),
    ("src/apart/edge_distance.cpp", "unsure_ = 512 * kUnitRoundoff * size_ * size_;", "unsure_ = 0;", "distance: places beside an edge trusted"),
    ("src/apart/edge_distance.cpp", "if (!(d >= 0x1p-44 * size_)) return exactCombination(k, i, j);", "", "distance: no exact stage"),
    ("src/apart/edge_distance.cpp", "std::max(distance, 0x1p-1074)", "distance", "distance: rounds to 0"),
    ("src/apart/edge_distance.cpp", "shift_rest_ = shift.low;", "shift_rest_ = Double2{};", "distance: what the shift rounds off"),
    ("src/numbers/predicates.cpp", "if (dot(from_w, u).sign() >= 0) return {rootOf", "if (false) return {rootOf", "distance: far end forgotten"),
    ("src/apart/distance.cpp", "if (!bounds.clear && edges_.meet(i, j)) {", "if (false) {", "distance: crossings unseen"),
    ("src/apart/distance.cpp", "unlisted_ = std::min(unlisted_, pair.low);", "", "distance: pairs beyond the list forgotten (equivalent as far as tests see: they are within rounding of the reach)"),
    ("src/apart/distance.cpp", "const bool apart = remainder.of(cache.apart[0]) > 0;", "const bool apart = true;", "distance: a jump through an edge"),
    ("src/apart/distance.cpp", "return {1 - 8 * kUnitRoundoff, motion};", "return {1, 0 * motion};", "distance: facts that forget motion"),
    ("src/apart/distance.cpp", "if (upper_ < best_.distance) evaluate(upper_pair_);", "", "distance: the pair of the bound forgotten"),
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
                 "-DBUILD_SHARED_LIBS=ON",  # a mutation then links one library, not every test
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
