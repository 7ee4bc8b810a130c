// SPDX-License-Identifier: BSD-3-Clause
// Where rings cross themselves and each other: by hand, and beside a brute force on rational numbers.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/tricover.h"

namespace tricover {

using Kind = SelfCrossingKind;

/// Names kinds in failures.
void PrintTo(const SelfCrossing& crossing, std::ostream* out) { *out << crossing.text; }

namespace support {
namespace {

std::vector<Kind> kindsOf(const Polygon& polygon) {
  std::vector<Kind> kinds;
  for (const SelfCrossing& crossing : selfCrossings(polygon)) kinds.push_back(crossing.kind);
  return kinds;
}

using Kinds = std::vector<Kind>;

TEST(SelfCrossings, OfAValidPolygonAreNone) {
  const Ring hole = reversed(rectangle(1, 1, 2, 2)), island = rectangle(1.25, 1.25, 1.5, 1.5);
  EXPECT_EQ(kindsOf(Polygon::box(1, 2)), Kinds());
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 4, 4), hole, island, rectangle(5, 0, 6, 1)})), Kinds());
  // Clockwise shells with counter-clockwise holes, as in shapefiles, and repeated vertices.
  EXPECT_EQ(kindsOf(Polygon({reversed(rectangle(0, 0, 4, 4)), reversed(hole)})), Kinds());
  EXPECT_EQ(kindsOf(Polygon({Ring{{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 0}}})), Kinds());
  // A hole that runs as its shell does is one by the even-odd rule.
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2)})), Kinds());
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2)}, FillRule::NonZero)), Kinds());
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 4, 4)}).complement()), Kinds());
}

TEST(SelfCrossings, OfRingsThatTouchAtPointsAreNone) {
  // A ring that touches itself from outside and from inside, at a vertex and with a vertex on an edge.
  EXPECT_EQ(kindsOf(Polygon({Ring{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}})), Kinds());
  EXPECT_EQ(kindsOf(Polygon({Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 3}, {3, 1}}})), Kinds());
  EXPECT_EQ(kindsOf(Polygon({Ring{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}})), Kinds());
  // Squares that share a corner, four of them, and a hole that touches its shell four times.
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 1, 1), rectangle(1, 1, 2, 2)})), Kinds());
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 4, 4), Ring{{2, 0}, {0, 2}, {2, 4}, {4, 2}}})), Kinds());
}

TEST(SelfCrossings, SayWhere) {
  const std::vector<SelfCrossing> bow = selfCrossings(Polygon({Ring{{0, 0}, {2, 2}, {2, 0}, {0, 1}}}));
  ASSERT_EQ(bow.size(), 1u);
  EXPECT_EQ(bow[0].kind, Kind::Crossing);
  EXPECT_NEAR(bow[0].point.x(), 2 / 3.0, 1e-15);
  EXPECT_EQ((std::array{bow[0].edge_a, bow[0].edge_b}), (std::array<EdgeIndex, 2>{0, 2}));

  const Polygon apart({rectangle(0, 0, 2, 2), rectangle(8, 8, 9, 9), rectangle(1, 1, 3, 3)});
  const std::vector<SelfCrossing> two = selfCrossings(apart);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].text,
            "ring 0 crosses ring 2 at (2, 1): the edge from vertex 1 of ring 0 and the edge from vertex 0 "
            "of ring 2 cross between their ends");
  EXPECT_EQ(two[1].point, Vec2(1, 2));
  EXPECT_EQ((std::array{two[1].ring_a, two[1].ring_b}), (std::array<std::size_t, 2>{0, 2}));
  EXPECT_EQ((std::array{two[1].edge_a, two[1].edge_b}), (std::array<EdgeIndex, 2>{2, 11}));
  EXPECT_EQ(selfCrossings(apart, 1).size(), 1u);
  EXPECT_TRUE(selfCrossings(apart, 0).empty());
}

TEST(SelfCrossings, AtVertices) {
  // Two triangles that cross at vertices alone, a corner that pokes through an edge, a ring that goes around twice.
  EXPECT_EQ(kindsOf(Polygon({Ring{{0, 0}, {2, 2}, {4, 4}, {4, 0}, {2, 2}, {0, 4}}})), Kinds{Kind::CrossingAtVertex});
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 4, 4), Ring{{2, -1}, {2, 0}, {2, 1}, {3, 0}, {3, -1}}})),
            (Kinds{Kind::CrossingAtVertex, Kind::CrossingAtVertex}));
  EXPECT_EQ(kindsOf(Polygon({Ring{{0, 0}, {4, 0}, {0, 4}, {0, 0}, {2, 1}, {1, 2}}})), Kinds{Kind::CrossingAtVertex});
}

TEST(SelfCrossings, AlongEdges) {
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)})), Kinds{Kind::Overlap});
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 4, 4), rectangle(1, 0, 2, 1)})), Kinds{Kind::Overlap});
  EXPECT_EQ(kindsOf(Polygon({Ring{{0, 0}, {4, 0}, {5, 0}, {4, 0}, {4, 4}}})), Kinds{Kind::Overlap});  // a spike
}

TEST(SelfCrossings, OfWholeRings) {
  Ring turned = rectangle(0, 0, 2, 2);
  std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  for (const Ring& again : {turned, reversed(turned)})
    EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 2, 2), again})), Kinds{Kind::RepeatedRing});
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 2, 2), turned, turned})), (Kinds(3, Kind::RepeatedRing)));
  EXPECT_EQ(kindsOf(Polygon::point({1, 1})), Kinds{Kind::NoArea});
  EXPECT_EQ(kindsOf(Polygon::segment({1, 1}, {2, 3})), Kinds{Kind::NoArea});
  EXPECT_EQ(kindsOf(Polygon({Ring{{0, 0}, {2, 0}, {1, 0}, {3, 0}}})), Kinds{Kind::NoArea});

  const std::vector<SelfCrossing> outside =
      selfCrossings(Polygon({rectangle(0, 0, 2, 2), reversed(rectangle(4, 4, 5, 5))}));
  ASSERT_EQ(outside.size(), 1u);
  EXPECT_EQ(outside[0].kind, Kind::HoleOutside);
  EXPECT_EQ(outside[0].ring_a, 1u);
  EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, 2, 2), reversed(rectangle(4, 4, 5, 5))}, FillRule::NonZero)),
            Kinds{Kind::HoleOutside});
}

TEST(SelfCrossings, OfHugeAndTinyPolygons) {
  for (const double size : {1e308, 1e-300, std::numeric_limits<double>::denorm_min() * 8}) {
    const Polygon bow({Ring{{0, 0}, {size, size}, {size, 0}, {0, size}}});
    const std::vector<SelfCrossing> found = selfCrossings(bow);
    ASSERT_EQ(found.size(), 1u) << size;
    EXPECT_NEAR(found[0].point.x() / size, 0.5, 1e-15);
    EXPECT_EQ(kindsOf(Polygon({rectangle(0, 0, size, size)})), Kinds());
  }
}

// ---- the brute force ----

using Exact = std::array<mpq_class, 2>;
Exact exact(const Vec2& p) { return {mpq_class(p.x()), mpq_class(p.y())}; }
int side(const Exact& p, const Exact& q, const Exact& r) {
  return sgn((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
}
bool isOn(const Exact& p, const Exact& v, const Exact& w) {
  return side(v, w, p) == 0 && std::min(v, w) <= p && p <= std::max(v, w);
}

struct Truth {
  std::set<std::pair<EdgeIndex, EdgeIndex>> crossings, overlaps;
  std::set<Exact> at_vertices;
};

/// The region between two directions from a point: whether `to` is strictly inside of the angle from a to b,
/// counter-clockwise.
bool isBetweenDirections(const Exact& at, const Exact& a, const Exact& b, const Exact& to) {
  const bool after_a = side(at, a, to) > 0, before_b = side(at, to, b) > 0;
  const int turn = side(at, a, b);
  if (turn > 0) return after_a && before_b;
  if (turn < 0) return after_a || before_b;
  return after_a;  // straight on
}

Truth truthOf(const Polygon& polygon) {
  struct Edge {
    Exact v, w;
    std::size_t ring, place, size;
  };
  std::vector<Edge> edges;
  std::map<std::size_t, std::vector<Exact>> rings;
  for (std::size_t r = 0; r < polygon.rings().size(); ++r) {
    const Ring& ring = polygon.rings()[r];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({exact(ring[i]), exact(ring[(i + 1) % ring.size()]), r, i, ring.size()});
      rings[r].push_back(edges.back().v);
    }
  }
  Truth truth;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge &e = edges[i], &f = edges[j];
      const int r = side(e.v, e.w, f.v), s = side(e.v, e.w, f.w), p = side(f.v, f.w, e.v), q = side(f.v, f.w, e.w);
      const std::pair<EdgeIndex, EdgeIndex> key(static_cast<EdgeIndex>(i), static_cast<EdgeIndex>(j));
      if (r * s < 0 && p * q < 0) truth.crossings.insert(key);
      if (r == 0 && s == 0 &&
          std::max(std::min(e.v, e.w), std::min(f.v, f.w)) < std::min(std::max(e.v, e.w), std::max(f.v, f.w)))
        truth.overlaps.insert(key);
    }
  // Ways through each vertex, with the points before and after it.
  for (const auto& at_edge : edges) {
    const Exact& at = at_edge.v;
    std::vector<std::pair<Exact, Exact>> ways;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Edge& e = edges[i];
      if (e.v == at)
        ways.emplace_back(rings[e.ring][(e.place + e.size - 1) % e.size], e.w);
      else if (e.w != at && isOn(at, e.v, e.w))
        ways.emplace_back(e.v, e.w);
    }
    for (std::size_t i = 0; i < ways.size(); ++i)
      for (std::size_t j = i + 1; j < ways.size(); ++j) {
        const auto& [a, b] = ways[i];
        const auto& [c, d] = ways[j];
        if (isBetweenDirections(at, a, b, c) && isBetweenDirections(at, b, a, d)) truth.at_vertices.insert(at);
        if (isBetweenDirections(at, a, b, d) && isBetweenDirections(at, b, a, c)) truth.at_vertices.insert(at);
      }
  }
  return truth;
}

/// Rings on a small grid, where nearly all is degenerate, some of whose vertices are an ulp off; no vertex repeated.
Polygon randomPolygon(Random& random) {
  std::vector<Ring> rings(static_cast<std::size_t>(random.integer(1, 3)));
  const int cells = random.integer(2, 8);
  for (Ring& ring : rings) {
    const int count = random.integer(3, 7);
    while (static_cast<int>(ring.size()) < count) {
      Vec2 p(random.integer(0, cells), random.integer(0, cells));
      if (random.integer(0, 7) == 0) p.x() = nudged(p.x(), random.integer(-2, 2));
      if (ring.empty() || (p != ring.back() && (static_cast<int>(ring.size()) + 1 < count || p != ring.front())))
        ring.push_back(p);
    }
  }
  return Polygon(rings, random.integer(0, 1) == 0 ? FillRule::EvenOdd : FillRule::NonZero);
}

TEST(SelfCrossings, AreThoseOfABruteForce) {
  Random random(7);
  int valid = 0, invalid = 0, at_vertices = 0;
  for (int i = 0; i < scaledCount(4000); ++i) {
    const Polygon polygon = randomPolygon(random);
    const Truth truth = truthOf(polygon);
    std::set<std::pair<EdgeIndex, EdgeIndex>> crossings, overlaps;
    std::set<Exact> points;
    std::set<std::size_t> flat;
    bool repeats = false;
    for (const SelfCrossing& found : selfCrossings(polygon)) {
      EXPECT_FALSE(found.text.empty());
      const std::pair<EdgeIndex, EdgeIndex> key(found.edge_a, found.edge_b);
      if (found.kind == Kind::Crossing) crossings.insert(key);
      if (found.kind == Kind::Overlap) overlaps.insert(key);
      if (found.kind == Kind::CrossingAtVertex) points.insert(exact(found.point));
      if (found.kind == Kind::NoArea) flat.insert(found.ring_a);
      repeats = repeats || found.kind == Kind::RepeatedRing;
    }
    EXPECT_EQ(crossings, truth.crossings);
    if (flat.empty() && !repeats) {
      EXPECT_EQ(overlaps, truth.overlaps);
    } else {
      EXPECT_TRUE(std::includes(truth.overlaps.begin(), truth.overlaps.end(), overlaps.begin(), overlaps.end()));
      EXPECT_FALSE(truth.overlaps.empty());
    }
    // Where edges run along each other, that is what is said.
    if (truth.overlaps.empty()) {
      EXPECT_EQ(points, truth.at_vertices);
    }
    EXPECT_TRUE(std::includes(truth.at_vertices.begin(), truth.at_vertices.end(), points.begin(), points.end()));
    at_vertices += points.empty() ? 0 : 1;
    (truth.crossings.empty() && truth.overlaps.empty() && truth.at_vertices.empty() ? valid : invalid) += 1;
  }
  EXPECT_GT(valid, scaledCount(100));
  EXPECT_GT(invalid, scaledCount(1000));
  EXPECT_GT(at_vertices, scaledCount(200));
}

}  // namespace
}  // namespace support
}  // namespace tricover
