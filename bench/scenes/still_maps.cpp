// SPDX-License-Identifier: BSD-3-Clause
#include "still_maps.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "measure.h"
#include "random.h"
#include "report.h"
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

/// Nanoseconds a query over these poses, and what they answered in all.
template <class Ask>
double nsOf(const std::vector<Pose>& poses, double& sum, Ask ask) {
  const double start = threadSeconds();
  for (const Pose& pose : poses) sum += ask(pose);
  return 1e9 * (threadSeconds() - start) / static_cast<double>(poses.size());
}

template <class Map>
StillMapCost costOf(const std::string& method, std::size_t bodies) {
  constexpr std::size_t kQueries = 20000;
  const Polygon hexagon = regular(6, 1), dot = point({0, 0});
  Places places(bodies, 2);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < kQueries; ++i) poses.push_back(places.next());

  StillMapCost cost{method, bodies, 0, 0, 0, 0, 0, 0, 0};
  const std::size_t before = heapBytes();
  const double start = threadSeconds();
  const Map map(bodies);
  cost.answers += map.collides(hexagon, poses[0]) ? 1 : 0;
  const auto count = static_cast<double>(bodies);
  cost.build_ns = 1e9 * (threadSeconds() - start) / count;
  cost.bytes = static_cast<double>(heapBytes() - before) / count;
  const auto collides = [&](const Pose& pose) { return map.collides(hexagon, pose) ? 1.0 : 0.0; };
  cost.first_ns = nsOf(poses, cost.answers, collides);
  cost.collides_ns = nsOf(poses, cost.answers, collides);
  cost.hexagon_ns = nsOf(poses, cost.answers, [&](const Pose& pose) { return map.distance(hexagon, pose); });
  cost.point_ns = nsOf(poses, cost.answers, [&](const Pose& pose) { return map.distance(dot, pose); });
  return cost;
}

}  // namespace

std::vector<StillMapCost> measureStillMaps(std::size_t most) {
  std::vector<StillMapCost> costs;
  for (const std::size_t bodies : {std::size_t{10000}, most}) {
    costs.push_back(costOf<SceneMap>("scene", bodies));
    costs.push_back(costOf<TreeMap>("Boost rtree and our pairs", bodies));
  }
  return costs;
}

std::vector<Target> judgeStillMaps(const std::vector<StillMapCost>& costs) {
  std::vector<Figure> bytes, builds, collides, nearest;
  for (std::size_t i = 0; i + 1 < costs.size(); i += 2) {
    const StillMapCost &scene = costs[i], &tree = costs[i + 1];
    const std::string cell = std::to_string(scene.bodies) + " 8-gons";
    bytes.push_back({scene.bytes, cell});
    builds.push_back({scene.build_ns, cell});
    collides.push_back({tree.collides_ns / scene.collides_ns, cell});
    nearest.push_back({tree.hexagon_ns / scene.hexagon_ns, cell + ", hexagon"});
    nearest.push_back({tree.point_ns / scene.point_ns, cell + ", point"});
  }
  const std::string subject = "a still map", compared = "Boost rtree and our pairs / scene";
  return {judged(subject, "bytes a body, its polygon included", bytes, {false, 640, 0, "bytes"}),
          judged(subject, "a body made and added", builds, {false, 1000, 0, "ns"}),
          judged(subject + ", collides", compared, collides, {true, 1}),
          judged(subject + ", nearest", compared, nearest, {true, 1.2})};
}

std::vector<NearestCost> measureNearest() {
  constexpr std::size_t kBodies = 10000, kPoses = 4000;
  constexpr int kRounds = 7;
  const Scene scene = sceneOf(kBodies);
  const Polygon hexagon = regular(6, 1), dot = point({0, 0});
  std::vector<NearestCost> costs;
  for (const double step : {kInfinity, 0.2, 0.02}) {
    Places places(kBodies, 2);
    std::vector<Pose> poses = {places.next()};
    while (poses.size() < kPoses) {
      const Pose jump = places.next();
      poses.push_back(step < kInfinity ? poses.back() * poseAt({step, 0}, step * jump.linear()(0, 0)) : jump);
    }
    for (const Polygon* polygon : {&hexagon, &dot}) {
      double none = 0, cached = 0;
      SceneCache cache;
      const auto ask = [&](double& sum, auto&... kept) {
        for (const Pose& pose : poses) sum += scene.nearest(*polygon, pose, kept...)->result.distance;
      };
      const std::vector<std::function<void()>> tasks = {[&] { ask(none); }, [&] { ask(cached, cache); }};
      const std::vector<double> seconds = secondsInTurn(tasks, kRounds, threadSeconds);
      const std::string walk = step < kInfinity ? "steps of " + shortNumber(step) : "jumps";
      costs.push_back({(polygon == &hexagon ? "hexagon, " : "point, ") + walk, 1e9 * seconds[0] / kPoses,
                       1e9 * seconds[1] / kPoses});
      if (none != cached) throw std::logic_error("a cache changed the nearest body's distance");
    }
  }
  return costs;
}

std::vector<Target> judgeNearest(const std::vector<NearestCost>& costs) {
  std::vector<Figure> figures;
  for (const NearestCost& cost : costs) figures.push_back({cost.cached_ns / cost.none_ns, cost.walk});
  return {judged("the nearest of 10000 bodies", "with a SceneCache / without", figures, {false, 1.05})};
}

}  // namespace tricover::bench
