// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "random.h"
#include "report.h"
#include "shapes.h"
#include "tricover/scene.h"
#include "tricover/svg.h"

namespace tricover::bench {
namespace {

using support::Random;

constexpr double kTurn = 2 * static_cast<double>(EIGEN_PI);

/// About as large as the unit square: brackets, arrows, nuts and the like.
const std::vector<Ring>& kinds() {
  static const std::vector<Ring> rings = {
      {{0, 0}, {1, 0}, {1, .35}, {.35, .35}, {.35, 1}, {0, 1}},
      {{0, .65}, {.35, .65}, {.35, 0}, {.65, 0}, {.65, .65}, {1, .65}, {1, 1}, {0, 1}},
      {{0, 0}, {1, 0}, {1, 1}, {.7, 1}, {.7, .3}, {.3, .3}, {.3, 1}, {0, 1}},
      {{0, 0}, {.65, 0}, {.65, .65}, {1, .65}, {1, 1}, {.35, 1}, {.35, .35}, {0, .35}},
      {{0, 0}, {1, 0}, {1, .6}, {.5, 1}, {0, .6}},
      {{0, 0}, {.5, .35}, {1, 0}, {1, .5}, {.5, .85}, {0, .5}},
      {{0, .3}, {.55, .3}, {.55, 0}, {1, .5}, {.55, 1}, {.55, .7}, {0, .7}},
      {{0, 0}, {.5, .2}, {1, 0}, {.7, .6}, {.4, 1}},
      {{0, 0}, {1, 0}, {.85, .4}, {.6, .5}, {.15, .5}},
      support::regular(5, 0.5),
      support::regular(6, 0.5),
      support::regular(8, 0.5),
  };
  return rings;
}

/// Splits the longest edge until there are so many vertices, each new one a little beside the edge.
void refine(Ring& ring, std::size_t vertices, Random& random) {
  while (ring.size() < vertices) {
    std::size_t longest = 0;
    double most = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double length = (ring[(i + 1) % ring.size()] - ring[i]).norm();
      if (length > most) {
        most = length;
        longest = i;
      }
    }
    const Vec2 from = ring[longest], edge = ring[(longest + 1) % ring.size()] - from;
    const Vec2 beside = random.real(-0.06, 0.06) * Vec2(-edge.y(), edge.x());
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(longest) + 1, from + 0.5 * edge + beside);
  }
}

/// Around its origin.
Polygon makePart(int least, int most, Random& random) {
  Ring ring = kinds()[static_cast<std::size_t>(random.integer(0, static_cast<int>(kinds().size()) - 1))];
  refine(ring, static_cast<std::size_t>(random.integer(least, most)), random);
  const Vec2 size(random.real(60, 140), random.real(40, 120));
  for (Vec2& v : ring) v = v.cwiseProduct(size);
  const Vec2 origin = Polygon({ring}).coveringOrigin();
  for (Vec2& v : ring) v -= origin;
  return Polygon({ring});
}

class Filler {
 public:
  explicit Filler(double height) : height_(height) {}

  /// Throws nothing and always finds a place: beyond all others there is one.
  Pose place(const Polygon& part, Random& random) {
    Pose best = Pose::Identity();
    best.translation().x() = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < kTurns; ++turn) {
      const double angle = random.real(0, kTurn);
      const auto box = boundsOf(part, poseAt({0, 0}, angle));
      if (box.sizes().y() > height_) continue;
      for (int row = 0; row < kRows; ++row) {
        const double y = (height_ - box.sizes().y()) * row / (kRows - 1) - box.min().y();
        slideRight(part, poseAt({-box.min().x(), y}, angle), best);
      }
    }
    settle(part, best);
    placed_.add({part, best});
    return best;
  }

 private:
  static constexpr int kTurns = 4, kRows = 32;

  /// Moves `pose` right until it is free; keeps it in `best` if that is farther left.
  void slideRight(const Polygon& part, Pose pose, Pose& best) {
    const double step = part.radius() / 8;
    const double start = pose.translation().x();
    while (placed_.collides(part, pose)) {
      pose.translation().x() += step;
      if (pose.translation().x() - step >= best.translation().x()) return;
    }
    if (pose.translation().x() > start) shift(part, pose, Vec2(-step, 0));
    if (pose.translation().x() < best.translation().x()) best = pose;
  }

  /// As far by `way` as halving finds it free.
  void shift(const Polygon& part, Pose& pose, Vec2 way) {
    for (int i = 0; i < 12; ++i) {
      way /= 2;
      Pose moved = pose;
      moved.translation() += way;
      const auto box = boundsOf(part, moved);
      if (box.min().minCoeff() >= 0 && box.max().y() <= height_ && !placed_.collides(part, moved)) pose = moved;
    }
  }

  void settle(const Polygon& part, Pose& pose) {
    for (int i = 0; i < 4; ++i) {
      shift(part, pose, Vec2(-part.radius(), 0));
      shift(part, pose, Vec2(0, -part.radius()));
    }
  }

  double height_;
  CoreScan placed_;
};

}  // namespace

Placement makeLayout(std::size_t parts, int least, int most, std::uint64_t seed) {
  Random random(seed);
  std::vector<Polygon> polygons;
  double area = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    polygons.push_back(makePart(least, most, random));
    area += polygons.back().area();
  }
  std::stable_sort(polygons.begin(), polygons.end(),
                   [](const Polygon& p, const Polygon& q) { return p.area() > q.area(); });
  Filler filler(1.2 * std::sqrt(area));
  Placement layout;
  for (const Polygon& polygon : polygons) layout.push_back({polygon, filler.place(polygon, random)});
  return layout;
}

Lifted lifted(const Placement& layout, std::size_t index) {
  Lifted lifted{index, layout[index], layout};
  lifted.others.erase(lifted.others.begin() + static_cast<std::ptrdiff_t>(index));
  return lifted;
}

std::vector<Lifted> liftedParts(const Placement& layout) {
  std::vector<Lifted> parts;
  for (std::size_t k = 0; k < 8; ++k) parts.push_back(lifted(layout, k * layout.size() / 8));
  return parts;
}

std::vector<Pose> placings(const Lifted& lifted, Placing placing, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const Placed& part = lifted.part;
  const CoreScan scan(lifted.others);
  const auto bounds = boundsOf(lifted.others);
  const auto near = [&](double size) {
    const Vec2 by(random.real(-size, size), random.real(-size, size));
    Pose pose = poseAt({0, 0}, random.real(-size, size)) * part.pose;
    pose.translation() = part.pose.translation() + part.polygon.radius() * by;
    return pose;
  };
  std::vector<Pose> poses;
  while (poses.size() < count) {
    if (placing == Placing::Uniform) {
      poses.push_back(
          poseAt({random.real(bounds.min().x(), bounds.max().x()), random.real(bounds.min().y(), bounds.max().y())},
                 random.real(0, kTurn)));
      continue;
    }
    Pose pose = near(placing == Placing::LocalWide ? 1.0 : 0.2);
    for (double size = 0.1; placing == Placing::Free && scan.collides(part.polygon, pose); size /= 2) pose = near(size);
    poses.push_back(pose);
  }
  return poses;
}

void drawLayout(const std::string& directory) {
  const Lifted one = lifted(makeLayout(80, 5, 8, 7), 30);
  const Scene scene = sceneOf(one.others);
  SvgDrawing drawing(1500);
  for (const Placed& placed : one.others) drawing.polygon(placed.polygon, placed.pose, "#f1f3f5");
  const Polygon& part = one.part.polygon;
  for (const Placing placing : {Placing::Uniform, Placing::Local, Placing::Free})
    for (const Pose& pose : placings(one, placing, placing == Placing::Uniform ? 6 : 2, 9))
      drawing.polygon(part, pose, scene.collides(part, pose) ? "#f8b4b4" : "#86d3a0");
  writeFile(directory + "/layout.svg", drawing.str());
}

}  // namespace tricover::bench
