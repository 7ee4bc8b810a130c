// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "maps.h"
#include "rivals/boost_tree.h"
#include "rivals/box2d_scene.h"
#include "scene_studies.h"
#include "tricover/ray.h"
#include "tricover/scene.h"

namespace tricover::bench {
namespace {

class SceneRays {
 public:
  SceneRays(const Placement& placement, std::vector<Ray> rays) : rays_(std::move(rays)) {
    for (const Placed& placed : placement) scene_.add(placed.polygon, placed.pose);
  }
  double value(std::size_t i) const {
    const auto hit = scene_.castRay(rays_[i].first, rays_[i].second);
    return hit ? hit->hit.fraction : std::numeric_limits<double>::infinity();
  }

 private:
  Scene scene_;
  std::vector<Ray> rays_;
};

/// castRay() of every body whose bounding disc the ray comes near.
class ScanRays {
 public:
  ScanRays(Placement placement, std::vector<Ray> rays) : placement_(std::move(placement)), rays_(std::move(rays)) {}
  double value(std::size_t i) const {
    const auto& [from, to] = rays_[i];
    const Vec2 way = to - from;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [polygon, pose] : placement_) {
      const Vec2 centre = pose * polygon.origin();
      const double along = std::clamp(way.dot(centre - from) / way.squaredNorm(), 0.0, 1.0);
      const double reach = (1 + 1e-9) * polygon.radius() + 1e-9 * centre.norm();
      if ((from + along * way - centre).squaredNorm() > reach * reach) continue;
      if (const auto hit = castRay(polygon, pose, from, to)) nearest = std::min(nearest, hit->fraction);
    }
    return nearest;
  }

 private:
  Placement placement_;
  std::vector<Ray> rays_;
};

}  // namespace

std::vector<Result> measureRays(const Countries& countries, const Settings& settings) {
  constexpr std::size_t kPlaces = 10;
  constexpr double kLength = 1000;
  // Floats know a map of 10,000 units to a thousandth.
  constexpr Agreement kFractions = {1, {1e-12, 1e-12}, {1e-4, 1e-4}};
  const Polygon robot = forkLift();
  std::vector<Result> results;
  for (const auto& [name, bodies] : allMaps(countries)) {
    const std::vector<Ray> rays = raysAround(bodies, robot, kPlaces, kLength, 5);
    std::vector<ValueContender> contenders;
    const auto add = [&](const std::string& title, Role role, auto method) {
      contenders.push_back(contender<Values>(title, role, false, method, rays.size()));
    };
    add("cold", Role::Ours, std::make_shared<ScanRays>(bodies, rays));
    add("scene", Role::Ours, std::make_shared<SceneRays>(bodies, rays));
    add("Box2D", Role::Rival, std::make_shared<Box2dRays>(bodies, rays));
    add("Boost rtree", Role::Rival, std::make_shared<BoostRays>(bodies, rays));
    results.push_back(
        measure({"rays", name, "rays", vertexCount(bodies), 2, rays.size(), 1}, contenders, kFractions, settings));
  }
  return results;
}

}  // namespace tricover::bench
