// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"

#include <set>

#include "report.h"
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

/// The mover at some positions of both drives: green where it is free, red where it hits; the countries hit are tinted.
std::string countriesPicture(const Countries& countries, const std::string& mover) {
  const std::size_t index = findCountry(countries, mover);
  const Polygon moving = centred(countries[index].polygon);
  std::vector<Pose> poses = circularDrive(20);
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
  SvgDrawing drawing(1400);
  const std::size_t antarctica = findCountry(countries, "Antarctica");
  for (std::size_t k = 0; k < countries.size(); ++k) {
    if (k == antarctica || k == index) continue;
    drawing.polygon(countries[k].polygon, Pose::Identity(), hit_countries.count(k) ? "#fde9c9" : "#eef0f2", "#9aa3ad");
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    drawing.polygon(moving, poses[i], hits[i] ? "#f8b4b4" : "#86d3a0", "#222");
    for (const std::size_t k : hit_countries) drawing.hits(countries[k].polygon, Pose::Identity(), moving, poses[i]);
  }
  drawing.text({-95, -30}, mover + " on a circular and a linear drive among the other countries.");
  drawing.text({-95, -36}, "Green: free. Red: hits (edges that meet in bold red; countries hit in yellow).");
  return drawing.str();
}

/// Algorithm 3 at two positions: the moving centroid outside every influence area, and a hit.
std::string algorithmPicture() {
  const Polygon fixed = workloads::makePolygon(Kind::Contour, 24, 5);
  const Polygon moving = workloads::makePolygon(Kind::Starred, 10, 8);
  const auto poses = workloads::linearTrajectory(fixed, moving);
  const Pose far = shifted({moving.radius() * 0.9, 0}, poses.front());
  SvgDrawing drawing(1000);
  drawing.influenceAreas(fixed, Pose::Identity(), moving.radius());
  drawing.polygon(fixed, Pose::Identity(), "#ffffff");
  drawing.covering(fixed, Pose::Identity());
  for (const Pose& pose : {far, poses.back()}) {
    drawing.polygon(moving, pose, collide(fixed, Pose::Identity(), moving, pose) ? "#f8b4b4" : "#86d3a0");
    drawing.covering(moving, pose);
    drawing.hits(fixed, Pose::Identity(), moving, pose);
  }
  return drawing.str();
}

/// For each kind: where the circular trajectory starts, a quarter turn on, and where the linear one ends.
std::string workloadsPicture() {
  SvgDrawing drawing(1400);
  double column = 0;
  for (const Kind kind : workloads::allKinds()) {
    const Polygon fixed = workloads::makePolygon(kind, 64, 1), moving = workloads::makePolygon(kind, 64, 2);
    const auto circular = workloads::circularTrajectory(fixed, moving, workloads::kGap, 8);
    const auto linear = workloads::linearTrajectory(fixed, moving);
    const Vec2 top(column, 0), bottom(column, -430);
    drawing.text(top + Vec2(0, 190), workloads::name(kind) + ", circular");
    drawing.polygon(fixed, shifted(top), "#dbe4ee");
    drawing.covering(fixed, shifted(top));
    for (std::size_t i = 0; i < circular.size(); i += 2) drawing.polygon(moving, shifted(top, circular[i]), "#86d3a0");
    drawing.text(bottom + Vec2(40, 90), workloads::name(kind) + ", linear");
    drawing.polygon(fixed, shifted(bottom), "#dbe4ee");
    drawing.polygon(moving, shifted(bottom, linear.front()), "none", "#2f9e5b");
    drawing.polygon(moving, shifted(bottom, linear.back()), "#f8b4b4");
    drawing.hits(fixed, shifted(bottom), moving, shifted(bottom, linear.back()));
    column += 400;
  }
  return drawing.str();
}

}  // namespace

void drawPictures(const Countries& countries, const std::string& directory) {
  writeFile(directory + "/countries.svg", countriesPicture(countries, "Italy"));
  writeFile(directory + "/algorithm.svg", algorithmPicture());
  writeFile(directory + "/workloads.svg", workloadsPicture());
}

}  // namespace tricover::bench
