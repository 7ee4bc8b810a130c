// SPDX-License-Identifier: BSD-3-Clause
// depth(), excess(), hausdorffDistance() and negative margins by what they promise, small pairs against exact borders.
#include "tricover/depth.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "depth_laws.h"
#include "exact_covers.h"
#include "exact_depth.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/covers.h"
#include "tricover/polygon.h"
#include "tricover/scene.h"

namespace tricover::laws {
namespace {

using namespace support;

constexpr EdgeIndex kMostEdges = 60;  // for the oracle

const Pose kHere = Pose::Identity();

Ring gridRing(Random& random, int n) {
  Ring ring;
  for (; n > 0; --n) ring.emplace_back(random.integer(-2, 2), random.integer(-2, 2));
  return ring;
}

/// Not convex, with holes, slits, crossings, edges used twice, or without an area.
Polygon smallPolygon(Random& random) {
  const FillRule fill = random.coin() ? FillRule::EvenOdd : FillRule::NonZero;
  switch (random.integer(0, 8)) {
    case 0:
      return Polygon({star(random, random.integer(3, 6), 0.3, 2)}, fill);
    case 1:
      return Polygon({comb(2, 0.5, 0.25, 1)}, fill);
    case 2:
      return Polygon({star(random, 4, 1.2, 2), eitherWay(random, star(random, 3, 0.3, 0.9))}, fill);
    case 3: {
      Ring ring;
      for (int i = random.integer(4, 5); i > 0; --i) ring.emplace_back(random.real(-1, 1), random.real(-1, 1));
      return Polygon({ring}, fill);
    }
    case 4:
      return Polygon({gridRing(random, random.integer(4, 7))}, fill);
    case 5:
      return Polygon({rectangle(-2, -1, 1, 1), gridRing(random, 3)}, fill);
    case 6:
      return random.oneIn(4) ? Polygon::point({random.real(-1, 1), 0})
                             : Polygon::segment({random.real(-2, 0), 0}, {1, random.real(-1, 1)});
    case 7: {
      // A square with a slit into it and a spike out of it.
      const double x = random.real(-1, 1);
      return Polygon({{{-1, -1}, {1, -1}, {1, 1}, {x, 1}, {x, 2}, {x, random.real(-1, 1)}, {x, 1}, {-1, 1}}}, fill);
    }
    default:
      return Polygon({anyConvex(random, random.real(0.3, 2), 6)}, fill);
  }
}

Polygon maybeOutside(Random& random, const Polygon& polygon) {
  if (!random.oneIn(6)) return polygon;
  try {
    return polygon.complement();
  } catch (const std::invalid_argument&) {
    return polygon;
  }
}

Case smallCase(Random& random) {
  const bool is_turned = random.coin();
  const double far = random.oneIn(8) ? 1e3 : 0;
  const auto near = [&] {
    const double x = random.integer(-6, 6) / 4.0, y = random.integer(-6, 6) / 4.0;
    Pose at = is_turned ? turnedAndMoved(random.real(0, 6.3), random.real(-1.5, 1.5), random.real(-1.5, 1.5))
                        : turnedAndMoved(0, x, y);
    at.translation() += Vec2(far, -far);
    return random.oneIn(4) ? mirrored(at) : random.oneIn(8) ? distorted(random, at) : at;
  };
  const Pose pose_a = near(), pose_b = near();
  const Polygon a = maybeOutside(random, smallPolygon(random)), b = maybeOutside(random, smallPolygon(random));
  return {a, pose_a, b, pose_b};
}

/// The reference in two ways, and beside others.
std::string wrongReference(const Case& c, const exact::Bracket& deep, const exact::Bracket& out) {
  if ((out.low == 0) != exact::covers({{c.b, c.pose_b, {}}}, c.a, c.pose_a, 0)) return "the reference covers";
  if (deep.low == 0 && exact::interiorsMeet(c.a, c.pose_a, c.b, c.pose_b)) return "the reference's interiors";
  if (deep.low > 0 && !exact::collide(c.a, c.pose_a, c.b, c.pose_b)) return "the reference collides";
  const auto areAlike = [](const exact::Bracket& found, long double by_candidates) {
    return std::isinf(found.low) || (found.high - found.low <= 1e-14L && std::abs(by_candidates - found.low) <= 1e-13L);
  };
  if (!areAlike(deep, exact::depthByCandidates(c.a, c.pose_a, c.b, c.pose_b))) return "the reference by candidates";
  return areAlike(out, exact::excessByCandidates(c.a, c.pose_a, c.b, c.pose_b)) ? "" : "the reference's excess";
}

std::string wrongWith(Random& random, Tally& tally, const Case& c) {
  const Depth deep = depth(c.a, c.pose_a, c.b, c.pose_b);
  const Excess out = excess(c.a, c.pose_a, c.b, c.pose_b);
  tally.count("hits", deep.depth > 0);
  tally.count("covered", out.distance == 0);
  tally.count("infinite", std::isinf(deep.depth));
  if (deep.depth > 0) tally.count("of a", deep.is_point_of_a);
  if (deep.depth > 0) tally.count("inside", (deep.is_point_of_a ? deep.edge_a : deep.edge_b) == -1);
  if (out.distance > 0) tally.count("farthest inside", out.edge == -1);
  std::string problem = wrongDepth(c, deep);
  if (problem.empty()) problem = wrongBesideOthers(random, c, deep);
  if (problem.empty()) problem = wrongMargins(random, c);
  if (problem.empty()) problem = wrongExcess(c, out);
  if (problem.empty()) problem = wrongBesideOthers(random, c, out);
  if (problem.empty()) problem = wrongCoversButFor(c, out);
  if (!problem.empty() || c.a.edgeCount() + c.b.edgeCount() > kMostEdges) return problem;
  problem = wrongLargest(c, deep.depth, exact::depth(c.a, c.pose_a, c.b, c.pose_b));
  return problem.empty() ? wrongLargest(c, out.distance, exact::excess(c.a, c.pose_a, c.b, c.pose_b)) : problem;
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  c = pushed(random, c);
  return depthPrecision(c) < 1e292 ? wrongWith(random, tally, c) : "";  // where no sums of coordinates overflow
}

std::string wrongSmall(Random& random, Tally& tally, Case& c) {
  if (random.oneIn(3)) c.a = Polygon({anyConvex(random, 0.3, 6)});
  const exact::Bracket deep = exact::depth(c.a, c.pose_a, c.b, c.pose_b),
                       out = exact::excess(c.a, c.pose_a, c.b, c.pose_b);
  const std::string problem = wrongReference(c, deep, out);
  return problem.empty() ? wrongWith(random, tally, c) : problem;
}

Case largeOutlines(Random& random) {
  const auto outline = [&] {
    const int n = random.integer(20, 60);
    return random.coin() ? Polygon({star(random, n, 1.7, 2)})
                         : Polygon({star(random, n, 1.7, 2), star(random, 10, 0.5, 1)});
  };
  const Polygon a = outline(), b = outline();
  return {a, kHere, b, turnedAndMoved(random.real(0, 6.3), random.real(-4, 4), random.real(-4, 4))};
}

std::string wrongLarge(Random&, Tally& tally, Case& c) {
  const Depth found = depth(c.a, c.pose_a, c.b, c.pose_b);
  tally.count("hits", found.depth > 0);
  std::string problem = wrongDepth(c, found);
  if (problem.empty()) problem = wrongLargest(c, found.depth, exact::depth(c.a, c.pose_a, c.b, c.pose_b));
  if (!problem.empty()) return problem;
  return wrongLargest(c, excess(c.a, c.pose_a, c.b, c.pose_b).distance, exact::excess(c.a, c.pose_a, c.b, c.pose_b));
}

/// The distance from a union is the least of the distances, and that from rings of the non-zero rule.
std::string wrongUnion(Random& random, Tally& tally) {
  std::vector<Ring> rings;
  Scene scene;
  for (int n = random.integer(1, 4); n > 0; --n) {
    const Vec2 center(random.real(-1, 1), random.real(-1, 1));
    rings.push_back(random.coin() ? star(random, 6, 0.5, 1.5, center) : shifted(rectangle(-1, -0.5, 1, 0.5), center));
    scene.add(Polygon({rings.back()}), kHere);
  }
  const Polygon area(rings, FillRule::NonZero), part({star(random, 5, 0.3, 1.2)});
  const Pose at = turnedAndMoved(random.real(0, 6.3), random.real(-1, 1), random.real(-1, 1));
  const auto truth = static_cast<double>(exact::excess(part, at, area, kHere).low);

  const std::string text = "\n" + reproduction({area, kHere, part, at});
  if (!(std::abs(excess(part, at, area, kHere).distance - truth) <= 1e-14)) return "excess" + text;
  tally.count("gaps", truth > 0);
  if (scene.covers(part, at) != (truth == 0)) return "Scene::covers" + text;
  if (truth == 0) return {};
  for (const double factor : {0.5, 1 - 1e-9, 1 + 1e-9, 2.0})
    if (scene.covers(part, at, {-factor * truth}) != (factor > 1) ||
        covers(area, kHere, part, at, {-factor * truth}) != (factor > 1))
      return "covers but for the excess times " + hex(factor) + text;
  return {};
}

double little(Random& random) { return random.oneIn(4) ? 0 : std::pow(10, random.real(-13, -0.5)); }

/// Both seen in a frame of some kind, exact or not.
Case framed(Random& random, const Polygon& a, const Polygon& b, const Pose& pose_b) {
  Pose frame = Pose::Identity();
  if (random.coin()) frame = turnedAndMoved(random.real(0, 6.3), random.real(-9, 9), random.real(-9, 9));
  if (random.oneIn(4)) frame = mirrored(frame);
  const Pose there = frame * pose_b;
  return random.coin() ? Case{a, frame, b, there} : Case{b, there, a, frame};
}

/// Into one wall of an L, U or comb or of what is outside of a room, or into both.
Case crateInCorner(Random& random) {
  const Polygon shapes[] = {Polygon(Ring{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}),
                            Polygon(Ring{{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}),
                            Polygon(comb(3, 4, 1, 3)), Polygon::box(10, 10).complement()};
  const Vec2 corners[] = {{1, 1}, {1, 1}, {1, 0}, {-5, -5}};
  const int kind = random.integer(0, 3);
  const Vec2 at = corners[kind] + Vec2(0.75 - (random.coin() ? little(random) : -random.unit()), 0.5 - little(random));
  return framed(random, shapes[kind], random.coin() ? Polygon::box(1.5, 1) : Polygon({regular(6, 0.75)}),
                turnedAndMoved(random.oneIn(3) ? random.real(-0.001, 0.001) : 0, at.x(), at.y()));
}

Case dockedExactly(Random& random) {
  const double width = random.coin() ? 0.5 : random.real(0.1, 2), depth = random.coin() ? 0.625 : random.real(0.1, 2);
  const double half = width / 2;
  const Polygon dock(Ring{{0, -half - 1},
                          {depth + 1, -half - 1},
                          {depth + 1, half + 1},
                          {0, half + 1},
                          {0, half},
                          {depth, half},
                          {depth, -half},
                          {0, -half}});
  return framed(
      random, dock, Polygon({rectangle(0, -half, depth, half)}),
      turnedAndMoved(0, random.coin() ? little(random) : -little(random), random.coin() ? 0 : little(random)));
}

Case thinThroughThick(Random& random) {
  const auto end = [&] { return Vec2(random.real(-2, 2), random.real(-2, 2)); };
  const Polygon thick({random.coin() ? star(random, random.integer(4, 9), 0.5, 1.5) : rectangle(-2, -1, 2, 1)});
  switch (random.integer(0, 3)) {
    case 0:
      return framed(random, thick, Polygon::point(end()), turnedAndMoved(0, 0, 0));
    case 1:
      return framed(random, thick, Polygon({rectangle(-4, -little(random), 4, 0.001)}), randomPose(random, 1));
    case 2: {
      const Vec2 p = end();
      return framed(random, thick, Polygon({{p, end(), end(), p, end(), p}}), turnedAndMoved(0, 0, 0));
    }
    default:
      return framed(random, thick, Polygon::segment(end(), end()), turnedAndMoved(0, 0, 0));
  }
}

/// Rings that share edges, slits, spikes, and edges that are all of these in pieces.
Case edgesUsedTwice(Random& random) {
  const auto any = [&] {
    const FillRule fill = random.coin() ? FillRule::EvenOdd : FillRule::NonZero;
    const double x = random.integer(-3, 3) / 4.0, y = random.integer(-3, 3) / 4.0;
    switch (random.integer(0, 3)) {
      case 0:
        return Polygon({rectangle(-1, -1, x, 1), rectangle(x, -1, 1, 1)}, fill);
      case 1:
        return Polygon({{{-1, -1}, {1, -1}, {1, 1}, {x, 1}, {x, 2}, {x, y}, {x, 1}, {-1, 1}}}, fill);
      case 2:
        return Polygon(
            {rectangle(-1, -1, 1, 1), eitherWay(random, rectangle(x, -1, 1, y + 1)), {{-1, 0}, {1, 0}, {x, 1.5}}},
            fill);
      default: {
        Ring ring;
        for (int i = random.integer(5, 8); i > 0; --i) ring.emplace_back(random.integer(-2, 2), random.integer(-2, 2));
        return Polygon({ring}, fill);
      }
    }
  };
  const Polygon a = any(), b = any();
  const double x = random.integer(-9, 9) / 4.0, y = random.integer(-9, 9) / 4.0;
  return framed(random, a, b, random.coin() ? turnedAndMoved(0, x, y) : turnedAndMoved(random.real(0, 6.3), x, y));
}

/// Along an edge of many collinear pieces, all of whose points are as deep but for rounding.
Case flatContacts(Random& random) {
  Ring floor{{-6, -2}, {6, -2}};
  for (int i = random.integer(1, 12), n = i; i >= 0; --i) floor.emplace_back(-6 + 12.0 * i / n, 0);
  const Polygon crate = random.coin() ? Polygon::box(2, 1) : Polygon(comb(3, 1, 0.25, 0.5));
  const double bottom = crate.bounds().min().y();
  return framed(
      random, Polygon(floor), crate,
      turnedAndMoved(random.oneIn(3) ? random.real(-1, 1) * 1e-12 : 0, random.real(-6, 4), -bottom - little(random)));
}

Case regularHoles(Random& random) {
  const int n = random.integer(3, 24), m = random.coin() ? n : random.integer(3, 24);
  const Polygon hole({regular(n, 4), regular(n, 3)});
  const double radius = random.coin() ? 3 : random.real(0.5, 5), turn = random.coin() ? 0 : random.real(0, 6.3);
  return framed(random, random.coin() ? hole : Polygon({regular(n, 3)}), Polygon({regular(m, radius)}),
                turnedAndMoved(turn, random.coin() ? 0 : little(random), little(random)));
}

Case besideComplements(Random& random) {
  const Case c = random.coin() ? thinThroughThick(random) : edgesUsedTwice(random);
  const auto outside = [](const Polygon& polygon) {
    try {
      return polygon.complement();
    } catch (const std::invalid_argument&) {
      return Polygon::box(3, 2).complement();
    }
  };
  if (random.oneIn(3)) return {random.coin() ? c.a : c.b, c.pose_a, Polygon::box(9, 4).complement(), c.pose_b};
  return random.coin() ? Case{outside(c.a), c.pose_a, c.b, c.pose_b} : Case{c.a, c.pose_a, outside(c.b), c.pose_b};
}

/// Where a translation leads out of the mouth, or many features tie: corners, docks that fit exactly, thin bodies
/// through thick ones, edges used twice, flat contacts, regular holes, complements. In most cases bodies overlap a
/// little.
std::vector<Family> depthFamilies() {
  return {family("crate_in_corner", crateInCorner),       family("docked_exactly", dockedExactly),
          family("thin_through_thick", thinThroughThick), family("edges_used_twice", edgesUsedTwice),
          family("flat_contacts", flatContacts),          family("regular_holes", regularHoles),
          family("beside_complements", besideComplements)};
}

Laws depthLaws() {
  Limits limits;
  limits.most_exponent = 280;
  limits.most_vertices = 16;
  Laws laws = {{"unions", 250, wrongUnion, {{"gaps", 0.05, 0.98}}}};
  add(laws, {family("small", smallCase)}, 500, wrongSmall,
      {{"hits", 0.3, 0.7},
       {"covered", 0.08, 0.9},
       {"of a", 0.2, 0.8},
       {"inside", 0.001, 1},
       {"farthest inside", 0.001, 1}});
  add(laws, {family("large", largeOutlines)}, 50, wrongLarge);
  for (const Family& made : joined(families(), depthFamilies())) {
    const bool mostly_overflows = made.name == std::string("near_overflow");  // too few are left to count
    add(laws, {made}, 90, wrong, mostly_overflows ? Shares{} : Shares{{"hits", 0.2, 0.98}});
  }
  add(laws, anyPairs(limits), 60, wrong);
  return laws;
}

const Register registered("depth", depthLaws);

}  // namespace
}  // namespace tricover::laws
