// SPDX-License-Identifier: BSD-3-Clause
// A robot that isn't convex drives a route on a map with holes; FCL's broadphase says where it hits what.
// See kUsage.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <tricover/occupancy_grid_io.h>
#include <tricover/outline.h>
#include <tricover/svg.h>
#include <tricover_fcl/tricover_fcl.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "baltic.h"
#include "picture.h"

namespace {

constexpr const char* kUsage =
    R"(usage: robot_in_map [picture.svg]                          a ship on the Baltic, among others at anchor
       robot_in_map picture.svg map.yaml x y x y [x y ..]  a map of ROS's map_server, and a route in its world
)";

struct Obstacle {
  std::shared_ptr<tricover_fcl::PolygonShaped> shape;
  tricover::Pose pose;
  std::size_t kind;  // of World::kinds
};

struct World {
  tricover::Polygon robot;
  std::vector<tricover::Vec2> route;
  double step;                       // from position to position, in units of length
  std::array<const char*, 2> kinds;  // what is said of a position that hits such an obstacle: the first, if both
  std::vector<Obstacle> obstacles;
};

tricover::Pose planarPose(double x, double y, double angle) {
  tricover::Pose pose = tricover::Pose::Identity();
  pose.linear() = Eigen::Rotation2Dd(angle).toRotationMatrix();
  pose.translation() = tricover::Vec2(x, y);
  return pose;
}

World atSea() {
  World world{baltic::ship(),
              {{330, 660}, {40, 300}, {140, 60}, {-10, -300}, {-270, -520}, {-300, -400}, {-430, -120}},
              10,
              {"aground", "in another ship"},
              {}};
  world.obstacles.push_back(
      {std::make_shared<tricover_fcl::PolygonShaped>(baltic::land()), tricover::Pose::Identity(), 0});
  // What is derived from a polygon is shared by all objects that use its shape.
  const auto hull = std::make_shared<tricover_fcl::PolygonShaped>(baltic::ship());
  for (const baltic::Berth& berth : baltic::anchored()) {
    world.obstacles.push_back({hull, planarPose(berth.x, berth.y, berth.angle), 1});
  }
  return world;
}

/// What is occupied and what is unknown are two polygons in the grid's own frame; the map's origin is their pose.
World mapped(const std::string& yaml, std::vector<tricover::Vec2> route) {
  const tricover::OccupancyMap map = tricover::readOccupancyMap(yaml);
  const tricover::Polygon forklift(
      {{{-0.5, -0.3}, {0.6, -0.3}, {0.6, -0.2}, {0, -0.2}, {0, 0.2}, {0.6, 0.2}, {0.6, 0.3}, {-0.5, 0.3}}});  // in
                                                                                                              // metres
  World world{forklift, std::move(route), 0.2, {"in a wall", "in unknown ground"}, {}};
  const std::array<std::int8_t, 2> values = {100, -1};
  for (std::size_t kind = 0; kind < values.size(); ++kind) {
    const std::int8_t wanted = values[kind];
    const auto region = tricover::outline(map.grid, [wanted](std::int8_t value) { return value == wanted; });
    if (region) world.obstacles.push_back({std::make_shared<tricover_fcl::PolygonShaped>(*region), map.pose, kind});
  }
  return world;
}

void place(fcl::CollisionObjectd& object, const tricover::Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear().topLeftCorner<2, 2>() = pose.linear();
  transform.translation().head<2>() = pose.translation();
  object.setTransform(transform);
  object.computeAABB();
}

/// The world's obstacles in FCL's broadphase, which is asked about the robot pose by pose.
class Map {
 public:
  explicit Map(const World& world) : robot_(std::make_shared<tricover_fcl::PolygonShaped>(world.robot)) {
    robot_.setUserData(nullptr);  // FCL leaves it uninitialised
    for (const Obstacle& obstacle : world.obstacles) {
      objects_.push_back(std::make_unique<fcl::CollisionObjectd>(obstacle.shape));
      objects_.back()->setUserData(const_cast<Obstacle*>(&obstacle));
      place(*objects_.back(), obstacle.pose);
      manager_.registerObject(objects_.back().get());
    }
    manager_.setup();
  }

  /// The least kind of what the robot hits there.
  std::optional<std::size_t> hit(const tricover::Pose& pose) {
    place(robot_, pose);
    std::optional<std::size_t> least;
    manager_.collide(&robot_, &least, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
      fcl::CollisionResultd result;
      if (fcl::collide(a, b, fcl::CollisionRequestd(), result) == 0) return false;
      const void* obstacle = a->getUserData() != nullptr ? a->getUserData() : b->getUserData();  // in either order
      const std::size_t kind = static_cast<const Obstacle*>(obstacle)->kind;
      auto& found = *static_cast<std::optional<std::size_t>*>(data);
      if (!found || kind < *found) found = kind;
      return kind == 0;  // there is none below: done
    });
    return least;
  }

 private:
  fcl::CollisionObjectd robot_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

void drive(const World& world, const std::string& picture) {
  tricover::SvgDrawing drawing;
  const std::array<const char*, 2> colours = {"#e7e5e4", "#a8a29e"};
  for (const Obstacle& obstacle : world.obstacles) {
    drawing.polygon(obstacle.shape->polygon(), obstacle.pose, colours[obstacle.kind]);
  }
  Map map(world);
  std::size_t positions = 0;
  std::array<std::size_t, 2> hits = {};
  for (std::size_t leg = 0; leg + 1 < world.route.size(); ++leg) {
    const tricover::Vec2 from = world.route[leg], way = world.route[leg + 1] - from;
    const int steps = static_cast<int>(way.norm() / world.step);
    for (int step = 0; step < steps; ++step) {
      const tricover::Vec2 at = from + way * step / steps;
      const tricover::Pose pose = planarPose(at.x(), at.y(), std::atan2(way.y(), way.x()));
      const std::optional<std::size_t> kind = map.hit(pose);
      positions += 1;
      if (kind) hits[*kind] += 1;
      drawing.polygon(world.robot, pose, kind ? "#dc2626" : "#16a34a");
    }
  }
  std::cout << positions << " positions: " << hits[0] << ' ' << world.kinds[0] << ", " << hits[1] << ' '
            << world.kinds[1] << "\n";
  savePicture(drawing, picture);
}

double finite(const std::string& text) {
  std::istringstream in(text);
  double number = 0;
  if (!(in >> number) || in.get() != EOF || !std::isfinite(number)) {
    throw std::runtime_error("route: '" + text + "' is not a number");
  }
  return number;
}

std::vector<tricover::Vec2> routeFrom(const std::vector<std::string>& numbers) {
  if (numbers.size() < 4 || numbers.size() % 2 != 0) {
    throw std::runtime_error("route: it must be x y of two points or more");
  }
  std::vector<tricover::Vec2> route;
  for (std::size_t i = 0; i < numbers.size(); i += 2) route.emplace_back(finite(numbers[i]), finite(numbers[i + 1]));
  return route;
}

}  // namespace

int main(int argc, char** argv) {
  return runExample(argc, argv, kUsage, "robot_in_map.svg", 1000, [](const std::vector<std::string>& arguments) {
    tricover_fcl::registerNarrowphase();
    drive(arguments.size() > 1 ? mapped(arguments[1], routeFrom({arguments.begin() + 2, arguments.end()})) : atSea(),
          arguments[0]);
    return 0;
  });
}
