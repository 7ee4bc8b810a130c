// SPDX-License-Identifier: BSD-3-Clause
// What polygons are made of and numbered by, their areas, centroids, bounds and convexity, and polygons made of them.
// Vertices that are repeated change no answer and cost nothing: a polygon is asked as if it had been written without
// them. Its edges keep the numbers that they were written with.
#include "tricover/polygon.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "refusal.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/paper.h"

namespace tricover::support {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

/// The text of the std::invalid_argument that these rings cause; empty if they are taken.
std::string refusalOf(const std::vector<Ring>& rings) {
  return refusal([&] { const Polygon polygon(rings); });
}

bool names(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(PolygonValidation, NamesWhatIsWrongAndWhere) {
  const Ring good = rectangle(0, 0, 1, 1);
  EXPECT_EQ(refusalOf({}), "tricover: rings: a polygon needs at least one ring");
  EXPECT_TRUE(names(refusalOf({good, {}}), "tricover: rings: ring 1: it has 0 vertices; "));
  EXPECT_TRUE(names(refusalOf({good, good, {{0, 0}, {1, 1}}}), "tricover: rings: ring 2: it has 2 vertices; "));
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    Ring ring = good;
    ring[3].y() = bad;
    EXPECT_EQ(refusalOf({good, good, ring}), "tricover: rings: ring 2, vertex 3: a coordinate is not finite");
    ring = good;
    ring[0].x() = bad;
    EXPECT_EQ(refusalOf({ring}), "tricover: rings: ring 0, vertex 0: a coordinate is not finite");
  }
}

TEST(PolygonValidation, OfRawVerticesIsThatOfTheirRingAlone) {
  const auto refusalOfRaw = [](const Vec2* vertices, std::size_t count, FillRule fill = FillRule::EvenOdd) {
    return refusal([&] { const Polygon polygon(vertices, count, fill); });
  };
  const Ring ring = rectangle(0, 0, 1, 1);
  EXPECT_EQ(refusalOfRaw(nullptr, 4), "tricover: rings: ring 0: its vertices are at no address");
  for (std::size_t count = 0; count < 3; ++count) {
    const std::string text = refusalOf({Ring(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(count))});
    EXPECT_NE(text, "");
    EXPECT_EQ(refusalOfRaw(ring.data(), count), text);
    EXPECT_EQ(refusalOfRaw(nullptr, count), text);
  }
  for (const std::size_t count : {std::size_t{1} << 29, std::numeric_limits<std::size_t>::max()})
    EXPECT_TRUE(names(refusal<std::length_error>([&] { const Polygon polygon(ring.data(), count); }),
                      "tricover: rings: more than 2^29 vertices"));
  const std::string no_rule = "tricover: fill: not a FillRule";
  EXPECT_EQ(refusalOfRaw(ring.data(), 4, static_cast<FillRule>(7)), no_rule);
  EXPECT_EQ(refusal([&] { Polygon({ring}, static_cast<FillRule>(7)); }), no_rule);
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    Ring broken = ring;
    broken[2].y() = bad;
    EXPECT_EQ(refusalOfRaw(broken.data(), 4), "tricover: rings: ring 0, vertex 2: a coordinate is not finite");
  }
}

TEST(PolygonValidation, RepeatedCollinearAndExtremeVerticesAreLegal) {
  for (const Ring& ring : {Ring(3, Vec2(1, 1)), Ring{{0, 0}, {1, 1}, {2, 2}}, Ring{{0, 0}, {0, 5e-324}, {5e-324, 0}},
                           Ring{{-kLargest, -kLargest}, {kLargest, -kLargest}, {0, kLargest}}})
    EXPECT_EQ(refusalOf({ring}), "");
}

TEST(PolygonId, IsSharedByCopies) {
  const Polygon original({rectangle(0, 0, 1, 1)});
  const Polygon copy = original;  // NOLINT: the copy is the point
  EXPECT_EQ(copy.id(), original.id());
  EXPECT_EQ(&copy.rings(), &original.rings());
}

/// Nor beyond a block of ids; and 0 stands for no polygon in the caches.
TEST(PolygonId, IsNeverReused) {
  constexpr std::size_t kIds = (std::size_t{1} << 20) + 1000;
  const std::vector<Vec2> triangle = {{0, 0}, {1, 0}, {0, 1}};
  std::vector<std::uint64_t> ids;
  for (std::size_t i = 0; i < kIds; ++i) ids.push_back(Polygon(triangle.data(), 3).id());
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
  EXPECT_NE(ids.front(), 0u);
}

const Motion kStill;
const Pose kHere = Pose::Identity();

/// Each vertex so many times, the first one as often at the ring's end as at its begin.
Ring repeated(const Ring& ring, int times) {
  Ring all;
  for (std::size_t i = 0; i < ring.size() * static_cast<std::size_t>(times); ++i)
    all.push_back(ring[(i + 1) / static_cast<std::size_t>(times) % ring.size()]);
  return all;
}

const Ring kL{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

std::vector<std::vector<Ring>> cases() {
  const Ring square = rectangle(-1, -1, 1, 1), hole = rectangle(-0.5, -0.5, 0.5, 0.5);
  std::vector<std::vector<Ring>> all;
  for (const int times : {2, 3, 7, 40})
    for (const Ring& ring : {square, kL, Ring{{0, 0}, {1, 0}}, Ring{{0.25, 0.5}}}) {
      if (ring.size() * static_cast<std::size_t>(times) < 3) continue;
      all.push_back({repeated(ring, times)});
      all.push_back({repeated(ring, times), hole});
      all.push_back({hole, repeated(ring, times), {{3, 3}, {3, 3}, {3, 3}}, square, repeated(hole, 2)});
    }
  return all;
}

TEST(Polygon, KeepsItsRingsAndNumbersItsEdgesThroughThem) {
  std::vector<std::vector<Ring>> all = cases();
  all.push_back({rectangle(0, 0, 9, 9), {{1, 1}, {1, 2}, {2, 1}}, rectangle(4, 4, 6, 6)});
  for (const std::vector<Ring>& rings : all) {
    const Polygon polygon(rings, FillRule::NonZero);
    EXPECT_EQ(polygon.rings(), rings);
    EXPECT_EQ(polygon.fillRule(), FillRule::NonZero);
    EdgeIndex edge = 0;
    for (const Ring& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i, ++edge) {
        EXPECT_EQ(polygon.edgeStart(edge), ring[i]) << edge;
        EXPECT_EQ(polygon.edgeEnd(edge), ring[(i + 1) % ring.size()]) << edge;
      }
    EXPECT_EQ(polygon.edgeCount(), edge);
    EXPECT_EQ(polygon.vertexCount(), static_cast<std::size_t>(edge));
    for (const EdgeIndex none : {EdgeIndex{-1}, edge, std::numeric_limits<EdgeIndex>::min()}) {
      EXPECT_THROW(polygon.edgeStart(none), std::out_of_range);
      EXPECT_THROW(polygon.edgeEnd(none), std::out_of_range);
    }
    EXPECT_EQ(paper::covering(polygon).size(), static_cast<std::size_t>(edge));
    EXPECT_EQ(polygon.translated({1, 0}).translated({-1, 0}).rings(), rings);
  }
}

TEST(Polygon, CoveringHasOneTriangleAnEdgeWithTheSignOfItsArea) {
  const Polygon polygon({rectangle(-3, -3, 3, 3), reversed(rectangle(1, 1, 2, 2))});
  const std::vector<paper::CoveringTriangle> covering = paper::covering(polygon);
  ASSERT_EQ(covering.size(), polygon.vertexCount());
  for (EdgeIndex edge = 0; edge < polygon.edgeCount(); ++edge) {
    const paper::CoveringTriangle& t = covering[static_cast<std::size_t>(edge)];
    EXPECT_EQ(t.s, polygon.coveringOrigin());
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

/// The edge that a result names is one with a length, unless there is none, and the nearest point is on it.
TEST(RepeatedVertices, AreNoEdgesOfResults) {
  const Polygon probe = Polygon::box(0.5, 0.25);
  for (const std::vector<Ring>& rings : cases()) {
    const Polygon polygon(rings);
    for (int i = 0; i < 24; ++i) {
      const Pose at = turnedAndMoved(0.3 * i, 4 * std::cos(0.26 * i), 4 * std::sin(0.26 * i));
      const DistanceResult found = distance(polygon, kHere, probe, at);
      const Vec2 v = polygon.edgeStart(found.edge_a), w = polygon.edgeEnd(found.edge_a);
      EXPECT_LE((found.point_a - v).norm() + (w - found.point_a).norm(), (w - v).norm() + 1e-12);
      EXPECT_NEAR(distance(Polygon::segment(v, w), kHere, probe, at).distance, found.distance, 1e-12);
      const Vec2 middle = at.translation();
      for (const Crossing& crossing : crossings(polygon, kHere, Polygon::segment(-middle, middle), kHere))
        EXPECT_LE((crossing.point - polygon.edgeStart(crossing.edge_a)).norm(),
                  (polygon.edgeEnd(crossing.edge_a) - polygon.edgeStart(crossing.edge_a)).norm() + 1e-12);
    }
  }
  EXPECT_TRUE(Polygon({repeated(rectangle(-1, -1, 1, 1), 9)}).isConvex());
  // As the vertices that begin a side are written: the last of those that repeat.
  const Polygon square({repeated(rectangle(-1, -1, 1, 1), 3)});
  EXPECT_EQ(distance(square, kHere, probe, turnedAndMoved(0, 0, -4)).edge_a, 1);
  EXPECT_EQ(distance(square, kHere, probe, turnedAndMoved(0, 4, 0)).edge_a, 4);
  EXPECT_EQ(distance(square, kHere, probe, turnedAndMoved(0, -4, 0)).edge_a, 10);
}

TEST(RepeatedVertices, OfASegmentOrAPointCrossOnce) {
  const Polygon square = Polygon::box(2, 2);
  // Both edges of the segment meet the square's right side, edge 1.
  const std::vector<Crossing> found = crossings(square, kHere, Polygon({{{0, 0}, {0, 0}, {2, 0}, {0, 0}}}), kHere);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].edge_a, 1);
  EXPECT_EQ(found[1].edge_a, 1);
  EXPECT_EQ(found[0].edge_b + found[1].edge_b, 1 + 2);
  const Vec2 middle(1, 0.25);
  EXPECT_EQ(crossings(square, kHere, Polygon({{middle, middle, middle, middle, middle}}), kHere).size(), 1u);
}

/// A point slides along an edge, and so does a segment: the contact lasts as long as that of point() and segment().
TEST(RepeatedVertices, OfAPointLastInContact) {
  const Polygon floor({kL});
  for (const double time_error : {1e-6, 1e-9})
    for (const int times : {3, 4, 17}) {
      const Ring one{{0.25, 0.5}};
      const Polygon written({repeated(one, times)}), twice(std::vector<Ring>{repeated(one, times), repeated(one, 3)});
      const Motion way = Motion::translation(turnedAndMoved(0, -2.25, -0.5), {8, 0}), on = way.part(0.375, 1);
      const auto expected = conflicts(floor, kStill, Polygon::point(one[0]), way, {0, time_error});
      ASSERT_EQ(expected.size(), 1u);
      for (const Polygon& polygon : {written, twice}) {
        const auto found = conflicts(floor, kStill, polygon, way, {0, time_error});
        ASSERT_EQ(found.size(), 1u);
        EXPECT_FALSE(found[0].budget_ended);
        EXPECT_NEAR(found[0].impact.time, expected[0].impact.time, 1e-12);
        EXPECT_NEAR(found[0].end, expected[0].end, time_error);
        EXPECT_FALSE(timeOfImpact(floor, kStill, polygon, on, {0, time_error, true}).has_value());
      }
    }
}

TEST(PolygonMeasures, AreOfTheRegionWhicheverWayItsRingsRun) {
  const Ring outer = rectangle(0, 0, 10, 10), hole = rectangle(0, 0, 5, 10), island = rectangle(1, 1, 2, 2);
  for (const Ring& out : {outer, reversed(outer)})
    for (const Ring& in : {hole, reversed(hole)}) {
      const Polygon polygon({out, in, island});
      EXPECT_DOUBLE_EQ(polygon.area(), 51);
      EXPECT_NEAR(polygon.centroid().x(), (50 * 7.5 + 1.5) / 51, 1e-13);
    }
}

TEST(PolygonMeasures, FillRulesDifferWhereRingsOverlap) {
  const std::vector<Ring> crossed = {rectangle(0, 0, 4, 4), rectangle(2, 2, 6, 6)};
  EXPECT_DOUBLE_EQ(Polygon(crossed).area(), 24);
  EXPECT_DOUBLE_EQ(Polygon(crossed, FillRule::NonZero).area(), 28);
  const std::vector<Ring> twice = {rectangle(0, 0, 4, 4), rectangle(0, 0, 4, 4)};
  EXPECT_EQ(Polygon(twice).area(), 0);
  EXPECT_DOUBLE_EQ(Polygon(twice, FillRule::NonZero).area(), 16);
  // An hourglass: its signed area is 0.
  const Polygon hourglass({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}});
  EXPECT_DOUBLE_EQ(hourglass.area(), 2);
  EXPECT_EQ(hourglass.centroid(), Vec2(1, 1));
}

TEST(PolygonMeasures, WithoutAnAreaTheCentroidIsTheMiddle) {
  EXPECT_EQ(Polygon::point({3, 4}).area(), 0);
  EXPECT_EQ(Polygon::point({3, 4}).centroid(), Vec2(3, 4));
  EXPECT_EQ(Polygon::segment({0, 0}, {2, 4}).area(), 0);
  EXPECT_EQ(Polygon::segment({0, 0}, {2, 4}).centroid(), Vec2(1, 2));
  // Four corners on a line, of which rounding makes an area.
  EXPECT_EQ(Polygon({{{1, -5}, {4, 4}, {5, 7}, {2, -2}}}).centroid(), Vec2(3, 1));
  // There and back along two lines, with other corners on the way back.
  EXPECT_EQ(Polygon({{{0, 0}, {3, 1}, {1, 7}, {1.5, 5.5}, {3, 1}, {1.5, 0.5}}}).centroid(), Vec2(1.5, 3.5));
  // A ring upon itself, of which the even-odd rule leaves nothing, and the non-zero rule leaves all.
  const std::vector<Ring> twice(2, {{0, 0}, {3, 1}, {1, 7}});
  EXPECT_EQ(Polygon(twice).centroid(), Vec2(1.5, 3.5));
  EXPECT_TRUE(Polygon(twice, FillRule::NonZero).centroid().isApprox(Vec2(4, 8) / 3));
  // Many edges upon each other, on two lines, of which all pairs would take minutes.
  Ring on_two_lines;
  for (int i = 0; i < 15000; ++i) on_two_lines.emplace_back((i * 7919) % 15000, 0);
  for (int i = 0; i < 15000; ++i) on_two_lines.emplace_back(0, (i * 7919) % 15000);
  EXPECT_EQ(Polygon({on_two_lines}).centroid(), Vec2(7499.5, 7499.5));
}

TEST(PolygonMeasures, GoToTheEndsOfDoubles) {
  EXPECT_DOUBLE_EQ(Polygon({rectangle(0, 0, 1e150, 1e150)}).area(), 1e300);
  EXPECT_DOUBLE_EQ(Polygon({rectangle(0, 0, 1e-150, 1e-150)}).area(), 1e-300);
  const Polygon largest({rectangle(-kLargest, -kLargest, kLargest, kLargest)});
  EXPECT_EQ(largest.area(), kInfinity);
  EXPECT_EQ(largest.bounds().max(), Vec2(kLargest, kLargest));
  EXPECT_LE(largest.centroid().norm(), 1e-10 * kLargest);
  // Far from the origin.
  const Polygon far({rectangle(1e9, 1e9, 1e9 + 1, 1e9 + 1)});
  EXPECT_EQ(far.area(), 1);
  EXPECT_EQ(far.centroid(), Vec2(1e9 + 0.5, 1e9 + 0.5));
}

TEST(PolygonMeasures, ConvexIsOneRingOnceAround) {
  EXPECT_TRUE(Polygon({regular(7, 1)}).isConvex());
  EXPECT_TRUE(Polygon({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}}}).isConvex());
  EXPECT_FALSE(Polygon({{{0, 0}, {4, 0}, {4, 4}, {3, 1}}}).isConvex());
  EXPECT_FALSE(Polygon({regular(7, 1), regular(7, 0.5)}).isConvex());
  EXPECT_FALSE(Polygon::point({0, 0}).isConvex());
}

TEST(PolygonMeasures, AreMovedAndScaled) {
  const Polygon polygon({rectangle(1, 2, 3, 4), {{5, 5}, {6, 5}, {5, 6}}}, FillRule::NonZero);
  const Polygon moved = polygon.translated({-1, 10});
  EXPECT_EQ(moved.rings()[1][2], Vec2(4, 16));
  EXPECT_EQ(moved.fillRule(), FillRule::NonZero);
  EXPECT_EQ(polygon.scaled(0.5).rings()[0][2], Vec2(1.5, 2));
  EXPECT_EQ(polygon.scaled(0.5).fillRule(), FillRule::NonZero);
  EXPECT_EQ(refusal([&] { polygon.translated({0, kInfinity}); }), "tricover: by: a coordinate is not finite");
  for (const double factor : {0.0, -1.0, kInfinity, std::nan("")})
    EXPECT_EQ(refusal([&] { polygon.scaled(factor); }), "tricover: factor: it must be finite and positive");
  EXPECT_EQ(refusal([&] { polygon.scaled(kLargest); }),
            "tricover: rings: ring 0, vertex 0: a coordinate is not finite");
}

TEST(PolygonSimplified, KeepsRingsAndWhatIsBeyondTheTolerance) {
  const Polygon frame({{{0, 0}, {5, 0.125}, {10, 0}, {10, 10}, {0, 10}}, {{4, 4}, {4.0625, 4}, {4, 4.0625}}});
  const Polygon simple = frame.simplified(0.125);
  EXPECT_EQ(simple.rings()[0], rectangle(0, 0, 10, 10));
  ASSERT_EQ(simple.rings().size(), 2u);
  EXPECT_EQ(simple.rings()[1], Ring(3, Vec2(4, 4)));
  EXPECT_EQ(frame.simplified(0.1).rings()[0], frame.rings()[0]);
  // Back and forth: within the tolerance of the line, but not of the chord.
  const Polygon spike({{{0, 0}, {9, 0}, {4, 0}, {4, 4}}});
  EXPECT_EQ(spike.simplified(0.5).vertexCount(), 4u);
  for (const double tolerance : {-1.0, kInfinity, std::nan("")})
    EXPECT_EQ(refusal([&] { frame.simplified(tolerance); }), "tricover: tolerance: it must be finite and not negative");
}

TEST(PolygonSimplified, OutwardsPocketsAreFilledAndHolesShrink) {
  const Ring outer = {{0, 0}, {5, 0.125}, {10, 0}, {10, 10}, {0, 10}};
  const Ring hole = {{3, 3}, {5, 2.875}, {7, 3}, {7, 7}, {3, 7}};  // wider by an edge's bend
  const Polygon frame({outer, hole});
  const Polygon cover = frame.simplified(0.125, Simplify::Outwards);
  EXPECT_EQ(cover.rings()[0].size(), 4u);
  ASSERT_EQ(cover.rings().size(), 2u);
  EXPECT_EQ(cover.rings()[1].size(), 4u);
  EXPECT_EQ(cover.area(), 100 - 16);
  EXPECT_EQ(frame.simplified(0.1, Simplify::Outwards).vertexCount(), 10u);
  // What bulges isn't cut off: the edges beside it are lengthened.
  const Polygon chamfered({{{0, 0}, {9, 0}, {9.5, 0.25}, {9.75, 0.5}, {9.75, 9}, {0, 9}}});
  const Polygon box = chamfered.simplified(0.5, Simplify::Outwards);
  EXPECT_EQ(box.vertexCount(), 4u);
  EXPECT_NEAR(box.area(), 9.75 * 9, 1e-12);
  EXPECT_EQ(refusal([&] { frame.simplified(-1, Simplify::Outwards); }),
            "tricover: tolerance: it must be finite and not negative");
}

TEST(PolygonSimplified, OutwardsNothingIsLost) {
  // Of a ring without an area, and of a spike.
  const Polygon bare({{{0, 0}, {4, 1}, {8, 0}, {4, 1}}});
  EXPECT_EQ(bare.simplified(2, Simplify::Outwards).rings(), bare.rings());
  const Polygon spike({{{0, 0}, {4, 0}, {4, 4}, {5, 4}, {4, 4}, {0, 4}}});
  EXPECT_EQ(locate(spike.simplified(3, Simplify::Outwards), {5, 4}), Location::Boundary);
  // A slot narrower than the tolerance: filled from both sides, it would be empty again by the even-odd rule.
  const Polygon slot({{{0, 0}, {4, 0}, {4, 4}, {2.125, 4}, {2.0625, 1}, {1.875, 4}, {0, 4}}});
  const Polygon full = slot.simplified(0.25, Simplify::Outwards);
  for (const Vec2& p : {Vec2(2, 0.5), Vec2(1, 4), Vec2(2.5, 4), Vec2(2, 1)})
    EXPECT_NE(locate(full, p), Location::Outside);
  // A ring's pocket that lies in another ring: to fill it changes what both cover.
  const std::vector<Ring> crossing = {rectangle(0, 0, 10, 10), {{8, 2}, {14, 2}, {14, 8}, {8, 8}, {8.5, 5}}};
  for (const FillRule fill : {FillRule::EvenOdd, FillRule::NonZero}) {
    const Polygon cover = Polygon(crossing, fill).simplified(1, Simplify::Outwards);
    for (const Vec2& p : {Vec2(8.25, 5), Vec2(12, 5), Vec2(1, 1)})
      EXPECT_TRUE(locate(Polygon(crossing, fill), p) == Location::Outside || locate(cover, p) != Location::Outside);
  }
}

TEST(PolygonSimplified, OutwardsDiscsTakeFewCorners) {
  const Polygon disc({regular(1000, 1)});
  const Polygon cover = disc.simplified(0.01, Simplify::Outwards);
  EXPECT_LE(cover.vertexCount(), 40u);  // the tolerance's ring holds a polygon of 23
  EXPECT_LE(cover.radius(), 1.01 + 1e-12);
  // A straight chain of any length is one edge first.
  Ring wall;
  for (int i = 0; i < 10000; ++i) wall.emplace_back(i, 0);
  wall.insert(wall.end(), {{1e4, 1}, {0, 1}});
  EXPECT_EQ(Polygon({wall}).simplified(0.5, Simplify::Outwards).vertexCount(), 4u);
}

}  // namespace
}  // namespace tricover::support
