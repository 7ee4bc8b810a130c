// SPDX-License-Identifier: BSD-3-Clause
// Where sums of coordinates overflow, points and lengths are finite if all posed vertices are, and never NaN.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "contact_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "shapes.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"

namespace tricover::laws {
namespace {

using namespace support;

constexpr double kLargest = std::numeric_limits<double>::max();

/// The same with its largest coordinate near the largest double.
Case enlarged(Random& random, Case c) {
  double most =
      std::max(c.pose_a.translation().lpNorm<Eigen::Infinity>(), c.pose_b.translation().lpNorm<Eigen::Infinity>());
  for (const Polygon* polygon : {&c.a, &c.b})
    for (const Ring& ring : polygon->rings())
      for (const Vec2& p : ring) most = std::max(most, p.lpNorm<Eigen::Infinity>());
  const double factor = kLargest / std::max(most, 1.0) * (random.coin() ? 1 - 1e-9 : random.real(0.01, 1));
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
  for (const Contact& contact : contacts(c.a, c.pose_a, c.b, c.pose_b, globally()))
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

std::string wrong(Random& random, Tally& tally, Case& c) {
  if (!(smallerRadius(c) > 1e-3 && c.a.radius() + c.b.radius() < 1e4)) return {};
  c = enlarged(random, c);
  const bool is_finite = fits(c.a, c.pose_a) && fits(c.b, c.pose_b);
  tally.count("finite", is_finite);
  tally.count("hits", Reference(c).collide());
  const std::string problem = wrongNumbers(c, is_finite);
  return problem.empty() || !is_finite ? problem : problem + ", all vertices finite";
}

Case anyOfAllFamilies(Random& random) { return families()[random.bits() % families().size()].make(random.bits()); }

Laws overflowLaws() {
  Limits limits;
  limits.most_exponent = 3;
  Laws laws;
  add(laws, {family("families", anyOfAllFamilies)}, 2000, wrong, {{"finite", 0.2, 0.9}, {"hits", 0.2, 0.9}});
  add(laws, anyPairs(limits), 60, wrong, {{"finite", 0.02, 0.98}});
  return laws;
}

const Register registered("overflow", overflowLaws);

}  // namespace
}  // namespace tricover::laws
