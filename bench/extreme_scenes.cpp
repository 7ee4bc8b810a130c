// SPDX-License-Identifier: BSD-3-Clause
#include "extreme_scenes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tricover::bench {
namespace {

using workloads::Kind;

Polygon mapped(const Polygon& polygon, const std::function<Vec2(const Vec2&)>& map) {
  std::vector<Ring> rings = polygon.rings();
  for (Ring& ring : rings) std::transform(ring.begin(), ring.end(), ring.begin(), map);
  return Polygon(std::move(rings), polygon.fillRule());
}

Polygon shifted(const Polygon& polygon, double by) {
  return mapped(polygon, [=](const Vec2& v) { return Vec2(v.x() + by, v.y() + by); });
}

Polygon stretched(const Polygon& polygon, double x, double y) {
  return mapped(polygon, [=](const Vec2& v) { return Vec2(v.x() * x, v.y() * y); });
}

std::vector<Sweep> makeSweeps() {
  const auto polygon = [](Kind kind, std::uint64_t seed) { return workloads::makePolygon(kind, 8, seed); };
  const auto power = [](int exponent) { return std::pow(10, exponent); };
  const auto scene = [](Polygon fixed, Polygon moving) {
    return makeScene("", "", std::move(fixed), std::move(moving));
  };
  const std::vector<int> away = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const std::vector<int> scales = {-300, -200, -100, -50, -20, -10, -5, 0, 5, 10, 20, 50, 100, 200, 300};
  const std::vector<int> slim = {-1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12, -13, -14, -15};
  return {
      {"both polygons' vertices moved by", away,
       [=](Kind kind, int exponent) {
         return scene(shifted(polygon(kind, 1), power(exponent)), shifted(polygon(kind, 2), power(exponent)));
       }},
      {"both poses moved by", away,
       [=](Kind kind, int exponent) {
         Scene result = scene(polygon(kind, 1), polygon(kind, 2));
         result.fixed_pose.translation() = Vec2::Constant(power(exponent));
         return result;
       }},
      {"scaled by", scales,
       [=](Kind kind, int exponent) {
         const double factor = power(exponent);
         return scene(stretched(polygon(kind, 1), factor, factor), stretched(polygon(kind, 2), factor, factor));
       }},
      {"slivers, squeezed to", slim,
       [=](Kind kind, int exponent) {
         return scene(stretched(polygon(kind, 1), 1, power(exponent)), stretched(polygon(kind, 2), 1, power(exponent)));
       }},
  };
}

}  // namespace

const std::vector<Sweep>& sweeps() {
  static const std::vector<Sweep> all = makeSweeps();
  return all;
}

std::string powerOfTen(int exponent) { return "1e" + std::to_string(exponent); }

Scene plainScene(Kind kind) {
  return makeScene("", "", workloads::makePolygon(kind, 8, 1), workloads::makePolygon(kind, 8, 2));
}

const std::vector<Kind>& extremeKinds() {
  static const std::vector<Kind> kinds = {Kind::Convex, Kind::Slim, Kind::Starred, Kind::WithHole};
  return kinds;
}

Scene extremeScene(const Sweep& sweep, int exponent, Kind kind, std::size_t contacts) {
  Scene scene = sweep.scene(kind, exponent);
  scene.name = workloads::name(kind) + ", " + sweep.name + " " + powerOfTen(exponent);
  scene.placements = placementsAroundContact(scene, contacts, 3, 5);
  return scene;
}

}  // namespace tricover::bench
