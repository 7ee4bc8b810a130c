// SPDX-License-Identifier: BSD-3-Clause
// Pairs as large as doubles go: what is said to be finite there is, and nothing is ever NaN.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

/// The same with its largest coordinate near the largest double.
Case enlarged(Random& random, Case c) {
  double most =
      std::max(c.pose_a.translation().lpNorm<Eigen::Infinity>(), c.pose_b.translation().lpNorm<Eigen::Infinity>());
  for (const Polygon* polygon : {&c.a, &c.b})
    for (const Ring& ring : polygon->rings())
      for (const Vec2& p : ring) most = std::max(most, p.lpNorm<Eigen::Infinity>());
  const double factor = kLargest / most * (random.coin() ? 1 - 1e-9 : random.real(0.01, 1));
  c.a = c.a.scaled(factor);
  c.b = c.b.scaled(factor);
  c.pose_a.translation() *= factor;
  c.pose_b.translation() *= factor;
  return c;
}

/// Whether all posed vertices are doubles.
bool fits(const Polygon& polygon, const Pose& pose) {
  for (const Ring& ring : polygon.rings())
    for (const Vec2& p : ring) {
      const Vec2 quarter = pose.linear() * (p / 4) + pose.translation() / 4;
      if (quarter.lpNorm<Eigen::Infinity>() > kLargest / 4 * (1 - 1e-9)) return false;
    }
  return true;
}

/// Of the points and lengths of all queries; empty if nothing is wrong.
std::string wrongNumbers(const Case& c, bool finite) {
  const auto badPoint = [&](const Vec2& p) { return finite ? !p.allFinite() : p.hasNaN(); };
  for (const Contact& contact : contacts(c.a, c.pose_a, c.b, c.pose_b))
    if (badPoint(contact.point) || !contact.normal.allFinite() || std::isnan(contact.depth)) return "contacts";
  if (const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b)) {
    if (badPoint(p->point_a) || badPoint(p->point_b) || !p->normal.allFinite()) return "penetration's points";
    if (!p->translation.allFinite() || std::isnan(p->depth) || !(p->lower_bound <= p->depth)) return "penetration";
    if (std::isinf(p->depth) && (p->optimal || !p->translation.isZero(0) || p->edge_a >= 0)) return "no penetration";
  }
  const DistanceResult apart = distance(c.a, c.pose_a, c.b, c.pose_b);
  if (badPoint(apart.point_a) || badPoint(apart.point_b) || std::isnan(apart.distance)) return "distance";
  const Motion way = Motion::translation(c.pose_b, Vec2(-c.pose_b.translation() / 4));
  if (const auto impact = timeOfImpact(c.a, Motion::still(c.pose_a), c.b, way))
    if (badPoint(impact->point) || !impact->normal.allFinite() || std::isnan(impact->time)) return "impact";
  return {};
}

TEST(Overflow, NumbersAreFiniteWhereVerticesAreAndNeverNan) {
  int finite = 0, hits = 0, all = 0, wrong = 0;
  for (const Family& family : families()) {
    for (int i = 0; i < scaledCount(60); ++i) {
      Random random(static_cast<std::uint64_t>(i));
      const Case made = family.make(static_cast<std::uint64_t>(i));
      if (!(made.a.radius() > 1e-3 && made.b.radius() > 1e-3 && made.a.radius() + made.b.radius() < 1e4)) continue;
      const Case c = enlarged(random, made);
      const bool is_finite = fits(c.a, c.pose_a) && fits(c.b, c.pose_b);
      finite += is_finite;
      hits += exact::collide(c.a, c.pose_a, c.b, c.pose_b);
      ++all;
      const std::string problem = wrongNumbers(c, is_finite);
      if (!problem.empty() && ++wrong <= 3)
        ADD_FAILURE() << family.name << " seed " << i << ": " << problem << (is_finite ? ", all vertices finite" : "")
                      << "\n"
                      << reproduction(c);
    }
  }
  std::printf("%d cases, %d with finite vertices, %d hits, %d wrong\n", all, finite, hits, wrong);
  EXPECT_EQ(wrong, 0);
  if (all >= 300) {
    EXPECT_GE(finite, 0.2 * all);
    EXPECT_LE(finite, 0.9 * all);
    EXPECT_GE(hits, 0.2 * all);
  }
}

}  // namespace
}  // namespace tricover::support
