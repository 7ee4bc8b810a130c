// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "tricover/paper.h"

namespace tricover::support {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The text of the std::invalid_argument that these rings cause; empty if they are taken.
std::string refusal(const std::vector<Ring>& rings) {
  return support::refusal([&] { const Polygon polygon(rings); });
}

bool names(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(PolygonValidation, NamesWhatIsWrongAndWhere) {
  const Ring good = rectangle(0, 0, 1, 1);
  EXPECT_EQ(refusal({}), "tricover: rings: a polygon needs at least one ring");
  EXPECT_TRUE(names(refusal({good, {}}), "tricover: rings: ring 1: it has 0 vertices; "));
  EXPECT_TRUE(names(refusal({good, good, {{0, 0}, {1, 1}}}), "tricover: rings: ring 2: it has 2 vertices; "));
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    Ring ring = good;
    ring[3].y() = bad;
    const std::string text = refusal({good, good, ring});
    EXPECT_EQ(text, "tricover: rings: ring 2, vertex 3: a coordinate is not finite");
    ring = good;
    ring[0].x() = bad;
    EXPECT_TRUE(names(refusal({ring}), "ring 0") && names(refusal({ring}), "vertex 0"));
  }
}

TEST(PolygonValidation, OfRawVerticesIsThatOfTheirRingAlone) {
  const auto refusalOfRaw = [](const Vec2* vertices, std::size_t count, FillRule fill = FillRule::EvenOdd) {
    return support::refusal([&] { const Polygon polygon(vertices, count, fill); });
  };
  Ring ring = rectangle(0, 0, 1, 1);
  EXPECT_EQ(refusalOfRaw(nullptr, 4), "tricover: rings: ring 0: its vertices are at no address");
  for (std::size_t count = 0; count < 3; ++count) {
    const std::string text = refusal({Ring(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(count))});
    EXPECT_NE(text, "");
    EXPECT_EQ(refusalOfRaw(ring.data(), count), text);
    EXPECT_EQ(refusalOfRaw(nullptr, count), text);
  }
  for (const std::size_t count : {std::size_t{1} << 29, std::numeric_limits<std::size_t>::max()})
    EXPECT_TRUE(names(support::refusal<std::length_error>([&] { const Polygon polygon(ring.data(), count); }),
                      "tricover: rings: more than 2^29 vertices"));
  EXPECT_EQ(refusalOfRaw(ring.data(), 4, static_cast<FillRule>(7)), "tricover: fill: not a FillRule");
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    ring = rectangle(0, 0, 1, 1);
    ring[2].y() = bad;
    EXPECT_EQ(refusalOfRaw(ring.data(), 4), "tricover: rings: ring 0, vertex 2: a coordinate is not finite");
  }
}

TEST(PolygonValidation, FillRuleIsOne) {
  EXPECT_EQ(support::refusal([] { Polygon({rectangle(0, 0, 1, 1)}, static_cast<FillRule>(7)); }),
            "tricover: fill: not a FillRule");
}

TEST(PolygonValidation, RepeatedCollinearAndExtremeVerticesAreLegal) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  EXPECT_EQ(refusal({{{1, 1}, {1, 1}, {1, 1}}}), "");
  EXPECT_EQ(refusal({{{0, 0}, {1, 1}, {2, 2}}}), "");
  EXPECT_EQ(refusal({{{-kLargest, -kLargest}, {kLargest, -kLargest}, {0, kLargest}}}), "");
  EXPECT_EQ(refusal({{{0, 0}, {0, 5e-324}, {5e-324, 0}}}), "");
}

TEST(PolygonId, IsNeverReusedAndSharedByCopies) {
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(seen.insert(Polygon({rectangle(0, 0, 1, 1)}).id()).second);
  EXPECT_EQ(seen.count(0), 0u) << "0 stands for no polygon in the caches";
  const Polygon original({rectangle(0, 0, 1, 1)});
  const Polygon copy = original;  // NOLINT: the copy is the point
  EXPECT_EQ(copy.id(), original.id());
  EXPECT_EQ(&copy.rings(), &original.rings());
}

TEST(PolygonId, IsUniqueBeyondABlockOfIds) {
  constexpr std::size_t kIds = (std::size_t{1} << 20) + 1000;
  const std::vector<Vec2> triangle = {{0, 0}, {1, 0}, {0, 1}};
  std::vector<std::uint64_t> ids;
  for (std::size_t i = 0; i < kIds; ++i) ids.push_back(Polygon(triangle.data(), 3).id());
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
  EXPECT_NE(ids.front(), 0u);
}

TEST(Polygon, KeepsItsRingsAndNumbersItsEdgesThroughThem) {
  const std::vector<Ring> rings = {rectangle(0, 0, 9, 9), {{1, 1}, {1, 2}, {2, 1}}, rectangle(4, 4, 6, 6)};
  const Polygon polygon(rings, FillRule::NonZero);
  EXPECT_EQ(polygon.rings(), rings);
  EXPECT_EQ(polygon.fillRule(), FillRule::NonZero);
  ASSERT_EQ(polygon.vertexCount(), 11u);
  EXPECT_EQ(polygon.edgeCount(), 11);
  EdgeIndex edge = 0;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i, ++edge) {
      EXPECT_EQ(polygon.edgeStart(edge), ring[i]);
      EXPECT_EQ(polygon.edgeEnd(edge), ring[(i + 1) % ring.size()]);
    }
  }
  EXPECT_THROW(polygon.edgeStart(11), std::out_of_range);
  EXPECT_THROW(polygon.edgeEnd(11), std::out_of_range);
}

/// Bit for bit.
TEST(Polygon, OfRawVerticesIsThatOfTheirRing) {
  for (const Family& family : families()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Case c = family.make(seed);
      for (const Polygon& polygon : {c.a, c.b}) {
        const Ring& ring = polygon.rings().back();
        const Polygon by_ring({ring}, polygon.fillRule()), raw(ring.data(), ring.size(), polygon.fillRule());
        ASSERT_EQ(raw.rings(), by_ring.rings()) << family.name << " seed " << seed;
        ASSERT_EQ(raw.fillRule(), polygon.fillRule());
        ASSERT_EQ(raw.origin(), by_ring.origin());
        ASSERT_EQ(raw.radius(), by_ring.radius());
      }
    }
  }
}

TEST(Polygon, DiscHoldsEveryVertexAndIsTightAtEverySize) {
  for (const Family& family : families()) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Case c = family.make(seed);
      for (const Polygon& polygon : {c.a, c.b}) {
        const Vec2 s = polygon.origin();
        mpq_class farthest = 0;
        Vec2 low = polygon.rings()[0][0], high = low;
        for (const Ring& ring : polygon.rings()) {
          for (const Vec2& v : ring) {
            low = low.cwiseMin(v);
            high = high.cwiseMax(v);
            const mpq_class distance_squared = exact::distanceSquared(v, s, s);
            if (farthest < distance_squared) farthest = distance_squared;
          }
        }
        EXPECT_TRUE((low.array() <= s.array()).all() && (s.array() <= high.array()).all()) << family.name;
        if (polygon.radius() == kInfinity) continue;
        EXPECT_TRUE(exact::within(farthest, mpq_class(polygon.radius()))) << family.name << " seed " << seed;
        // A few of the smallest doubles more where the distances are no larger themselves.
        const mpq_class tight = (mpq_class(polygon.radius()) - 8 * mpq_class(5e-324)) * mpq_class(1 - 1e-12);
        EXPECT_TRUE(tight <= 0 || tight * tight <= farthest) << family.name << " seed " << seed;
      }
    }
  }
}

TEST(Polygon, DiscHoldsEveryVertexOfAFewOfTheSmallestDoubles) {
  constexpr double e = std::numeric_limits<double>::denorm_min();
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    Ring ring;
    for (int k = random.integer(3, 5); k > 0; --k)
      ring.emplace_back(e * random.integer(-3, 3), e * random.integer(-3, 3));
    const Polygon polygon({ring});
    for (const Vec2& v : ring)
      ASSERT_TRUE(
          exact::within(exact::distanceSquared(v, polygon.origin(), polygon.origin()), mpq_class(polygon.radius())))
          << "case " << i;
  }
}

TEST(Polygon, CoveringHasOneTriangleAnEdgeWithTheSignOfItsArea) {
  const Polygon polygon({rectangle(-3, -3, 3, 3), reversed(rectangle(1, 1, 2, 2))});
  const std::vector<paper::CoveringTriangle> covering = paper::covering(polygon);
  ASSERT_EQ(covering.size(), polygon.vertexCount());
  for (EdgeIndex edge = 0; edge < polygon.edgeCount(); ++edge) {
    const paper::CoveringTriangle& t = covering[static_cast<std::size_t>(edge)];
    EXPECT_EQ(t.s, polygon.origin());
    EXPECT_EQ(t.v, polygon.edgeStart(edge));
    EXPECT_EQ(t.w, polygon.edgeEnd(edge));
    const mpq_class area = (mpq_class(t.v.x()) - t.s.x()) * (mpq_class(t.w.y()) - t.s.y()) -
                           (mpq_class(t.v.y()) - t.s.y()) * (mpq_class(t.w.x()) - t.s.x());
    EXPECT_EQ(t.sign, sgn(area)) << edge;
  }
}

/// Moving copies.
TEST(Polygon, IsAsItWasWhenMovedFrom) {
  Polygon polygon({rectangle(0, 0, 1, 1)});
  const std::uint64_t id = polygon.id();
  Polygon moved(std::move(polygon)), other({rectangle(0, 0, 2, 2)});
  EXPECT_EQ(polygon.id(), id);  // NOLINT
  EXPECT_EQ(moved.id(), id);
  moved = std::move(other);
  EXPECT_EQ(moved.id(), other.id());  // NOLINT
  EXPECT_EQ(other.vertexCount(), 4u);
}

TEST(Polygon, RefusesEdgesThatArentThere) {
  const Polygon polygon({rectangle(0, 0, 1, 1)});
  for (const EdgeIndex edge : {EdgeIndex{-1}, EdgeIndex{4}, std::numeric_limits<EdgeIndex>::min()}) {
    EXPECT_THROW(polygon.edgeStart(edge), std::out_of_range);
    EXPECT_THROW(polygon.edgeEnd(edge), std::out_of_range);
  }
}

}  // namespace
}  // namespace tricover::support
