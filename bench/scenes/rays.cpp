// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "maps.h"
#include "rivals/boost.h"
#include "rivals/box2d_scene.h"
#include "scene_studies.h"
#include "tricover/ray.h"
#include "tricover/scene.h"

namespace tricover::bench {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

/// castRay() of every body whose bounding disc the ray comes near.
double byScan(const Placement& placement, const Ray& ray) {
  const auto& [from, to] = ray;
  const Vec2 way = to - from;
  double nearest = kNothing;
  for (const auto& [polygon, pose] : placement) {
    const Vec2 centre = pose * polygon.coveringOrigin();
    const double along = std::clamp(way.dot(centre - from) / way.squaredNorm(), 0.0, 1.0);
    const double reach = (1 + 1e-9) * polygon.radius() + 1e-9 * centre.norm();
    if ((from + along * way - centre).squaredNorm() > reach * reach) continue;
    if (const auto hit = castRay(polygon, pose, from, to)) nearest = std::min(nearest, hit->fraction);
  }
  return nearest;
}

}  // namespace

std::vector<Result> measureRays(const Countries& countries, Settings settings) {
  constexpr std::size_t kPlaces = 10;
  constexpr double kLength = 1000;
  // Floats know a map of 10,000 units to a thousandth.
  settings.agreement = {1, {1e-12, 1e-12}, {1e-4, 1e-4}};
  const Polygon robot = forkLift();
  std::vector<Result> results;
  for (const NamedMap& map : allMaps(countries)) {
    const Placement& bodies = map.bodies;
    const std::vector<Ray> rays = raysAround(bodies, robot, kPlaces, kLength, 5);
    const Scene scene = sceneOf(bodies);
    const auto byScene = [&](std::size_t i) {
      const auto hit = scene.castRay(rays[i].first, rays[i].second);
      return hit ? hit->hit.fraction : kNothing;
    };
    const auto cold = [&](std::size_t i) { return byScan(bodies, rays[i]); };
    const std::size_t n = rays.size();
    const std::vector<ValueContender> contenders = {
        contender<Values>("cold", Role::Ours, false, n, cold),
        contender<Values>("scene", Role::Ours, false, n, byScene),
        contenderOf<Values>("Box2D", Role::Rival, false, n, std::make_shared<Box2dRays>(bodies, rays)),
        contenderOf<Values>("Boost rtree", Role::Rival, false, n, std::make_shared<BoostRays>(bodies, rays))};
    results.push_back(measure({"rays", map.name, "rays", vertexCount(bodies), 2, rays.size()}, contenders, settings));
  }
  return results;
}

}  // namespace tricover::bench
