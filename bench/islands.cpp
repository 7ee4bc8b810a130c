// SPDX-License-Identifier: BSD-3-Clause
#include "islands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include "measure.h"
#include "random.h"
#include "tricover/tricover.h"

namespace tricover::bench {
namespace {

constexpr double kCell = 0.05;  ///< metres; the robot has 0.6 x 0.4
constexpr std::size_t kQueries = 2000;
constexpr int kRounds = 3;

/// One cell in two hundred is occupied, however large the map.
Polygon speckled(std::size_t side) {
  support::Random random(side);
  OccupancyGrid grid;
  grid.width = grid.height = side;
  grid.resolution = kCell;
  grid.cells.resize(side * side);
  for (std::int8_t& cell : grid.cells) cell = random.oneIn(200) ? 1 : 0;
  const auto map = outline(grid);
  if (!map) throw std::runtime_error("islands: an empty map");
  return *map;
}

struct Map {
  Polygon polygon;
  Scene scene;
  double size;

  explicit Map(std::size_t side) : polygon(speckled(side)), size(kCell * static_cast<double>(side)) {
    prepare(polygon);  // otherwise thousands of queries do without what they pay for
    for (const Ring& ring : polygon.rings()) scene.add(Polygon({ring}), Pose::Identity());
  }
};

struct Query {
  const char* name;
  bool (*of_polygon)(const Polygon& map, const Pose& pose);
  bool (*of_scene)(Scene& map, const Pose& pose);
};

const Polygon& robot() {
  static const Polygon robot({{{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}}});
  return robot;
}

const Pose kStill = Pose::Identity();

Vec2 tenAhead(const Pose& pose) { return pose * Vec2(10, 0); }

constexpr Query kAsked[] = {
    {"collide", [](const Polygon& map, const Pose& pose) { return collide(map, kStill, robot(), pose); },
     [](Scene& map, const Pose& pose) { return map.collides(robot(), pose); }},
    {"locate",
     [](const Polygon& map, const Pose& pose) { return locate(map, pose.translation()) != Location::Outside; },
     [](Scene& map, const Pose& pose) { return map.collides(point(pose.translation()), kStill); }},
    {"distance",
     [](const Polygon& map, const Pose& pose) { return distance(map, kStill, robot(), pose).distance == 0; },
     [](Scene& map, const Pose& pose) { return map.nearest(robot(), pose)->result.distance == 0; }},
    {"ray of 10 m",
     [](const Polygon& map, const Pose& pose) {
       return castRay(map, kStill, pose.translation(), tenAhead(pose)).has_value();
     },
     [](Scene& map, const Pose& pose) { return map.castRay(pose.translation(), tenAhead(pose)).has_value(); }},
};

std::vector<Pose> anyPoses(double size) {
  support::Random random(5);
  std::vector<Pose> poses(kQueries, Pose::Identity());
  for (Pose& pose : poses) {
    pose.linear() = Eigen::Rotation2Dd(random.real(0, 6.3)).toRotationMatrix();
    pose.translation() = Vec2(random.real(0, size), random.real(0, size));
  }
  return poses;
}

/// Milliseconds of the dearest, on a polygon that is prepared and that nobody has asked yet; of two such the cheaper.
double dearest(const Polygon& map, const Query& query, const std::vector<Pose>& poses) {
  double least = 1e9;
  for (int round = 0; round < 2; ++round) {
    const Polygon fresh(map.rings());
    prepare(fresh);
    double most = 0;
    for (const Pose& pose : poses) {
      const double start = threadSeconds();
      query.of_polygon(fresh, pose);
      most = std::max(most, 1e3 * (threadSeconds() - start));
    }
    least = std::min(least, most);
  }
  return least;
}

}  // namespace

std::vector<IslandCost> measureIslands() {
  std::vector<IslandCost> costs;
  for (const std::size_t side : {500u, 1000u, 2000u, 4000u}) {
    Map map(side);
    const std::vector<Pose> poses = anyPoses(map.size);
    for (const Query& query : kAsked) {
      std::size_t of_polygon = 0, of_scene = 0;
      const std::vector<std::function<void()>> tasks = {[&] {
                                                          of_polygon = 0;
                                                          for (const Pose& pose : poses)
                                                            of_polygon += query.of_polygon(map.polygon, pose);
                                                        },
                                                        [&] {
                                                          of_scene = 0;
                                                          for (const Pose& pose : poses)
                                                            of_scene += query.of_scene(map.scene, pose);
                                                        }};
      const std::vector<double> seconds = secondsInTurn(tasks, kRounds, threadSeconds);
      if (of_polygon != of_scene)
        throw std::runtime_error(std::string("islands: polygon and scene differ: ") + query.name);
      costs.push_back({map.polygon.rings().size(), query.name, 1e9 * seconds[0] / kQueries, 1e9 * seconds[1] / kQueries,
                       dearest(map.polygon, query, poses)});
    }
  }
  return costs;
}

std::vector<Target> judgeIslands(const std::vector<IslandCost>& costs) {
  std::vector<Figure> times, growth, dearest_of;
  std::map<std::string, const IslandCost*> first, last;
  for (const IslandCost& cost : costs) {
    const std::string cell = std::to_string(cost.islands) + " islands, " + cost.query;
    times.push_back({cost.polygon_ns / cost.scene_ns, cell});
    dearest_of.push_back({cost.dearest_ms, cell});
    first.emplace(cost.query, &cost);
    last[cost.query] = &cost;
  }
  for (const auto& [query, large] : last) {
    const IslandCost& small = *first.at(query);
    const double more = static_cast<double>(large->islands) / static_cast<double>(small.islands);
    growth.push_back({std::log(large->polygon_ns / small.polygon_ns) / std::log(more), query});
  }
  return {judged("a map of islands", "one polygon / a Scene", times, {false, 2}),
          judged("a map of islands", "power of their number", growth, {false, 0.25, 0, ""}),
          judged("a map of islands", "the dearest query, prepared", dearest_of, {false, 1, 0, "ms"})};
}

}  // namespace tricover::bench
