// SPDX-License-Identifier: BSD-3-Clause
#include "contact/uncovered.h"

#include <algorithm>
#include <utility>

#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// About so many parallelograms cover a square.
constexpr int kMostTries = 24;

/// A line by a unit normal: a point is beyond it by normal . p - at.
struct Line {
  Vec2 normal;
  double at;

  double beyond(const Vec2& p) const { return normal.dot(p) - at; }
};

/// The part of a convex polygon that is on one side of a line: sign 1: beyond it.
std::vector<Vec2> sideOf(const std::vector<Vec2>& part, const Line& line, double sign) {
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Vec2 &p = part[i], &q = part[i + 1 < part.size() ? i + 1 : 0];
    const double at_p = sign * line.beyond(p), at_q = sign * line.beyond(q);
    if (at_p >= 0) result.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) result.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return result;
}

double areaOf(const std::vector<Vec2>& part) {
  double twice = 0;
  for (std::size_t i = 2; i < part.size(); ++i) twice += cross(part[i - 1] - part[0], part[i] - part[0]);
  return twice / 2;
}

}  // namespace

Uncovered::Uncovered(const Vec2& center, double half, double thin) : thin_(thin) {
  keep(
      {center + Vec2(-half, -half), center + Vec2(half, -half), center + Vec2(half, half), center + Vec2(-half, half)});
}

void Uncovered::keep(Part part) {
  const double area = areaOf(part);
  double length = 0;
  for (const Vec2& p : part) length = std::max(length, (p - part[0]).norm());
  // Its width is at most two areas by its length.
  if (!(2 * area > thin_ * length)) return;
  area_ += area;
  parts_.push_back(std::move(part));
}

Vec2 Uncovered::point() const {
  const Part& part = parts_.back();
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : part) sum += p;
  return sum / static_cast<double>(part.size());
}

void Uncovered::takeAway(const std::array<Vec2, 4>& corners) {
  const double turn = cross(corners[1] - corners[0], corners[3] - corners[0]);
  if (turn == 0) return;
  std::array<Line, 4> lines;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 along = (corners[(k + 1) % 4] - corners[k]).stableNormalized() * (turn > 0 ? 1 : -1);
    lines[k].normal = Vec2(along.y(), -along.x());
    lines[k].at = lines[k].normal.dot(corners[k]) + thin_ / 2;
  }
  std::vector<Part> before;
  before.swap(parts_);
  area_ = 0;
  for (Part& part : before) {
    const bool apart = std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
      return std::all_of(part.begin(), part.end(), [&](const Vec2& p) { return line.beyond(p) >= 0; });
    });
    if (apart) {
      keep(std::move(part));
      continue;
    }
    for (const Line& line : lines) {
      keep(sideOf(part, line, 1));
      part = sideOf(part, line, -1);
    }
  }
}

Cover coverSquare(const Vec2& center, double half, double resolution, TranslationSpace& space,
                  TranslationProbe& probe) {
  Uncovered rest(center, half, resolution);
  const double whole = rest.area();
  for (int tries = 1; !rest.isEmpty(); ++tries) {
    probe.countQuery();
    Vec2 t = rest.point();
    const PosedPair pair = space.at(t);
    const Outcome outcome = probe.ask(pair, 0);
    if (!outcome.collides) return Cover::Little;
    if (outcome.edge_a >= 0 && outcome.edge_b >= 0) {
      rest.takeAway(space.meetings(static_cast<std::size_t>(outcome.edge_a), static_cast<std::size_t>(outcome.edge_b)));
    } else {
      const double side = probe.inUnits(pair, outcome.clearance) / kRoot2;
      rest.takeAway({t + Vec2(-side, -side), t + Vec2(side, -side), t + Vec2(side, side), t + Vec2(-side, side)});
    }
    if (whole - rest.area() < whole * tries / kMostTries) return rest.area() < whole / 2 ? Cover::Most : Cover::Little;
  }
  return Cover::Whole;
}

}  // namespace tricover::detail
