// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "report.h"
#include "studies.h"
#include "tricover/collide.h"
#include "tricover/svg.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

Pose shifted(const Vec2& by, const Pose& pose = Pose::Identity()) {
  Pose result = pose;
  result.pretranslate(by);
  return result;
}

const std::string kFree = "#86d3a0", kHit = "#f8b4b4";

/// Algorithm 3: the moving centroid outside every influence area of length r, inside one but free, and a hit.
std::string algorithmPicture() {
  const Polygon fixed = workloads::makePolygon(Kind::Irregular, 16, 3);
  const Polygon moving = workloads::makePolygon(Kind::Starred, 10, 8).scaled(0.14);
  const auto poses = workloads::linearTrajectory(fixed, moving, 1);
  const double radius = moving.radius();
  SvgDrawing drawing(1100);
  drawing.influenceAreas(fixed, Pose::Identity(), radius);
  drawing.polygon(fixed, Pose::Identity(), "#ffffff");
  drawing.covering(fixed, Pose::Identity());
  for (const double back : {2.2 * radius, 0.0, -1.2 * radius}) {
    const Pose pose = shifted({back, 0}, poses.front());
    drawing.polygon(moving, pose, collide(fixed, Pose::Identity(), moving, pose) ? kHit : kFree);
    drawing.covering(moving, pose);
    drawing.hits(fixed, Pose::Identity(), moving, pose);
  }
  const double below = -38;
  drawing.text({0, below},
               "Algorithm 3. Yellow: influence areas of the fixed polygon, as long as the moving one's radius.");
  drawing.text({0, below - 3},
               "Blue: coverings (a red triangle is negative). Green: free; red: a hit, with its edges.");
  return drawing.str();
}

/// For each kind: four positions of the circular trajectory, and the first and the last one of the linear trajectory.
std::string workloadsPicture() {
  SvgDrawing drawing(1500);
  double column = 0;
  for (const Kind kind : workloads::allKinds()) {
    const Polygon fixed = workloads::makePolygon(kind, 64, 1), moving = workloads::makePolygon(kind, 64, 2);
    const auto circular = workloads::circularTrajectory(fixed, moving, workloads::kGap, 4);
    const auto linear = workloads::linearTrajectory(fixed, moving);
    const Vec2 top(column, 0), bottom(column - 45, -250);
    drawing.text(top + Vec2(0, 175), workloads::name(kind));
    drawing.polygon(fixed, shifted(top), "#ffffff");
    drawing.covering(fixed, shifted(top));
    for (const Pose& pose : circular) drawing.polygon(moving, shifted(top, pose), kFree);
    drawing.polygon(fixed, shifted(bottom), "#ffffff");
    drawing.polygon(moving, shifted(bottom, linear.front()), "none", "#2f9e5b");
    drawing.polygon(moving, shifted(bottom, linear.back()), kHit);
    drawing.hits(fixed, shifted(bottom), moving, shifted(bottom, linear.back()));
    column += 340;
  }
  drawing.text({850, -330},
               "Above: the circular trajectory (smallest gap 9). Below: first and last position of the linear one.");
  return drawing.str();
}

}  // namespace

void drawPictures(const std::string& directory) {
  writeFile(directory + "/algorithm.svg", algorithmPicture());
  writeFile(directory + "/workloads.svg", workloadsPicture());
}

}  // namespace tricover::bench
