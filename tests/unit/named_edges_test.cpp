// SPDX-License-Identifier: BSD-3-Clause
// No result names an edge without length, unless the ring has no other: rings may repeat vertices, as every ring of
// WKT and GeoJSON repeats its first one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/ray.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

/// Convex or not, on a lattice as often as not, begun anywhere and closed; here and there a vertex is said thrice.
Ring closedRing(Random& random) {
  Ring ring = random.coin() ? regular(random.integer(3, 9), 1) : star(random, random.integer(3, 20), 0.3, 1);
  if (random.coin())
    for (Vec2& v : ring) v = Vec2(std::round(4 * v.x()), std::round(4 * v.y())) / 4;
  std::rotate(ring.begin(), ring.begin() + random.integer(0, static_cast<int>(ring.size()) - 1), ring.end());
  if (random.coin()) ring = withRepeatedAndMidpoints(random, ring);
  for (int more = random.integer(0, 2); more >= 0; --more) ring.push_back(ring.front());
  if (random.coin()) std::reverse(ring.begin(), ring.end());
  return ring;
}

Polygon closedPolygon(Random& random) {
  std::vector<Ring> rings = {closedRing(random)};
  if (random.oneIn(3)) rings.push_back(shifted(scaled(closedRing(random), 0.25), {0.1, 0}));
  return Polygon(rings);
}

/// -1 names none. No ring here is a point alone, but for some that the lattice makes one.
bool isNamable(const Polygon& polygon, EdgeIndex edge) {
  if (edge < 0 || polygon.edgeStart(edge) != polygon.edgeEnd(edge)) return true;
  for (const Ring& ring : polygon.rings()) {
    const bool is_point = std::all_of(ring.begin(), ring.end(), [&](const Vec2& v) { return v == ring.front(); });
    if (is_point && ring.front() == polygon.edgeStart(edge)) return true;
  }
  return false;
}

TEST(NamedEdges, OfAClosedRingHaveALength) {
  const Polygon l({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}}});
  const DistanceResult nearest = distance(l, pose(0, 0, 0), l, pose(0, -2, -2.5));
  EXPECT_DOUBLE_EQ(nearest.distance, std::hypot(1, 0.5));
  EXPECT_TRUE(isNamable(l, nearest.edge_a)) << nearest.edge_a;
  EXPECT_TRUE(isNamable(l, nearest.edge_b)) << nearest.edge_b;
  EXPECT_EQ(nearest.point_a, Vec2(0, 0));
}

TEST(NamedEdges, OfAPointAreThatPoint) {
  const Polygon point({{{1, 2}, {1, 2}, {1, 2}}}), box({rectangle(3, 1, 4, 3)});
  const DistanceResult nearest = distance(point, pose(0, 0, 0), box, pose(0, 0, 0));
  EXPECT_EQ(nearest.distance, 2);
  EXPECT_GE(nearest.edge_a, 0);
  EXPECT_LT(nearest.edge_a, 3);
}

TEST(NamedEdges, HaveALengthInEveryQuery) {
  Random random(35);
  for (int i = 0; i < scaledCount(4000); ++i) {
    const Polygon a = closedPolygon(random), b = closedPolygon(random);
    const double apart = random.real(0, 3);
    const bool is_turned = random.coin();
    const Pose pose_a = pose(0, 0, 0),
               pose_b = pose(is_turned ? random.real(-3, 3) : 0, apart, random.coin() ? std::round(2 * apart) / 4 : 0);
    const auto expectNamable = [&](EdgeIndex edge_a, EdgeIndex edge_b, const char* query) {
      EXPECT_TRUE(isNamable(a, edge_a)) << query << " " << i << ": a's " << edge_a;
      EXPECT_TRUE(isNamable(b, edge_b)) << query << " " << i << ": b's " << edge_b;
    };
    PairCache cache;
    DistanceOptions with_margin;
    with_margin.margin = 0.25;
    for (const DistanceOptions& options : {DistanceOptions(), with_margin})
      for (int step = 0; step < 2; ++step) {
        const DistanceResult nearest = distance(a, pose_a, b, pose_b, cache, options);
        expectNamable(nearest.edge_a, nearest.edge_b, "distance");
      }
    const Motion motion = Motion::between(pose_b, pose(is_turned ? 1 : 0, -apart, 0));
    if (const auto impact = timeOfImpact(a, Motion::still(pose_a), b, motion))
      expectNamable(impact->edge_a, impact->edge_b, "timeOfImpact");
    for (const ContactDetail detail : {ContactDetail::Points, ContactDetail::LocalDepth, ContactDetail::GlobalDepth}) {
      ContactOptions options;
      options.detail = detail;
      for (const Contact& contact : contacts(a, pose_a, b, pose_b, options))
        expectNamable(contact.edge_a, contact.edge_b, "contacts");
    }
    if (const auto depth = penetration(a, pose_a, b, pose_b))
      expectNamable(depth->edge_a, depth->edge_b, "penetration");
    const EdgeIndex towards = anyEdge(random, b);
    if (const auto hit = castRay(b, pose_b, pose_a.translation(), pose_b * b.edgeStart(towards)))
      expectNamable(-1, hit->edge, "castRay");
    Scene scene;
    scene.add(b, pose_b);
    if (const auto nearest = scene.nearest(a, pose_a))
      expectNamable(nearest->result.edge_a, nearest->result.edge_b, "nearest");
  }
}

}  // namespace
}  // namespace tricover::support
