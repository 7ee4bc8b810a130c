// SPDX-License-Identifier: BSD-3-Clause
#include <geos/geom/prep/PreparedGeometryFactory.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "asked.h"
#include "random.h"
#include "rivals/geos.h"
#include "shapes.h"
#include "tricover/covers.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using support::Random;
using workloads::Kind;

constexpr int kRounds = 9;
constexpr std::size_t kPoses = 200;
constexpr double kTurn = 2 * static_cast<double>(EIGEN_PI);

/// Areas are about 100 units long.
const Polygon& car() {
  static const Polygon polygon({support::rectangle(-4, -1.75, 4, 1.75)});
  return polygon;
}

/// Whether areas cover the car at a pose, with a margin.
using Covers = std::function<bool(const Pose& pose, double margin)>;

/// GEOS is asked without the margin, which it doesn't know.
void measure(const std::string& areas, std::size_t vertices, const Covers& covers, const geos::geom::Geometry& united,
             const Eigen::AlignedBox2d& bounds, std::vector<Result>& results) {
  const auto prepared = geos::geom::prep::PreparedGeometryFactory::prepare(&united);
  GeosMoved moved(car());
  for (const double margin : {0.0, 0.5}) {
    std::vector<Pose> poses[2];  // where it isn't covered, and where it is
    Random random(1);
    while (std::min(poses[0].size(), poses[1].size()) < kPoses) {
      const Vec2 at(random.real(bounds.min().x(), bounds.max().x()), random.real(bounds.min().y(), bounds.max().y()));
      const Pose pose = poseAt(at, random.real(0, kTurn));
      std::vector<Pose>& alike = poses[covers(pose, margin)];
      if (alike.size() < kPoses && united.intersects(moved.at(pose))) alike.push_back(pose);
    }
    for (const bool is_covered : {false, true}) {
      const std::vector<Pose>& all = poses[is_covered];
      std::vector<double> ours(all.size()), theirs(all.size());
      results.push_back(measureInTurn(
          {"covers", areas,
           std::string(is_covered ? "covered" : "across a border") + (margin > 0 ? ", with a margin" : ""), vertices,
           car().vertexCount(), all.size()},
          {taskOf("tricover", Role::Ours, ours, [&](std::size_t i) { return covers(all[i], margin); }),
           taskOf("GEOS prepared", Role::Rival, theirs,
                  [&](std::size_t i) { return prepared->covers(moved.at(all[i])); })},
          kRounds));
      results.back().timings[1].checked = all.size();
      for (std::size_t i = 0; margin == 0 && i < all.size(); ++i)
        results.back().timings[1].misses += ours[i] != theirs[i];
    }
  }
}

/// Lanes along a course that turns, each a convex piece that overlaps the next one; or pieces that abut.
Placement lanes(std::size_t count, bool overlap) {
  Random random(3);
  Placement placement;
  double angle = 0;
  Vec2 at(0, 0), left(0, 6), right(0, -6);
  for (std::size_t i = 0; i < count; ++i) {
    angle += random.real(-0.3, 0.3);
    const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
    const Vec2 next = at + 12 * along;
    const Vec2 next_left = next + 6 * across, next_right = next - 6 * across;
    const Vec2 more = overlap ? Vec2(3 * along) : Vec2(0, 0);
    placement.push_back(
        {Polygon({{right - more, next_right + more, next_left + more, left - more}}), Pose::Identity()});
    at = next, left = next_left, right = next_right;
  }
  return placement;
}

}  // namespace

std::vector<Result> measureCovers() {
  std::vector<Result> results;
  for (const Kind kind : {Kind::Convex, Kind::Contour})
    for (const std::size_t n : {8u, 16u, 64u, 256u, 1024u}) {
      const Polygon area = workloads::makePolygon(kind, n, 1);
      measure(
          workloads::name(kind), n,
          [&](const Pose& pose, double margin) { return covers(area, Pose::Identity(), car(), pose, {margin}); },
          *geosRegion(area), boundsOf(area, Pose::Identity()), results);
    }
  for (const bool overlap : {true, false})
    for (const std::size_t count : {8u, 64u}) {
      const Placement placement = lanes(count, overlap);
      const Scene scene = sceneOf(placement);
      std::unique_ptr<geos::geom::Geometry> united = geosRegion(placement[0].polygon);
      for (const Placed& placed : placement) united = united->Union(geosRegion(placed.polygon).get());
      measure(
          std::to_string(count) + (overlap ? " lanes that overlap" : " lanes that abut"), 0,
          [&](const Pose& pose, double margin) { return scene.covers(car(), pose, {margin}); }, *united,
          boundsOf(placement), results);
    }
  return results;
}

}  // namespace tricover::bench
