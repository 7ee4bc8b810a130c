// SPDX-License-Identifier: BSD-3-Clause
// Cuts parts out of a sheet: each of a GeoJSON file's parts goes to the lowest place, and the leftmost there, that is a
// kerf away from all others and from the sheet's edge, in one of four quarter turns. Small parts go into the
// notches of large ones. usage: nesting [nesting.svg [parts.geojson [nesting.html]]], the last a recording
#include <tricover/geojson.h>
#include <tricover/tricover.h>

#include <cmath>
#include <iostream>

using namespace tricover;

int main(int argc, char** argv) {
  constexpr double kWidth = 16, kHeight = 13, kStep = 0.1;
  const double kerf = 0.05;  // parts exactly a kerf apart are far enough: they only touch
  const Polygon sheet({{0, 0}, {kWidth, 0}, {kWidth, kHeight}, {0, kHeight}});
  BodyOptions options;
  options.touching = Touching::Allowed;
  Scene scene;
  const Scene::Body outside = scene.add(sheet.complement(), poseAt(0, 0), options);
  SceneRecording recording("Nesting");

  for (const GeoFeature& feature : readGeoJson(argc > 2 ? argv[2] : "parts.geojson")) {
    std::vector<Pose> poses;  // the lowest first
    for (double y = 0; y < kHeight; y += kStep)
      for (double x = 0; x < kWidth; x += kStep)
        for (int turn = 0; turn < 4; ++turn) poses.push_back(poseAt(x, y, turn * M_PI / 2));
    for (int copy = 0; copy < 9; ++copy) {
      const std::vector<bool> collides = scene.collides(feature.polygon, poses, {kerf});
      const auto free = std::find(collides.begin(), collides.end(), false);
      if (free == collides.end()) break;  // the sheet is full
      scene.add(feature.polygon, poses[static_cast<std::size_t>(free - collides.begin())], options);
      recording.frame(static_cast<double>(scene.size()), scene);
    }
  }
  std::cout << scene.size() - 1 << " parts placed, " << scene.collisions().size() << " collisions\n";

  SvgDrawing drawing;
  drawing.polygon(sheet, poseAt(0, 0), "none");
  scene.remove(outside);
  drawing.scene(scene, "#a7c7e7");
  drawing.save(argc > 1 ? argv[1] : "nesting.svg");
  recording.save(argc > 3 ? argv[3] : "nesting.html");
}
