// SPDX-License-Identifier: BSD-3-Clause
// Vertices that are repeated change no answer and cost nothing: a polygon is asked as if it had been written without
// them. Its edges keep the numbers that they were written with.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/paper.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

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

TEST(RepeatedVertices, StayInRingsAndNumbers) {
  for (const std::vector<Ring>& rings : cases()) {
    const Polygon polygon(rings);
    EXPECT_EQ(polygon.rings(), rings);
    EdgeIndex edge = 0;
    for (const Ring& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i, ++edge) {
        EXPECT_EQ(polygon.edgeStart(edge), ring[i]) << edge;
        EXPECT_EQ(polygon.edgeEnd(edge), ring[(i + 1) % ring.size()]) << edge;
      }
    EXPECT_EQ(polygon.edgeCount(), edge);
    EXPECT_EQ(polygon.vertexCount(), static_cast<std::size_t>(edge));
    EXPECT_THROW(polygon.edgeStart(edge), std::out_of_range);
    EXPECT_EQ(paper::covering(polygon).size(), static_cast<std::size_t>(edge));
    const Polygon moved = polygon.translated({1, 0}).translated({-1, 0});
    EXPECT_EQ(moved.rings(), rings);
  }
}

/// The edge that a result names is one with a length, unless there is none, and the nearest point is on it.
TEST(RepeatedVertices, AreNoEdgesOfResults) {
  const Polygon probe = box(0.5, 0.25);
  for (const std::vector<Ring>& rings : cases()) {
    const Polygon polygon(rings);
    for (int i = 0; i < 24; ++i) {
      const Pose at = turnedAndMoved(0.3 * i, 4 * std::cos(0.26 * i), 4 * std::sin(0.26 * i));
      const DistanceResult found = distance(polygon, kHere, probe, at);
      const Vec2 v = polygon.edgeStart(found.edge_a), w = polygon.edgeEnd(found.edge_a);
      EXPECT_LE((found.point_a - v).norm() + (w - found.point_a).norm(), (w - v).norm() + 1e-12);
      EXPECT_NEAR(distance(segment(v, w), kHere, probe, at).distance, found.distance, 1e-12);
      const Vec2 middle = at.translation();
      for (const Crossing& crossing : crossings(polygon, kHere, segment(-middle, middle), kHere))
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
  const Polygon square = box(2, 2);
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
      const auto expected = conflicts(floor, kStill, point(one[0]), way, {0, time_error});
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

}  // namespace
}  // namespace tricover::support
