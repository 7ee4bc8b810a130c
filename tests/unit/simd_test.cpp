// SPDX-License-Identifier: BSD-3-Clause
// Eight boxes, or all edges of small polygons, at once: alike bit by bit for every instruction set, and the truth.
#include "hierarchy/simd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact_reference.h"
#include "families.h"
#include "hierarchy/axis_boxes.h"
#include "hierarchy/unit_map.h"
#include "pair/collide_by_hierarchy.h"
#include "portable_lanes.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

using detail::Outcome;
using detail::PosedPair;
using detail::Wanted;

PosedPair largerFirst(const Case& c) {
  if (c.a.radius() >= c.b.radius()) return {detail::dataOf(c.a), c.pose_a, detail::dataOf(c.b), c.pose_b};
  return {detail::dataOf(c.b), c.pose_b, detail::dataOf(c.a), c.pose_a};
}

/// What floats can't tell the check does, about the right edges.
struct Check {
  const PosedPair& pair;
  int asked = 0;
  static bool meet(const void* context, detail::EdgePosition edge_a, detail::EdgePosition edge_b) {
    Check& check = *static_cast<Check*>(const_cast<void*>(context));
    ++check.asked;
    EXPECT_LT(edge_a, check.pair.a.path.size() - 1);
    EXPECT_LT(edge_b, check.pair.b.path.size() - 1);
    return edgesMeet(check.pair, edge_a, edge_b);
  }
};

/// What answers are like; by edges that cross, or else by what is inside.
struct Answers {
  int apart = 0, meet = 0, crossing = 0, unknown = 0, doubted = 0;

  /// The same on all lanes, and the truth unless it is Unknown.
  void ask(const Case& c, bool has_check) {
    const PosedPair pair = largerFirst(c);
    const auto &of_a = hierarchyOf(pair.a).small, &of_b = hierarchyOf(pair.b).small;
    ASSERT_TRUE(of_a && of_b);
    const detail::UnitMap units = pair.inUnits();
    Check check{pair};
    const auto answer = [&] {
      return has_check ? detail::fewEdgesMeet(*of_a, *of_b, units, {&check, &Check::meet})
                       : detail::fewEdgesMeet(*of_a, *of_b, units, {});
    };
    const detail::Meeting meeting = answer();
    ASSERT_EQ(onPortableLanes(answer), meeting);
    doubted += check.asked > 0;
    unknown += meeting == detail::Meeting::Unknown;
    if (meeting == detail::Meeting::Unknown) return;
    const bool truth = meeting == detail::Meeting::Meet;
    ASSERT_EQ(truth, exact::collide(c.a, c.pose_a, c.b, c.pose_b)) << reproduction(c);
    ++(truth ? meet : apart);
    const Outcome outcome = collideByHierarchy(pair, {}, 0, Wanted::Edges);
    crossing += truth && outcome.edge_a != detail::kNoEdge && outcome.edge_b != detail::kNoEdge;
  }
};

/// Sixteen edges or fewer, as rings.
std::vector<int> fewEdges(Random& random) {
  std::vector<int> rings(1, random.integer(3, 16));
  for (int left = 16 - rings[0]; left >= 3 && random.coin(); left -= rings.back())
    rings.push_back(random.integer(3, left));
  return rings;
}

/// Two polygons of few edges are asked by all of them: never wrong, and seldom at a loss.
TEST(FewEdgesMeet, IsRightWhereItAnswersAndSeldomDoesNot) {
  Random random(14);
  Answers found;
  int several = 0;
  const int cases = scaledCount(3000, 300);
  for (int i = 0; i < cases; ++i) {
    const auto polygon = [&](double size) {
      std::vector<Ring> rings;
      for (const int n : fewEdges(random)) {
        const double shrunk = rings.empty() ? size : size * random.real(0.2, 1);
        Ring vertices = star(random, n, 0.3 * shrunk, shrunk);
        if (i % 4 == 0)  // crosses itself, winds around some places more than once
          for (Vec2& p : vertices) p = shrunk * Vec2(random.real(-1, 1), random.real(-1, 1));
        if (random.oneIn(3)) vertices = shifted(vertices, Vec2(shrunk, 0));  // holes, parts
        rings.push_back(eitherWay(random, vertices));
      }
      several += rings.size() > 1;
      return Polygon(rings, random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
    };
    const double size = i % 3 == 0 ? 0.1 : 1, angle = random.real(0, 6.28), away = random.real(0, 1 + size);
    const Pose pose_a = turnedAndMoved(random.real(0, 6.28), 1, 2);
    const Vec2 at = Vec2(1, 2) + away * direction(angle);
    found.ask({polygon(1), random.coin() ? pose_a : mirrored(pose_a), polygon(size),
               turnedAndMoved(random.real(0, 6.28), at.x(), at.y())},
              false);
    if (HasFailure()) return;
  }
  EXPECT_GT(found.apart, cases / 10);
  EXPECT_GT(found.crossing, cases / 10);
  EXPECT_GT(found.meet - found.crossing, cases / 50);
  EXPECT_LT(found.unknown, cases / 100);
  EXPECT_GT(several, cases / 3);
}

/// On a small grid much touches: few pairs need the check.
TEST(FewEdgesMeet, AsksTheCheckWhereFloatsDoubt) {
  Random random(16);
  Answers found;
  const int cases = scaledCount(3000, 300);
  for (int i = 0; i < cases; ++i) {
    const auto ring = [&](int n) {
      Ring vertices;
      while (static_cast<int>(vertices.size()) < n) {
        const Vec2 v(random.integer(0, 5), random.integer(0, 5));
        if (vertices.empty() || (v != vertices.back() && v != vertices.front())) vertices.push_back(v);
      }
      return vertices;
    };
    const auto polygon = [&] {
      std::vector<Ring> rings{ring(random.integer(3, i % 2 == 0 ? 8 : 12))};
      if (random.oneIn(3)) rings.push_back(ring(random.integer(3, 4)));
      return Polygon(rings, random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
    };
    const Pose at = turnedAndMoved(0.3, 1, 2), by = turnedAndMoved(0, random.integer(2, 6), random.integer(-4, 4));
    found.ask({polygon(), random.coin() ? at : mirrored(at), polygon(), at * by}, true);
    if (HasFailure()) return;
  }
  EXPECT_GT(found.apart, cases / 10);
  EXPECT_GT(found.meet, cases / 10);
  EXPECT_GT(found.doubted, cases / 20);
  EXPECT_LT(found.unknown, cases / 10);  // more than eight doubtful pairs
}

/// By the definition, also of boxes without ends and of those that are nothing.
TEST(EightBoxes, MeetABoxAndARay) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr unsigned kLanes = detail::kLanes;
  Random random(15);
  const auto box = [&] {
    const double x = random.integer(-4, 4), y = random.integer(-4, 4);
    detail::Bounds bounds{x, y, x + random.integer(0, 3), y + random.integer(0, 3)};
    if (random.integer(0, 9) == 0) bounds.min_x = -kInfinity, bounds.max_x = kInfinity;
    if (random.integer(0, 9) == 0) bounds = {kNaN, kNaN, kNaN, kNaN};
    return bounds;
  };
  int met = 0, entered = 0, asked = 0;
  for (int i = 0; i < scaledCount(500, 50); ++i) {
    detail::EightBoxes boxes;
    for (unsigned k = 0; k < kLanes; ++k) boxes.set(k, box());
    const detail::Bounds bounds = box();
    const unsigned bits = detail::boxesMeeting(boxes, bounds);
    ASSERT_EQ(onPortableLanes([&] { return detail::boxesMeeting(boxes, bounds); }), bits);
    const Vec2 from(random.integer(-5, 5), random.integer(-5, 5)), to(random.real(-5, 5), random.real(-5, 5));
    const detail::BoxRay ray(from, to);
    const double most = random.real(0, 1);
    double least[kLanes], portable[kLanes];
    const unsigned on_ray = detail::boxesOnRay(boxes, ray, most, least);
    ASSERT_EQ(onPortableLanes([&] { return detail::boxesOnRay(boxes, ray, most, portable); }), on_ray);
    const double reach = random.real(0, 3);
    double squares[kLanes], portable_squares[kLanes];
    const double most_square = detail::gapSquareAbove(reach);
    const unsigned near = detail::boxesNear(boxes, bounds, most_square, squares);
    ASSERT_EQ(onPortableLanes([&] { return detail::boxesNear(boxes, bounds, most_square, portable_squares); }), near);
    for (unsigned k = 0; k < kLanes; ++k) {
      const detail::Bounds other = boxes.at(k);
      ASSERT_EQ(bits >> k & 1, other.meets(bounds) ? 1u : 0u);
      const double x = std::max({0.0, other.min_x - bounds.max_x, bounds.min_x - other.max_x});
      const double y = std::max({0.0, other.min_y - bounds.max_y, bounds.min_y - other.max_y});
      const bool is_near = !std::isnan(other.min_x) && !std::isnan(bounds.min_x) && std::hypot(x, y) <= reach;
      ASSERT_EQ(near >> k & 1, is_near ? 1u : 0u);
      if (is_near) {
        ASSERT_EQ(squares[k], portable_squares[k]);
        ASSERT_LE(squares[k], detail::gapSquareAbove(std::hypot(x, y)));
      }
      met += other.meets(bounds);
      ++asked;
      if ((on_ray >> k & 1) != 0) {
        ASSERT_EQ(least[k], portable[k]);
      }
      if (std::isnan(other.min_x)) {
        ASSERT_EQ(on_ray >> k & 1, 0u);
        continue;
      }
      // Points of the ray in the box, by samples; what is hardly entered isn't asked about.
      for (double s = 0; s < most; s += 0x1p-6) {
        const Vec2 at = from + s * (to - from);
        if (!(at.x() > other.min_x && at.x() < other.max_x && at.y() > other.min_y && at.y() < other.max_y)) continue;
        ASSERT_EQ(on_ray >> k & 1, 1u);
        ASSERT_LE(least[k], s);
        ++entered;
        break;
      }
    }
  }
  EXPECT_GT(met, asked / 20);
  EXPECT_LT(met, asked / 2);
  EXPECT_GT(entered, asked / 20);
}

TEST(ConvexMeet, IsForConvexPolygonsOnly) {
  const auto isSmallConvex = [](const Ring& ring) {
    return hierarchyOf(detail::dataOf(Polygon({ring}))).small_convex != nullptr;
  };
  const auto isSmall = [](const Polygon& polygon) { return hierarchyOf(detail::dataOf(polygon)).small != nullptr; };
  EXPECT_TRUE(isSmallConvex(regular(3, 1)));
  EXPECT_TRUE(isSmallConvex(regular(16, 1e200)));
  EXPECT_TRUE(isSmallConvex(reversed(regular(8, 1e-200))));
  EXPECT_TRUE(isSmallConvex(rectangle(0, 0, 1, 2)));
  EXPECT_FALSE(isSmallConvex(regular(17, 1)));
  Ring pentagram;
  for (int i = 0; i < 5; ++i) pentagram.push_back(direction(0.8 * M_PI * i));
  EXPECT_FALSE(isSmallConvex(pentagram)) << "turns one way, but twice around";
  EXPECT_FALSE(isSmallConvex({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}}));
  EXPECT_TRUE(isSmallConvex({{0, 0}, {1, 0}, {2, 0}, {2, 2}})) << "a straight vertex: the corners are asked";
  EXPECT_TRUE(isSmallConvex({{2, 2}, {0, 0}, {1, 0}, {2, 0}}));
  EXPECT_FALSE(isSmallConvex({{0, 0}, {1, 0}, {1, 1e-12}, {0.5, 1}})) << "an edge too short to have a direction";
  EXPECT_FALSE(isSmall(Polygon({{{0, 0}, {1, 0}, {1, 1e-12}, {0.5, 1}}})));
  EXPECT_TRUE(isSmall(Polygon({pentagram})));
  EXPECT_TRUE(isSmall(Polygon({{{0, 0}, {1, 0}, {2, 0}, {2, 2}}})));
  EXPECT_FALSE(isSmall(Polygon({regular(17, 1)})));
  EXPECT_TRUE(isSmall(Polygon({regular(4, 1), regular(4, 0.5)})));
  EXPECT_FALSE(isSmall(Polygon({regular(9, 1), regular(8, 0.5)})));
  EXPECT_FALSE(isSmallConvex({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}})) << "twice around";
}

}  // namespace
}  // namespace tricover::support
