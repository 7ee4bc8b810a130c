// SPDX-License-Identifier: BSD-3-Clause
// castRay() and castRayAll() against exact rationals: rays through vertices and along edges, from far away, that end
// where they hit, at every family's polygons, points and segments.
#include "tricover/ray.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "ray_laws.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"

namespace tricover::laws {
namespace {

using namespace support;

std::string wrongOf(const Polygon& polygon, const Pose& pose, const Ray& ray, Tally& tally) {
  if (!ray.from.allFinite() || !ray.to.allFinite()) return {};
  const std::optional<exact::FirstHit> truth = exact::castRay(polygon, pose, ray.from, ray.to);
  const std::optional<RayHit> hit = castRay(polygon, pose, ray.from, ray.to);
  const std::vector<exact::RayPart> parts = exact::castRayAll(polygon, pose, ray.from, ray.to);
  tally.count("misses", !truth);
  tally.count("starts inside", truth && truth->edge < 0);
  tally.count("hits", truth && truth->edge >= 0);
  tally.count("several parts or touches",
              parts.size() > 1 || (parts.size() == 1 && parts[0].begin.fraction == parts[0].end.fraction));
  std::string wrong;
  if (hit.has_value() != truth.has_value())
    wrong = "hit or not";
  else if (collide(polygon, pose, Polygon::segment(ray.from, ray.to), Pose::Identity()) != hit.has_value())
    wrong = "collide";
  else if (hit)
    wrong = wrongHit(polygon, pose, ray, *hit, *truth);
  if (wrong.empty()) {
    wrong = wrongIntervals(polygon, pose, ray, castRayAll(polygon, pose, ray.from, ray.to), parts);
    if (!wrong.empty()) wrong = "castRayAll: " + wrong;
  }
  if (wrong.empty()) return wrong;
  return wrong + ", hit " + std::to_string(hit ? hit->edge : -2) + " at " + hex(hit ? hit->fraction : -1) + ", truth " +
         std::to_string(truth ? truth->edge : -2) + " at " + hex(truth ? truth->fraction.get_d() : -1) +
         ", the ray is b's edge 0\n" +
         reproduction({polygon, pose, Polygon::segment(ray.from, ray.to), Pose::Identity()});
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  std::string problem;
  for (int k = 0; k < 4 && problem.empty(); ++k) {
    problem = wrongOf(c.a, c.pose_a, anyRay(random, c.a, c.pose_a), tally);
    if (problem.empty()) problem = wrongOf(c.b, c.pose_b, anyRay(random, c.b, c.pose_b), tally);
  }
  return problem;
}

/// At points, segments and rings without area, under poses of all kinds.
std::string wrongAtThin(Random& random, Tally& tally) {
  const auto grid = [&] { return Vec2(random.integer(-3, 3), random.integer(-3, 3)); };
  const Vec2 p = grid(), q = grid();
  const int kind = random.integer(0, 2);
  const Polygon polygon = kind == 0   ? Polygon::point(p)
                          : kind == 1 ? Polygon::segment(p, q)
                                      : Polygon({{p, q, p, grid()}, {p, p, q}});
  Pose placed =
      random.coin() ? Pose::Identity() : turnedAndMoved(random.integer(0, 3) * M_PI / 2, random.integer(-2, 2), 1);
  if (random.oneIn(3)) placed = mirrored(distorted(random, placed));
  const Vec2 through = placed * (random.coin() ? p : q), from = random.oneIn(5) ? through : placed * grid();
  const double beyond = random.integer(0, 4) / 2.0;
  return wrongOf(polygon, placed, {from, from + beyond * (placed * q - from)}, tally);
}

/// The first interval begins with castRay()'s hit, and ends lie where the grown region ends.
std::string wrongWithMargin(Random& random, Tally& tally) {
  const Polygon polygon({star(random, random.integer(3, 40), 0.2, 1)});
  const Pose placed = randomPose(random, 1);
  const Vec2 from(random.real(-3, 3), random.real(-3, 3)), to(random.real(-3, 3), random.real(-3, 3));
  const double margin = random.real(0.01, 0.3);
  const auto parts = castRayAll(polygon, placed, from, to, {margin});
  const auto first = castRay(polygon, placed, from, to, {margin});
  tally.count("hits", first.has_value());
  tally.count("several", parts.size() > 1);
  if (first.has_value() == parts.empty()) return "hit or not";
  if (first && (first->fraction != parts[0].begin.fraction || first->normal != parts[0].begin.normal ||
                first->edge != parts[0].begin.edge))
    return "the first begin";
  const auto isWithin = [&](const Vec2& p, double by) {
    return collide(Polygon::point(p), Pose::Identity(), polygon, placed, {margin + by, 0});
  };
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const RayHit &begin = parts[k].begin, &end = parts[k].end;
    for (const RayHit* hit : {&begin, &end})
      if (!isWithin(hit->point, 1e-12) || (hit->edge >= 0 && isWithin(hit->point, -1e-12))) return "an end";
    if (!isWithin(0.5 * (begin.point + end.point), 1e-12)) return "a part's middle";
    if (k > 0 && isWithin(0.5 * (parts[k - 1].end.point + begin.point), -1e-12)) return "between two parts";
  }
  return {};
}

Laws rayLaws() {
  const Shares shares = {
      {"misses", 0.05, 0.9}, {"starts inside", 0.05, 0.9}, {"hits", 0.05, 0.9}, {"several parts or touches", 0.01, 1}};
  Laws laws = {{"thin", 1500, wrongAtThin, shares},
               {"margins", 300, wrongWithMargin, {{"hits", 0.2, 0.9}, {"several", 0.03, 0.9}}}};
  add(laws, families(), 300, wrong, shares);
  add(laws, anyPairs(), 150, wrong, {{"misses", 0.02, 0.98}});
  return laws;
}

const Register registered("ray", rayLaws);

}  // namespace
}  // namespace tricover::laws
