// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <vector>

#include "layout.h"
#include "maps.h"
#include "report.h"
#include "scene_studies.h"
#include "tricover/scene.h"
#include "tricover/svg.h"

namespace tricover::bench {
namespace {

const std::string kFree = "#86d3a0", kHit = "#f8b4b4", kStill = "#f1f3f5", kTouched = "#fdf0d5";

std::string layoutPicture() {
  const Placement layout = makeLayout(80, 5, 8, 7);
  const Lifted one = lifted(layout, 30);
  const Scene scene = sceneOf(one.others);
  SvgDrawing drawing(1500);
  for (const Placed& placed : one.others) drawing.polygon(placed.polygon, placed.pose, kStill);
  const Polygon& part = one.part.polygon;
  for (const Placing placing : {Placing::Uniform, Placing::Local, Placing::Free})
    for (const Pose& pose : placings(one, placing, placing == Placing::Uniform ? 6 : 2, 9))
      drawing.polygon(part, pose, scene.collides(part, pose) ? kHit : kFree);
  return drawing.str();
}

void drawRays(const Placement& map, const Vec2& aside, std::uint64_t seed, SvgDrawing& drawing) {
  const Pose moved = poseAt(aside, 0);
  const Polygon robot = forkLift();
  const Scene scene = sceneOf(map);
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

}  // namespace

void drawScenes(const Countries& countries, const std::string& directory) {
  writeFile(directory + "/layout.svg", layoutPicture());
  writeFile(directory + "/rays.svg", raysPicture(countries));
}

}  // namespace tricover::bench
