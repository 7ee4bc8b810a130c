// SPDX-License-Identifier: BSD-3-Clause
// Cutting parts out of a sheet: 60 parts that lie on each other are pushed apart until each has its kerf,
// the width of the cut, to the others and to the sheet's edge. Parts that are exactly that far apart touch, which is
// allowed. Draws where they came from and where they are.
#include <tricover/tricover.h>

#include <cmath>
#include <iostream>
#include <random>

#include "picture.h"

namespace {

constexpr double kWidth = 16, kHeight = 10, kKerf = 0.05, kFill = 0.52;
constexpr int kParts = 60, kMostRounds = 5000;

/// An L, a U, a triangle or a bar with a hole, larger or smaller.
tricover::Polygon anyPart(std::mt19937& random) {
  const std::vector<std::vector<tricover::Ring>> kinds = {
      {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}},
      {{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}},
      {{{0, 0}, {3, 0}, {1, 2}}},
      {{{0, 0}, {3, 0}, {3, 1.5}, {0, 1.5}}, {{1, 0.5}, {2, 0.5}, {2, 1}, {1, 1}}}};
  const double size = 1 + 0.5 * static_cast<double>(random() % 3);
  return tricover::Polygon(kinds[random() % kinds.size()]).scaled(size);
}

/// Pushes the parts apart, and by chance farther, which ends what would go round in circles. The number of rounds it
/// took.
int separate(tricover::Scene& scene, tricover::Scene::Body sheet, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  tricover::PenetrationOptions apart;
  apart.margin = kKerf;
  apart.touching = tricover::Touching::Allowed;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<tricover::BodyPair> overlaps = scene.collisions();
    if (overlaps.empty()) return round;
    for (const auto [first, second] : overlaps) {
      const auto way = tricover::penetration(scene.polygon(first), scene.pose(first), scene.polygon(second),
                                             scene.pose(second), apart);
      if (!way) continue;  // another push has parted them
      const double of_first = first == sheet ? 0 : unit(random), of_all = 1.01 + unit(random);
      tricover::Pose pose_a = scene.pose(first), pose_b = scene.pose(second);
      pose_a.translation() -= of_first * of_all * way->translation;
      pose_b.translation() += (1 - of_first) * of_all * way->translation;
      scene.move({{first, pose_a}, {second, pose_b}});
    }
  }
  throw std::runtime_error("some parts still overlap");
}

int run(const std::vector<std::string>& arguments) {
  std::mt19937 random(1);
  std::vector<tricover::Polygon> parts;
  double area = 0;
  for (int i = 0; i < kParts; ++i) area += parts.emplace_back(anyPart(random)).area();
  const double scale = std::sqrt(kFill * kWidth * kHeight / area);

  tricover::Scene scene;
  tricover::BodyOptions options;
  options.margin = kKerf / 2;
  options.touching = tricover::Touching::Allowed;
  const double w = kWidth, h = kHeight;
  const auto sheet = scene.add(
      tricover::Polygon({{{-9, -9}, {w + 9, -9}, {w + 9, h + 9}, {-9, h + 9}}, {{0, 0}, {w, 0}, {w, h}, {0, h}}}),
      tricover::Pose::Identity(), options);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const tricover::Polygon& part : parts) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.rotate(static_cast<double>(random() % 4) * EIGEN_PI / 2);
    pose.translation() << 1 + (w - 2) * unit(random), 1 + (h - 2) * unit(random);
    scene.add(part.scaled(scale), pose, options);
  }
  const tricover::Scene before(scene);
  const int rounds = separate(scene, sheet, random);
  std::cout << kParts << " parts, " << 100 * kFill << " % of the sheet, " << kKerf << " apart after " << rounds
            << " rounds\n";

  tricover::SvgDrawing drawing;
  const tricover::Polygon edge({{{0, 0}, {w, 0}, {w, h}, {0, h}}});
  drawing.polygon(edge, tricover::Pose::Identity(), "none");
  for (const auto body : scene.bodies()) {
    if (body == sheet) continue;
    drawing.polygon(scene.polygon(body), scene.pose(body), "#a7c7e7", "#333", kKerf / 2);
    drawing.polyline({before.pose(body) * before.polygon(body).coveringOrigin(),
                      scene.pose(body) * scene.polygon(body).coveringOrigin()},
                     "#dc2626");
  }
  savePicture(drawing, arguments[0]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return runExample(argc, argv, "usage: nesting [picture.svg]\n", "nesting.svg", 1, run);
}
