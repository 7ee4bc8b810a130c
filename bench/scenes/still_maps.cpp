// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "asked.h"
#include "placed.h"
#include "random.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/scene.h"
#include "tricover/segment.h"

namespace tricover::bench {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using Point = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Tree = bgi::rtree<std::pair<Box, std::uint32_t>, bgi::rstar<16>>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Polygon regular(int vertices, double radius) {
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * static_cast<double>(EIGEN_PI) * i / vertices;
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return Polygon({ring});
}

Box boxOf(const Polygon& polygon, const Pose& pose) {
  const Eigen::AlignedBox2d box = boundsOf(polygon, pose);
  return {{box.min().x(), box.min().y()}, {box.max().x(), box.max().y()}};
}

/// Bodies of unit radius, so dense that a point of the plane is in a third of a body.
class Places {
 public:
  Places(std::size_t bodies, std::uint64_t seed) : side_(3 * std::sqrt(static_cast<double>(bodies))), random_(seed) {}
  Pose next() { return poseAt({random_.real(0, side_), random_.real(0, side_)}, random_.real(0, 6)); }

 private:
  double side_;
  support::Random random_;
};

Scene sceneOf(std::size_t bodies) {
  Places places(bodies, 1);
  std::vector<BodyPlacement> all;
  all.reserve(bodies);
  for (std::size_t i = 0; i < bodies; ++i) all.push_back({regular(8, 1), places.next(), {}});
  Scene scene;
  scene.add(all);
  return scene;
}

class SceneMap {
 public:
  explicit SceneMap(std::size_t bodies) : scene_(sceneOf(bodies)) {}
  bool collides(const Polygon& polygon, const Pose& pose) const { return scene_.collides(polygon, pose); }
  double distance(const Polygon& polygon, const Pose& pose) const {
    return scene_.nearest(polygon, pose)->result.distance;
  }

 private:
  Scene scene_;
};

/// boost::geometry's R-tree of the bodies' boxes, packed, and our own collide() and distance().
class TreeMap {
 public:
  explicit TreeMap(std::size_t bodies) {
    Places places(bodies, 1);
    bodies_.reserve(bodies);
    std::vector<std::pair<Box, std::uint32_t>> boxes;
    boxes.reserve(bodies);
    for (std::uint32_t i = 0; i < bodies; ++i) {
      bodies_.push_back({regular(8, 1), places.next()});
      boxes.push_back({boxOf(bodies_[i].polygon, bodies_[i].pose), i});
    }
    tree_ = Tree(boxes);
  }
  bool collides(const Polygon& polygon, const Pose& pose) const {
    for (auto at = tree_.qbegin(bgi::intersects(boxOf(polygon, pose))); at != tree_.qend(); ++at)
      if (tricover::collide(bodies_[at->second].polygon, bodies_[at->second].pose, polygon, pose)) return true;
    return false;
  }
  double distance(const Polygon& polygon, const Pose& pose) const {
    const Box box = boxOf(polygon, pose);
    double least = kInfinity, reach = -1;
    // As many nearest boxes as it takes: going on one by one, the tree sorts all of them again and again.
    for (unsigned count = 4; reach <= least && count < 2 * bodies_.size(); count *= 4) {
      double farthest = 0;
      for (auto at = tree_.qbegin(bgi::nearest(box, count)); at != tree_.qend(); ++at) {
        const double gap = bg::distance(box, at->first);
        farthest = std::max(farthest, gap);
        if (gap < reach || gap > least) continue;
        const Placed& body = bodies_[at->second];
        if (const auto found = distanceWithin(polygon, pose, body.polygon, body.pose, least)) least = found->distance;
      }
      if (farthest > least) break;
      reach = farthest;
    }
    return least;
  }

 private:
  Placement bodies_;
  Tree tree_;
};

/// The results of costOf(), all in ns but the first.
constexpr const char* kFigures[] = {"bytes a body", "made and added", "collides", "nearest to a hexagon",
                                    "nearest to a point"};

/// `answers`: all of them added up, the same of all methods.
template <class Map>
std::array<double, 5> costOf(std::size_t bodies, double& answers) {
  constexpr std::size_t kQueries = 20000;
  const Polygon hexagon = regular(6, 1), dot = point({0, 0});
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
      results.push_back({{"still map", std::to_string(bodies) + " 8-gons", kFigures[i], 0, 0, 1, 1},
                         0,
                         {{"scene", Role::Ours, scene[i], 0, 0, 0}, {"Boost rtree", Role::Rival, tree[i], 0, 0, 0}}});
  }
  return results;
}

}  // namespace tricover::bench
