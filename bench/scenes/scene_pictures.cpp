// SPDX-License-Identifier: BSD-3-Clause
#include "scene_pictures.h"

#include <cmath>
#include <memory>
#include <set>
#include <vector>

#include "crowd.h"
#include "layout.h"
#include "maps.h"
#include "report.h"
#include "tricover/outline.h"
#include "tricover/scene.h"
#include "tricover/svg.h"

namespace tricover::bench {
namespace {

const std::string kFree = "#86d3a0", kHit = "#f8b4b4", kStill = "#f1f3f5", kTouched = "#fdf0d5";

std::string crowdPicture() {
  const Crowd crowd = makeCrowd(workloads::Kind::Contour, 64, kContourSpacing, 2000, 1);
  Scene scene;
  for (std::size_t i = 0; i < crowd.size(); ++i) scene.add(crowd.shapeOf(i), crowd.poses[0][i]);
  std::set<Scene::Body> colliding;
  for (const BodyPair& pair : scene.collisions()) colliding.insert({pair.first, pair.second});
  SvgDrawing drawing(1500);
  for (std::size_t i = 0; i < crowd.size(); ++i) {
    if (i % kCrowdRow >= 14 || i / kCrowdRow >= 7) continue;  // a corner of them all, to be seen
    const bool hit = colliding.count(static_cast<Scene::Body>(i)) > 0;
    drawing.polygon(crowd.shapeOf(i), crowd.poses[0][i], hit ? kHit : kFree);
  }
  return drawing.str();
}

std::string layoutPicture() {
  const Placement layout = makeLayout(80, 5, 8, 7);
  const std::size_t lifted = 30;
  Placement others = layout;
  others.erase(others.begin() + lifted);
  Scene scene;
  for (const Placed& placed : others) scene.add(placed.polygon, placed.pose);
  SvgDrawing drawing(1500);
  for (const Placed& placed : others) drawing.polygon(placed.polygon, placed.pose, kStill);
  const Polygon& part = layout[lifted].polygon;
  for (const Placing placing : {Placing::Uniform, Placing::Local, Placing::Free}) {
    for (const Pose& pose : placings(layout[lifted], others, placing, placing == Placing::Uniform ? 6 : 2, 9)) {
      drawing.polygon(part, pose, scene.collides(part, pose) ? kHit : kFree);
    }
  }
  return drawing.str();
}

void drawRays(const Placement& map, const Vec2& aside, std::uint64_t seed, SvgDrawing& drawing) {
  const Pose moved = poseAt(aside, 0);
  const Polygon robot = forkLift();
  Scene scene;
  for (const Placed& placed : map) scene.add(placed.polygon, placed.pose);
  std::set<Scene::Body> seen;
  std::vector<std::pair<Vec2, Vec2>> lines;
  const std::vector<Ray> rays = raysAround(map, robot, 1, 300, seed);
  for (const auto& [from, to] : rays) {
    const auto hit = scene.castRay(from, to);
    if (hit) seen.insert(hit->body);
    lines.emplace_back(from, hit ? hit->hit.point : to);
  }
  for (std::size_t i = 0; i < map.size(); ++i) {
    drawing.polygon(map[i].polygon, moved * map[i].pose, seen.count(static_cast<Scene::Body>(i)) ? kTouched : kStill);
  }
  for (std::size_t i = 0; i < lines.size(); i += 4) {
    drawing.polyline({moved * lines[i].first, moved * lines[i].second}, "#dc2626");
  }
  const Vec2 centre = robot.origin();
  drawing.polygon(robot, moved * poseAt(rays[0].first - centre, 0), kFree);
}

std::string raysPicture(const Countries& countries) {
  SvgDrawing drawing(1500);
  drawRays(countriesMap(countries, 100), {0, 0}, 5, drawing);
  drawRays(warehouseMap(200), {1350, 0}, 6, drawing);
  return drawing.str();
}

/// Where the fork lift's centre may be at some headings, by the scene's answers for the centres of cells.
std::string configurationsPicture() {
  constexpr double kCell = 2;
  const Placement map = warehouseMap(60);
  const Polygon robot = forkLift();
  Scene scene;
  for (const Placed& placed : map) scene.add(placed.polygon, placed.pose);
  Eigen::AlignedBox2d area = boundsOf(map);
  area.min().array() -= 30;
  area.max().array() += 30;
  const Vec2 size = area.sizes();
  SvgDrawing drawing(1500);
  for (int k = 0; k < 4; ++k) {
    const double heading = k * M_PI / 6;
    OccupancyGrid grid;
    grid.width = static_cast<std::size_t>(size.x() / kCell);
    grid.height = static_cast<std::size_t>(size.y() / kCell);
    grid.resolution = kCell;
    grid.origin = area.min();
    const Vec2 centre = robot.origin();
    std::vector<Pose> poses;
    for (std::size_t cell = 0; cell < grid.width * grid.height; ++cell) {
      const Vec2 at = grid.origin + kCell * Vec2(static_cast<double>(cell % grid.width) + 0.5,
                                                 static_cast<double>(cell / grid.width) + 0.5);
      poses.push_back(poseAt(at, heading) * Eigen::Translation2d(-centre));
    }
    const std::vector<bool> hits = scene.collides(robot, poses);
    grid.cells.assign(hits.begin(), hits.end());
    const Pose moved = poseAt(Vec2(k % 2 * 1.05 * size.x(), -(k / 2) * 1.1 * size.y()), 0);
    if (const auto blocked = outline(grid)) drawing.polygon(*blocked, moved, kHit, kHit);
    for (const Placed& placed : map) drawing.polygon(placed.polygon, moved * placed.pose, kStill);
    drawing.polygon(robot, moved * poseAt(area.min() + Vec2(15, 15), heading) * Eigen::Translation2d(-centre), kFree);
  }
  return drawing.str();
}

}  // namespace

void drawScenes(const Countries& countries, const std::string& directory) {
  writeFile(directory + "/crowd.svg", crowdPicture());
  writeFile(directory + "/layout.svg", layoutPicture());
  writeFile(directory + "/rays.svg", raysPicture(countries));
  writeFile(directory + "/configurations.svg", configurationsPicture());
}

}  // namespace tricover::bench
