// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>
#include <utility>

#include "asked.h"
#include "random.h"
#include "scenes/placed.h"
#include "shapes.h"
#include "tricover/tricover.h"

namespace tricover::bench {
namespace {

constexpr double kCell = 0.05;  ///< metres; the robot has 0.6 x 0.4
constexpr std::size_t kQueries = 2000;
constexpr int kRounds = 3;

/// The outline of the cells of a square that are occupied.
template <typename IsOccupiedAt>
Polygon mapOf(std::size_t side, const IsOccupiedAt& isOccupiedAt) {
  support::Random random(side);
  OccupancyGrid grid;
  grid.width = grid.height = side;
  grid.resolution = kCell;
  for (std::size_t i = 0; i < side * side; ++i) grid.cells.push_back(isOccupiedAt(i % side, i / side, random) ? 1 : 0);
  const auto map = outline(grid);
  if (!map) throw std::runtime_error("islands: an empty map");
  return *map;
}

/// One cell in two hundred is occupied, however large the map.
Polygon speckled(std::size_t side) {
  return mapOf(side, [](std::size_t, std::size_t, support::Random& random) { return random.oneIn(200); });
}

struct Map {
  Polygon polygon;
  Scene scene;
  double size;

  explicit Map(std::size_t side) : polygon(speckled(side)), size(kCell * static_cast<double>(side)) {
    prepare(polygon);  // otherwise thousands of queries run before the tree is paid for
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
     [](Scene& map, const Pose& pose) { return map.collides(Polygon::point(pose.translation()), kStill); }},
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
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < kQueries; ++i) {
    const double angle = random.real(0, 6.3);
    poses.push_back(poseAt(Vec2(random.real(0, size), random.real(0, size)), angle));
  }
  return poses;
}

}  // namespace

std::vector<Result> measureSimplification() {
  using support::Random;
  // Racks in aisles, whose sides have noise, as a scanner's map has.
  const auto isRack = [](std::size_t x, std::size_t y, Random& random) {
    return x % 40 < 30 && y % 16 < (random.oneIn(8) ? 7u : 6u);
  };
  const auto isNoise = [](std::size_t, std::size_t, Random& random) { return random.coin(); };
  const std::pair<const char*, Polygon> maps[] = {{"racks", mapOf(600, isRack)},
                                                  {"noise", mapOf(100, isNoise)},
                                                  {"a comb", Polygon({support::comb(1024, 0.2, 0.1, 1)})}};
  std::vector<Result> results;
  for (const auto& [name, map] : maps) {
    results.push_back({{"simplify", name, "outwards, a vertex", map.vertexCount(), 0, 1}});
    for (const int cells : {1, 2}) {
      const double start = threadSeconds();
      map.simplified(cells * kCell, Simplify::Outwards);
      const double seconds = threadSeconds() - start;
      results.back().timings.push_back({"by " + std::to_string(cells) + " cells", Role::Ours,
                                        1e9 * seconds / static_cast<double>(map.vertexCount())});
    }
  }
  return results;
}

std::vector<Result> measureIslands() {
  std::vector<Result> results;
  for (const std::size_t side : {500u, 1000u, 2000u, 4000u}) {
    Map map(side);
    const std::vector<Pose> poses = anyPoses(map.size);
    for (const Query& query : kAsked) {
      std::vector<double> of_polygon(kQueries), of_scene(kQueries);
      results.push_back(measureInTurn(
          {"islands", "islands", query.name, map.polygon.rings().size(), 4, kQueries},
          {taskOf("one polygon", Role::Ours, of_polygon,
                  [&](std::size_t i) { return query.of_polygon(map.polygon, poses[i]); }),
           taskOf("Scene", Role::Rival, of_scene, [&](std::size_t i) { return query.of_scene(map.scene, poses[i]); })},
          kRounds));
      if (of_polygon != of_scene)
        throw std::runtime_error(std::string("islands: polygon and scene differ: ") + query.name);
    }
  }
  return results;
}

}  // namespace tricover::bench
