// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <set>

#include "report.h"
#include "studies.h"
#include "tricover/collide.h"
#include "tricover/svg.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

Pose shifted(const Vec2& by, const Pose& pose = Pose::Identity()) {
  Pose result = pose;
  result.pretranslate(by);
  return result;
}

Polygon scaled(const Polygon& polygon, double factor) {
  std::vector<Ring> rings = polygon.rings();
  for (Ring& ring : rings) {
    for (Vec2& v : ring) v *= factor;
  }
  return Polygon(std::move(rings), polygon.fillRule());
}

const std::string kFree = "#86d3a0", kHit = "#f8b4b4";

/// A circle around the Atlantic, turning with it. Poses of a centred polygon.
std::vector<Pose> circularDrive(std::size_t positions) {
  const Vec2 center(-20, 15);
  const double radius = 45;
  std::vector<Pose> poses(positions, Pose::Identity());
  for (std::size_t i = 0; i < positions; ++i) {
    const double angle = 2 * static_cast<double>(EIGEN_PI) * static_cast<double>(i) / static_cast<double>(positions);
    poses[i].linear() = Eigen::Rotation2Dd(angle).toRotationMatrix();
    poses[i].translation() = center + radius * Vec2(std::cos(angle), std::sin(angle));
  }
  return poses;
}

/// Straight from the Atlantic through Eurasia to the Pacific.
std::vector<Pose> linearDrive(std::size_t positions) {
  const Vec2 from(-50, 42), to(160, 25);
  std::vector<Pose> poses(positions, Pose::Identity());
  for (std::size_t i = 0; i < positions; ++i) {
    poses[i].translation() = from + static_cast<double>(i) / static_cast<double>(positions - 1) * (to - from);
  }
  return poses;
}

/// The mover at some positions of both drives.
std::string countriesPicture(const Countries& countries, const std::string& mover) {
  const std::size_t index = findCountry(countries, mover);
  const Polygon moving = centred(countries[index].polygon);
  std::vector<Pose> poses = circularDrive(24);
  const auto line = linearDrive(16);
  poses.insert(poses.end(), line.begin(), line.end());

  std::vector<bool> hits(poses.size(), false);
  std::set<std::size_t> hit_countries;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t k = 0; k < countries.size(); ++k) {
      if (k == index || !collide(countries[k].polygon, Pose::Identity(), moving, poses[i])) continue;
      hits[i] = true;
      hit_countries.insert(k);
    }
  }
  SvgDrawing drawing(1500);
  for (std::size_t k = 0; k < countries.size(); ++k) {
    if (k == index) continue;
    drawing.polygon(countries[k].polygon, Pose::Identity(), hit_countries.count(k) ? "#fdf0d5" : "#f1f3f5", "#adb5bd");
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    drawing.polygon(moving, poses[i], hits[i] ? kHit : kFree, "#333");
    for (const std::size_t k : hit_countries) drawing.hits(countries[k].polygon, Pose::Identity(), moving, poses[i]);
  }
  drawing.text({0, -60}, mover + " driven in a circle and on a line among the other countries");
  drawing.text({0, -65}, "green: free; red: hits, with the edges that meet; tinted: the countries that are hit");
  return drawing.str();
}

/// Algorithm 3: the moving centroid outside every influence area of length r, inside one but free, and a hit.
std::string algorithmPicture() {
  const Polygon fixed = workloads::makePolygon(Kind::Irregular, 16, 3);
  const Polygon moving = scaled(workloads::makePolygon(Kind::Starred, 10, 8), 0.14);
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

void drawPictures(const Countries& countries, const std::string& directory) {
  writeFile(directory + "/countries.svg", countriesPicture(countries, "Italy"));
  writeFile(directory + "/algorithm.svg", algorithmPicture());
  writeFile(directory + "/workloads.svg", workloadsPicture());
}

}  // namespace tricover::bench
