// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <stdexcept>

#include "asked.h"
#include "random.h"
#include "rivals/boost.h"
#include "shapes.h"
#include "tricover/polygon.h"
#include "tricover/scene.h"

namespace tricover::bench {
namespace {

/// Bodies of unit radius, so dense that a point of the plane is in a third of a body.
class Places {
 public:
  Places(std::size_t bodies, std::uint64_t seed) : side_(3 * std::sqrt(static_cast<double>(bodies))), random_(seed) {}
  Pose next() { return poseAt({random_.real(0, side_), random_.real(0, side_)}, random_.real(0, 6)); }

 private:
  double side_;
  support::Random random_;
};

Polygon octagon() { return Polygon({support::regular(8, 1)}); }

class SceneMap {
 public:
  explicit SceneMap(std::size_t bodies) {
    Places places(bodies, 1);
    std::vector<BodyPlacement> all;
    all.reserve(bodies);
    for (std::size_t i = 0; i < bodies; ++i) all.push_back({octagon(), places.next(), {}});
    scene_.add(all);
  }
  bool collides(const Polygon& polygon, const Pose& pose) const { return scene_.collides(polygon, pose); }
  double distance(const Polygon& polygon, const Pose& pose) const {
    return scene_.nearest(polygon, pose)->result.distance;
  }

 private:
  Scene scene_;
};

class TreeMap : public BoostMap {
 public:
  explicit TreeMap(std::size_t bodies) : BoostMap(placementOf(bodies)) {}

 private:
  static Placement placementOf(std::size_t bodies) {
    Places places(bodies, 1);
    Placement all;
    all.reserve(bodies);
    for (std::size_t i = 0; i < bodies; ++i) all.push_back({octagon(), places.next()});
    return all;
  }
};

/// The results of costOf(), all in ns but the first.
constexpr const char* kFigures[] = {"bytes a body", "made and added", "collides", "nearest to a hexagon",
                                    "nearest to a point"};

/// `answers`: all of them added up, the same of all methods.
template <class Map>
std::array<double, 5> costOf(std::size_t bodies, double& answers) {
  constexpr std::size_t kQueries = 20000;
  const Polygon hexagon({support::regular(6, 1)}), dot = Polygon::point({0, 0});
  Places places(bodies, 2);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < kQueries; ++i) poses.push_back(places.next());

  const std::size_t before = heapBytes();
  const double start = threadSeconds();
  const Map map(bodies);
  answers += map.collides(hexagon, poses[0]) ? 1 : 0;
  const auto count = static_cast<double>(bodies);
  const double build_ns = 1e9 * (threadSeconds() - start) / count;
  const double bytes = static_cast<double>(heapBytes() - before) / count;
  const auto nsOf = [&](auto ask) {
    const double from = threadSeconds();
    for (const Pose& pose : poses) answers += ask(pose);
    return 1e9 * (threadSeconds() - from) / static_cast<double>(kQueries);
  };
  const auto collides = [&](const Pose& pose) { return map.collides(hexagon, pose) ? 1.0 : 0.0; };
  nsOf(collides);  // the first queries find cold caches
  return {bytes, build_ns, nsOf(collides), nsOf([&](const Pose& pose) { return map.distance(hexagon, pose); }),
          nsOf([&](const Pose& pose) { return map.distance(dot, pose); })};
}

}  // namespace

std::vector<Result> measureStillMaps() {
  std::vector<Result> results;
  for (const std::size_t bodies : {10000u, 1000000u}) {
    double of_scene = 0, of_tree = 0;
    const auto scene = costOf<SceneMap>(bodies, of_scene), tree = costOf<TreeMap>(bodies, of_tree);
    if (std::abs(of_scene - of_tree) > 1e-9 * of_tree)
      throw std::logic_error("still maps: the scene and the rtree give different answers");
    for (std::size_t i = 0; i < scene.size(); ++i)
      results.push_back({{"still map", std::to_string(bodies) + " 8-gons", kFigures[i]},
                         {{"scene", Role::Ours, scene[i]}, {"Boost rtree", Role::Rival, tree[i]}}});
  }
  return results;
}

}  // namespace tricover::bench
