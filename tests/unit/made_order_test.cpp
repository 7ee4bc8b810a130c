// SPDX-License-Identifier: BSD-3-Clause
// Results don't depend on which polygon was made first: two polygons of equal size are ordered by what they are made
// of, bit for bit the same from run to run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <vector>

#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

/// Every number of every result, to be compared bit by bit.
std::vector<double> resultsOf(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              const Pose& end_b) {
  std::vector<double> all;
  const auto add = [&](std::initializer_list<double> more) { all.insert(all.end(), more); };
  add({static_cast<double>(collide(a, pose_a, b, pose_b))});
  const DistanceResult nearest = distance(a, pose_a, b, pose_b);
  add({nearest.distance, nearest.point_a.x(), nearest.point_a.y(), nearest.point_b.x(), nearest.point_b.y(),
       static_cast<double>(nearest.edge_a), static_cast<double>(nearest.edge_b)});
  for (const Contact& contact : contacts(a, pose_a, b, pose_b))
    add({contact.point.x(), contact.point.y(), contact.normal.x(), contact.normal.y(), contact.depth,
         static_cast<double>(contact.edge_a), static_cast<double>(contact.edge_b)});
  if (const auto depth = penetration(a, pose_a, b, pose_b))
    add({depth->translation.x(), depth->translation.y(), static_cast<double>(depth->edge_a),
         static_cast<double>(depth->edge_b)});
  if (const auto impact = timeOfImpact(a, Motion::still(pose_a), b, Motion::between(pose_b, end_b)))
    add({impact->time, impact->point.x(), impact->point.y(), impact->normal.x(), impact->normal.y(),
         static_cast<double>(impact->edge_a), static_cast<double>(impact->edge_b)});
  return all;
}

bool areBitwiseEqual(const std::vector<double>& p, const std::vector<double>& q) {
  return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof(double)) == 0;
}

/// The two rings have the same radius: of equal vertices, mirrored, or begun elsewhere.
TEST(OrderOfMaking, ChangesNoBitOfAnyResult) {
  Random random(10);
  int same_radius = 0;
  for (int i = 0; i < scaledCount(1500); ++i) {
    const Ring ring = random.coin() ? regular(random.integer(3, 12), 1) : star(random, random.integer(3, 24), 0.4, 1);
    Ring other = ring;
    if (random.coin()) std::rotate(other.begin(), other.begin() + 1, other.end());
    if (random.coin())
      for (Vec2& v : other) v.x() = -v.x();
    const double apart = random.real(0, 3), angle = random.real(0, 6.3);
    const Pose pose_a = pose(random.real(0, 6.3), 0.1, 0.7), pose_b = pose(angle, apart, 0.2),
               end_b = pose(angle, -apart, -0.1);
    std::optional<Polygon> a, b;
    a.emplace(std::vector<Ring>{ring});
    b.emplace(std::vector<Ring>{other});
    same_radius += a->radius() == b->radius();
    const std::vector<double> a_first = resultsOf(*a, pose_a, *b, pose_b, end_b);
    b.emplace(std::vector<Ring>{other});
    a.emplace(std::vector<Ring>{ring});
    ASSERT_TRUE(areBitwiseEqual(a_first, resultsOf(*a, pose_a, *b, pose_b, end_b))) << i;
    const Polygon copy({ring});
    b.emplace(std::vector<Ring>{other});
    ASSERT_TRUE(areBitwiseEqual(a_first, resultsOf(copy, pose_a, *b, pose_b, end_b))) << i;
  }
  EXPECT_GT(same_radius, scaledCount(1500) / 4);
}

}  // namespace
}  // namespace tricover::support
