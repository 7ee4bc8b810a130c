// SPDX-License-Identifier: BSD-3-Clause
#include "tradeoff_scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "exact_reference.h"
#include "inputs.h"
#include "random.h"
#include "scenes/placed.h"
#include "shapes.h"

namespace tricover::bench {
namespace {

using support::Random;
using workloads::Kind;

constexpr std::size_t kDecades = 15;
constexpr std::size_t kTouch = kDecades + 1;  // among the offsets: -1e-1 .. -1e-15, -ulp, 0, +ulp, 1e-15 .. 1e-1

std::size_t behind(std::size_t decade) { return decade - 1; }
std::size_t ahead(std::size_t decade) { return 2 * kTouch - behind(decade); }

bool collides(const KnownScene& scene, const Pose& pose) {
  return exact::collide(scene.fixed, scene.fixed_pose, scene.moving, pose);
}

Pose translated(Pose pose, const Vec2& by) {
  pose.translation() += by;
  return pose;
}

/// The next double outwards in the coordinate that `direction` changes most.
Pose ulpFurther(Pose pose, const Vec2& direction) {
  const int axis = std::abs(direction.x()) >= std::abs(direction.y()) ? 0 : 1;
  double& coordinate = pose.translation()[axis];
  coordinate = std::nextafter(coordinate, std::copysign(std::numeric_limits<double>::infinity(), direction[axis]));
  return pose;
}

/// A free pose, its distance taken from the exact one. `most` is how far it is from a colliding pose.
KnownPose freePlacement(const KnownScene& scene, const Pose& pose, double most, std::size_t offset) {
  const double gap = exact::distanceBelow(exact::distanceSquared(scene.fixed, scene.fixed_pose, scene.moving, pose));
  if (gap > most) throw std::logic_error("tradeoff: the exact distance exceeds the way to a colliding pose");
  return {pose, false, gap, offset};
}

/// The last colliding pose on the way out along `direction`, whose neighbour ulpFurther is free: coming from far away,
/// that neighbour is the last free one. False where the way doesn't meet the polygon, or grazes it.
bool findContact(const KnownScene& scene, const Pose& start, const Vec2& direction, Pose& last) {
  constexpr int kSteps = 64, kUlps = 64;
  const double reach = 1.01 * (scene.fixed.radius() + scene.moving.radius());
  const auto at = [&](double way) { return translated(start, way * direction); };
  double free = reach, hit = reach;
  for (int step = kSteps - 1; step >= 0 && !collides(scene, at(hit)); --step) {
    free = hit;
    hit = reach * step / kSteps;
  }
  if (!collides(scene, at(hit))) return false;
  for (;;) {
    const double middle = hit + (free - hit) / 2;
    if (middle <= hit || middle >= free) break;
    (collides(scene, at(middle)) ? hit : free) = middle;
  }
  last = at(hit);
  for (int i = 0; i < kUlps; ++i) {
    const Pose next = ulpFurther(last, direction);
    if (!collides(scene, next)) return true;
    last = next;
  }
  return false;
}

double randomAngle(Random& random) { return random.real(0, 2 * static_cast<double>(EIGEN_PI)); }

Ring allVertices(const Polygon& polygon) {
  Ring all;
  for (const Ring& ring : polygon.rings()) all.insert(all.end(), ring.begin(), ring.end());
  return all;
}

Vec2 extremeVertex(const Ring& vertices, const Vec2& direction) {
  return *std::max_element(vertices.begin(), vertices.end(),
                           [&](const Vec2& p, const Vec2& q) { return p.dot(direction) < q.dot(direction); });
}

/// Somewhere to touch, and the direction away from the polygon, all of which is on the other side of the line across
/// it.
struct Spot {
  Vec2 at, outwards;
};

/// The middles of the edges that all other vertices are on one side of.
std::vector<Spot> hullEdges(const Polygon& polygon) {
  std::vector<Spot> spots;
  const Ring vertices = allVertices(polygon);
  for (std::size_t i = 0; i < polygon.vertexCount(); ++i) {
    const Vec2 v = polygon.edgeStart(i), u = polygon.edgeEnd(i) - v;
    for (const Vec2& outwards : {Vec2(u.y(), -u.x()), Vec2(-u.y(), u.x())}) {
      const bool hull =
          std::all_of(vertices.begin(), vertices.end(), [&](const Vec2& p) { return (p - v).dot(outwards) <= 0; });
      if (hull) spots.push_back({v + u / 2, outwards});
    }
  }
  return spots;
}

/// A country's outline on the grid, its origin at 0.
Polygon country(const std::string& name) {
  static const Countries countries = readCountries();
  for (const auto& [full_name, polygon] : countries) {
    const std::size_t underscore = full_name.find('_');
    if (underscore != std::string::npos && full_name.substr(underscore + 1) == name)
      return mapped(polygon, [origin = polygon.coveringOrigin()](const Vec2& v) -> Vec2 {
        return ((v - origin) / workloads::kGrid).array().round() * workloads::kGrid;
      });
  }
  throw std::invalid_argument("countries: no '" + name + "'");
}

}  // namespace

const std::vector<std::string>& offsetNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result(2 * kTouch + 1);
    for (std::size_t decade = 1; decade <= kDecades; ++decade) {
      result[behind(decade)] = "-1e-" + std::to_string(decade);
      result[ahead(decade)] = "1e-" + std::to_string(decade);
    }
    result[kTouch - 1] = "-1 ulp";
    result[kTouch] = "0";
    result[kTouch + 1] = "1 ulp";
    return result;
  }();
  return names;
}

std::vector<KnownPose> placementsAroundContact(const KnownScene& scene, std::size_t contacts, std::size_t decades,
                                               std::uint64_t seed) {
  Random random(seed);
  std::vector<KnownPose> placements;
  const Vec2 center = scene.fixed_pose * scene.fixed.coveringOrigin();
  for (std::size_t found = 0, tried = 0; found < contacts; ++tried) {
    if (tried > 20 * contacts) throw std::runtime_error("tradeoff: no contact found for " + scene.name);
    const Vec2 direction = support::direction(randomAngle(random));
    Pose pose = poseAt({0, 0}, randomAngle(random));
    pose.translation() = center - pose.linear() * scene.moving.coveringOrigin();
    Pose last;
    if (!findContact(scene, pose, direction, last)) continue;
    ++found;
    const Pose first_free = ulpFurther(last, direction);
    const double ulp = (first_free.translation() - last.translation()).lpNorm<1>();
    const double rounding = ulp + 0x1p-50 * last.translation().lpNorm<1>();
    placements.push_back({last, true, -ulp, kTouch - 1});
    placements.push_back(freePlacement(scene, first_free, ulp, kTouch + 1));
    for (std::size_t decade = 1; decade <= kDecades; decade += decades) {
      const double way = scene.size * std::pow(10, -static_cast<double>(decade));
      const Pose ways[] = {translated(last, -way * direction), translated(last, way * direction)};
      const std::size_t offsets[] = {behind(decade), ahead(decade)};
      for (int side = 0; side < 2; ++side) {
        // A thin part may be passed through, and a step out may meet another part: exact::collide tells.
        if (collides(scene, ways[side])) {
          placements.push_back({ways[side], true, side == 0 ? -way : 0, offsets[side]});
        } else {
          placements.push_back(freePlacement(scene, ways[side], way * (1 + 1e-9) + rounding, offsets[side]));
        }
      }
    }
  }
  return placements;
}

std::vector<KnownPose> touchingPlacements(const KnownScene& scene, std::size_t touches, std::uint64_t seed) {
  Random random(seed);
  const Ring fixed = allVertices(scene.fixed), moving = allVertices(scene.moving);
  const std::vector<Spot> edges = hullEdges(scene.fixed);
  std::vector<KnownPose> placements;
  for (std::size_t i = 0; i < touches; ++i) {
    Spot spot;
    if (i % 2 == 0 && !edges.empty()) {
      spot = edges[static_cast<std::size_t>(random.integer(0, static_cast<int>(edges.size()) - 1))];
    } else {
      spot.outwards = support::direction(randomAngle(random));
      spot.at = extremeVertex(fixed, spot.outwards);
    }
    Eigen::Matrix2d turn;
    const int quarters = random.integer(0, 3);
    turn << (quarters % 2 ? 0 : 1 - quarters), (quarters % 2 ? quarters - 2 : 0), (quarters % 2 ? 2 - quarters : 0),
        (quarters % 2 ? 0 : 1 - quarters);
    Pose pose = Pose::Identity();
    pose.linear() = turn;
    pose.translation() = spot.at - turn * extremeVertex(moving, -turn.transpose() * spot.outwards);
    if (!collides(scene, pose) || collides(scene, ulpFurther(pose, spot.outwards))) {
      throw std::logic_error("tradeoff: not a touch in " + scene.name);
    }
    placements.push_back({pose, true, 0, kTouch});
  }
  return placements;
}

KnownScene makeScene(std::string group, std::string name, Polygon fixed, Polygon moving) {
  const double size = 2 * std::max(fixed.radius(), moving.radius());
  return {std::move(group), std::move(name), std::move(fixed), Pose::Identity(), std::move(moving), size, {}};
}

KnownScene makeScene(Kind kind, std::size_t vertices) {
  const std::string name = workloads::name(kind) + ", " + std::to_string(vertices) + " vertices";
  return makeScene(name, name, workloads::makePolygon(kind, vertices, 1), workloads::makePolygon(kind, vertices, 2));
}

std::vector<KnownScene> tradeoffScenes(bool full) {
  const std::size_t few = 8, many = full ? 64 : 32;
  std::vector<KnownScene> scenes;
  for (const Kind kind : workloads::allKinds()) {
    const bool convex = kind == Kind::Convex || kind == Kind::Slim;
    for (const std::size_t vertices : {few, many}) {
      if (!convex && vertices == few) continue;
      scenes.push_back(makeScene(kind, vertices));
      scenes.back().group = (convex ? "convex, " : "not convex, ") + std::to_string(vertices) + " vertices";
    }
  }
  std::vector<std::pair<const char*, const char*>> pairs = {{"Switzerland", "Slovenia"}, {"Denmark", "Estonia"}};
  if (full) pairs.insert(pairs.end(), {{"Iceland", "Haiti"}, {"Portugal", "Cuba"}, {"New_Zealand", "Greece"}});
  for (const auto& [fixed, moving] : pairs) {
    scenes.push_back(makeScene("countries", std::string(fixed) + " and " + moving, country(fixed), country(moving)));
  }
  const std::size_t contacts = full ? 48 : 16;
  for (KnownScene& scene : scenes) {
    scene.poses = touchingPlacements(scene, contacts, 3);
    const auto around = placementsAroundContact(scene, contacts, 1, 4);
    scene.poses.insert(scene.poses.end(), around.begin(), around.end());
  }
  return scenes;
}

}  // namespace tricover::bench
