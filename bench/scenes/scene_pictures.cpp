// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "layout.h"
#include "report.h"
#include "scene_studies.h"
#include "tricover/scene.h"
#include "tricover/svg.h"

namespace tricover::bench {
namespace {

const std::string kFree = "#86d3a0", kHit = "#f8b4b4", kStill = "#f1f3f5";

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

}  // namespace

void drawScenes(const std::string& directory) { writeFile(directory + "/layout.svg", layoutPicture()); }

}  // namespace tricover::bench
