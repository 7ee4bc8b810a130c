// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "asked.h"
#include "random.h"
#include "scenes/placed.h"
#include "shapes.h"
#include "tricover/occupancy_grid_io.h"
#include "tricover/tricover.h"

namespace tricover::bench {
namespace {

using support::Random;

constexpr double kTurn = 2 * static_cast<double>(EIGEN_PI);
constexpr std::size_t kQueries = 20000, kDrives = 300;
constexpr int kRounds = 5;

/// Rooms of 8 m with doors, furniture, and walls whose sides have noise, in cells of 5 cm; unknown around them. A robot
/// of 0.5 m meets a fifth of what is there, and a cell side in three has a vertex, as in a depot's map.
OccupancyGrid rooms(std::size_t width, std::size_t height) {
  Random random(width);
  OccupancyGrid grid;
  grid.width = width, grid.height = height, grid.resolution = 0.05;
  grid.cells.assign(width * height, 0);
  const auto fill = [&](int x, int y, int w, int h, std::int8_t value) {
    for (int j = std::max(y, 0); j < std::min(y + h, static_cast<int>(height)); ++j)
      for (int i = std::max(x, 0); i < std::min(x + w, static_cast<int>(width)); ++i)
        grid.cells[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i)] = value;
  };
  const int columns = static_cast<int>(width), rows = static_cast<int>(height), room = 160;
  for (int x = 0; x < columns; x += room)
    for (int y = 0; y < rows; y += room) {
      fill(x, y, room, 3, 100), fill(x, y, 3, room, 100);
      fill(x + random.integer(20, 120), y, 22, 3, 0), fill(x, y + random.integer(20, 120), 3, 22, 0);
      for (int k = random.integer(0, 4); k > 0; --k)
        fill(x + random.integer(5, 150), y + random.integer(5, 150), random.integer(2, 20), random.integer(2, 20), 100);
    }
  const std::vector<std::int8_t> sharp = grid.cells;
  for (std::size_t k = width; k + width < sharp.size(); ++k)
    if ((sharp[k - 1] != sharp[k + 1] || sharp[k - width] != sharp[k + width]) && random.oneIn(12))
      grid.cells[k] = sharp[k] == 0 ? 100 : 0;
  fill(0, 0, columns, 2, -1), fill(0, rows - 2, columns, 2, -1), fill(0, 0, 2, rows, -1),
      fill(columns - 2, 0, 2, rows, -1);
  return grid;
}

struct RobotMap {
  std::string name;
  OccupancyMap map;
};

/// Two made here, and those of the folder that the variable MAPS names.
std::vector<RobotMap> robotMaps() {
  std::vector<RobotMap> maps = {{"rooms, 30 m x 20 m", {rooms(600, 400), Pose::Identity()}},
                                {"rooms, 100 m x 60 m", {rooms(2000, 1200), Pose::Identity()}}};
  const char* folder = std::getenv("MAPS");
  if (folder == nullptr) return maps;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".yaml")
      maps.push_back({entry.path().stem().string(), readOccupancyMap(entry.path().string())});
  return maps;
}

/// Exact: every cell that isn't free is a square, compared with the rectangle along both bodies' axes.
class CellLoop {
 public:
  CellLoop(const OccupancyGrid& grid, double length, double width) : grid_(grid), a_(length / 2), b_(width / 2) {}

  bool meets(const Pose& pose) const {
    const Vec2 c = pose.translation() - grid_.origin, u = pose.linear().col(0), v = pose.linear().col(1);
    const double r = grid_.resolution, x = a_ * std::abs(u.x()) + b_ * std::abs(v.x()),
                 y = a_ * std::abs(u.y()) + b_ * std::abs(v.y());
    const double along_u = a_ + r / 2 * u.lpNorm<1>(), along_v = b_ + r / 2 * v.lpNorm<1>();
    const std::size_t last_row = cell(c.y() + y, grid_.height), last_column = cell(c.x() + x, grid_.width);
    for (std::size_t j = cell(c.y() - y, grid_.height); j <= last_row; ++j)
      for (std::size_t i = cell(c.x() - x, grid_.width); i <= last_column; ++i) {
        if (grid_.cells[j * grid_.width + i] == 0) continue;
        const Vec2 m((static_cast<double>(i) + 0.5) * r - c.x(), (static_cast<double>(j) + 0.5) * r - c.y());
        if (std::abs(m.dot(u)) <= along_u && std::abs(m.dot(v)) <= along_v) return true;
      }
    return false;
  }

 private:
  std::size_t cell(double at, std::size_t count) const {
    return static_cast<std::size_t>(std::clamp(std::floor(at / grid_.resolution), 0.0, static_cast<double>(count) - 1));
  }

  const OccupancyGrid& grid_;
  double a_, b_;
};

/// A robot of two by five quarters of `half`, in a map.
struct Robot {
  Robot(const RobotMap& of, double half)
      : grid(of.map.grid),
        walls(outline(grid).value()),
        shape(Polygon::box(2 * half, 1.25 * half)),
        cells(grid, 2 * half, 1.25 * half) {
    scene.add(walls, Pose::Identity());
  }
  Pose anyPose(Random& random) const {
    const Vec2 size = grid.resolution * Vec2(static_cast<double>(grid.width), static_cast<double>(grid.height));
    const Vec2 at(random.real(0, size.x()), random.real(0, size.y()));
    return poseAt(at, random.real(0, kTurn));
  }
  /// Of `count`, those that are free and within a metre of a wall, or all.
  std::vector<Pose> poses(std::size_t count, bool free_near_walls) const {
    Random random(7);
    std::vector<Pose> poses;
    while (poses.size() < count) {
      const Pose pose = anyPose(random);
      if (!free_near_walls || (!cells.meets(pose) && distanceWithin(walls, Pose::Identity(), shape, pose, 1)))
        poses.push_back(pose);
    }
    return poses;
  }

  const OccupancyGrid& grid;
  Polygon walls, shape;
  CellLoop cells;
  Scene scene;
};

const Pose kStill = Pose::Identity();

Result measurePoses(const std::string& map, const Robot& robot, const std::string& name,
                    const std::vector<Pose>& poses) {
  std::vector<double> by_core(poses.size()), by_scene(poses.size()), by_cells(poses.size());
  Result result = measureInTurn(
      {"robot", map, name, robot.walls.vertexCount(), robot.shape.vertexCount(), poses.size()},
      {taskOf("core", Role::Ours, by_core,
              [&](std::size_t i) { return collide(robot.walls, kStill, robot.shape, poses[i]); }),
       taskOf("scene", Role::Ours, by_scene,
              [&](std::size_t i) { return robot.scene.collides(robot.shape, poses[i]); }),
       taskOf("cells", Role::Rival, by_cells, [&](std::size_t i) { return robot.cells.meets(poses[i]); })},
      kRounds);
  // Cells round: only where they touch within that do they differ.
  std::size_t differ = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) differ += by_core[i] != by_cells[i];
  if (by_core != by_scene || differ > poses.size() / 1000) throw std::runtime_error("robots: answers differ");
  return result;
}

/// Drives of 5 m, which turn on the way.
Result measureDrives(const std::string& map, const Robot& robot, const std::string& name) {
  constexpr double kLength = 5, kStep = 0.02;
  Random random(8);
  std::vector<Motion> drives;
  for (const Pose& pose : robot.poses(kDrives, true)) {
    const double heading = random.real(0, kTurn);
    Motion motion = Motion::translation(pose, kLength * Vec2(std::cos(heading), std::sin(heading)));
    motion.angle = random.real(-2, 2);
    drives.push_back(motion);
  }
  std::vector<double> times(drives.size()), samples(drives.size());
  const Motion still = Motion::still(kStill);
  return measureInTurn({"drive", map, name, robot.walls.vertexCount(), robot.shape.vertexCount(), drives.size()},
                       {taskOf("time of impact", Role::Ours, times,
                               [&](std::size_t i) {
                                 const auto impact = timeOfImpact(robot.walls, still, robot.shape, drives[i]);
                                 return impact ? impact->time : 2;
                               }),
                        taskOf("collide every 2 cm", Role::Rival, samples,
                               [&](std::size_t i) {
                                 for (double at = 0; at <= kLength; at += kStep)
                                   if (collide(robot.walls, kStill, robot.shape, drives[i].at(at / kLength)))
                                     return at / kLength;
                                 return 2.0;
                               })},
                       kRounds);
}

/// The cost, a vertex, of what is derived from a map: a first distance() makes the tree and discs, prepare() the field,
/// too.
Result measureStages(const RobotMap& map) {
  const Polygon walls = outline(map.map.grid).value(), small = Polygon::box(1, 1);
  const auto count = static_cast<double>(walls.vertexCount());
  Result result{{"field", map.name, "made ready, a vertex", walls.vertexCount(), 0, 1}};
  const auto enter = [&](const char* name, auto makeReady) {
    const Polygon fresh(walls.rings(), walls.fillRule());
    const std::size_t before = heapBytes();
    const double start = threadSeconds();
    makeReady(fresh);
    const double seconds = threadSeconds() - start;
    result.timings.push_back({name + std::string(", ns"), Role::Ours, 1e9 * seconds / count});
    const auto bytes = static_cast<double>(heapBytes() - before);
    result.timings.push_back({name + std::string(", bytes"), Role::Ours, bytes / count});
  };
  enter("a first distance", [&](const Polygon& fresh) { distance(fresh, kStill, small, kStill); });
  enter("prepare", [](const Polygon& fresh) { prepare(fresh); });
  return result;
}

}  // namespace

std::vector<Result> measureRobots() {
  std::vector<Result> results;
  for (const RobotMap& map : robotMaps()) {
    results.push_back(measureStages(map));
    for (const double half : {0.25, 0.4, 1.1}) {
      const Robot robot(map, half);
      const std::string size = std::to_string(half).substr(0, 4);
      results.push_back(measurePoses(map.name, robot, "anywhere, " + size + " m", robot.poses(kQueries, false)));
      results.push_back(
          measurePoses(map.name, robot, "free, near a wall, " + size + " m", robot.poses(kQueries, true)));
      results.push_back(measureDrives(map.name, robot, "drives 5 m, " + size + " m"));
    }
  }
  return results;
}

}  // namespace tricover::bench
