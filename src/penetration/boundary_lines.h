// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "numbers/angle.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// The convolution segments that may bound the free translations within a cell of the plane of translations. Free ones
/// may be on the left of a line.
class BoundaryLines {
 public:
  /// noise: the error of a segment's end. Lines within `resolution` of each other count as one.
  BoundaryLines(double noise, double resolution) : noise_(noise), resolution_(resolution) {}

  /// A segment, or several ones that lie on a line within the resolution; axis: a unit vector, unless v and w are one.
  struct Line : Ends {
    /// noise: what an end is wrong by.
    Line(const Ends& ends, bool both_sides_, double noise)
        : Ends(ends), axis(w - v), length(axis.norm()), slack(1), both_sides(both_sides_) {
      const double inverse = length > 0 ? 1 / length : 0;
      axis *= inverse;
      if (2 * noise < length) slack = 2 * noise * inverse;
    }

    /// Takes away what is farther along it than `radius` from t.
    void clip(const Vec2& t, double radius) {
      if (!(length > 0)) return;
      const double middle = (t - v).dot(axis);
      const double low = std::clamp(middle - radius, 0.0, length), high = std::clamp(middle + radius, 0.0, length);
      if (high < length) w = v + high * axis;
      if (low > 0) v += low * axis;
      length = high - low;
    }

    /// Whether its box, and whether its line, meets a square around t: if both do, so does it.
    bool boxMeets(const Vec2& t, double half) const {
      return ((v.cwiseMin(w) - t).array() <= half).all() && ((t - v.cwiseMax(w)).array() <= half).all();
    }
    bool lineMeets(const Vec2& t, double half) const { return std::abs(cross(axis, t - v)) <= half * axis.lpNorm<1>(); }

    Vec2 axis;
    double length;
    double slack;     ///< the sine of what the axis is wrong by, at most, and of what it stands for
    bool both_sides;  ///< free translations may be on its right, too
  };

  /// Afterwards no more than `most` are added.
  void clear(std::size_t most) {
    most_ = most;
    lines_.clear();
  }
  bool isEmpty() const { return lines_.empty(); }

  /// The part of a segment within `radius` of t. False if there are too many lines then.
  bool add(Line segment, const Vec2& t, double radius) {
    segment.clip(t, radius);
    for (Line& other : lines_)
      if (merged(other, segment)) return true;
    if (lines_.size() == most_) return false;
    lines_.push_back(segment);
    return true;
  }

  /// Calls offer(p, error) for every point of the lines' arrangement that may be the nearest one to 0 of a face: the
  /// nearest point of a line, an end or a crossing. `error` bounds the error of p along the lines that cross there.
  template <typename Offer>
  void forEachPossibleLimit(Offer offer) const {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      offerFoot(lines_[i], offer);
      for (std::size_t j = 0; j < i; ++j) offerCrossing(lines_[i], lines_[j], offer);
    }
  }

  /// A direction in which a line leaves a point, and the sides, seen along it, where free translations may be.
  struct LeavingLine {
    double angle;
    bool left, right;
    double length = std::numeric_limits<double>::infinity();
  };
  /// Adds the rays of the lines through a point.
  void addRays(const Vec2& p, std::vector<LeavingLine>& rays) const {
    for (const Line& line : lines_) {
      if (!passes(line, p)) continue;
      for (const Vec2& end : {line.v, line.w}) {
        const Vec2 ray = end - p;
        const double length = ray.norm();
        if (length <= 2 * resolution_) continue;
        const bool is_along = ray.dot(line.axis) > 0;
        const bool left = is_along || line.both_sides, right = !is_along || line.both_sides;
        rays.push_back({std::atan2(ray.y(), ray.x()), left, right, length});
      }
    }
  }

  /// The room between two rays of a point, `gap` apart: no line is in their sector up to twice as far, and neither ray
  /// ends. At most `most`.
  double roomBetween(const Vec2& p, const LeavingLine& from, const LeavingLine& to, double gap, double most) const {
    double room = std::min({most, from.length / 2, to.length / 2});
    const Vec2 left_of_from(-std::sin(from.angle), std::cos(from.angle)),
        right_of_to(std::sin(to.angle), -std::cos(to.angle));
    for (const Line& line : lines_) {
      if (passes(line, p)) continue;
      Ends part = line;
      const bool is_between = gap >= kPi || (cutBeyond(part, p, left_of_from) && cutBeyond(part, p, right_of_to));
      if (is_between) room = std::min(room, (nearestOnSegment(p, part.v, part.w) - p).norm() / 2);
    }
    return room;
  }

 private:
  bool passes(const Line& line, const Vec2& p) const {
    return (nearestOnSegment(p, line.v, line.w) - p).norm() <= 2 * resolution_;
  }

  /// Leaves of a segment what is beyond the line through p, in the direction `up` across it, or as near to the line as
  /// lines that pass p are. False if nothing is.
  bool cutBeyond(Ends& part, const Vec2& p, const Vec2& up) const {
    const double v = up.dot(part.v - p) + 2 * resolution_, w = up.dot(part.w - p) + 2 * resolution_;
    if (v < 0 && w < 0) return false;
    const Vec2 crossing = part.v + v / (v - w) * (part.w - part.v);
    if (v < 0) part.v = crossing;
    if (w < 0) part.w = crossing;
    return true;
  }

  /// Whether the shorter one lies on the longer one's line; if so, `into` becomes both.
  bool merged(Line& into, const Line& line) const {
    const bool longer = line.length > into.length;
    const Line &base = longer ? line : into, &other = longer ? into : line;
    if (!(base.length > 0)) return !((other.v - base.v).norm() > resolution_);
    if (std::abs(cross(base.axis, other.v - base.v)) > resolution_ ||
        std::abs(cross(base.axis, other.w - base.v)) > resolution_)
      return false;
    const double p = (other.v - base.v).dot(base.axis), q = (other.w - base.v).dot(base.axis);
    const double low = std::min({0.0, p, q}), high = std::max({base.length, p, q});
    Line both = base;
    if (low < 0) both.v = base.v + low * base.axis;
    if (high > base.length) both.w = base.v + high * base.axis;
    both.length = high - low;
    both.slack = std::max({base.slack, other.slack, std::abs(cross(base.axis, other.axis))});
    both.both_sides = base.both_sides || other.both_sides || !(base.axis.dot(other.axis) > 0.5);
    into = both;
    return true;
  }

  /// From 0 to the nearest point p of a free face the way leads out of what bounds it there: it is a sum of normals
  /// that point to the left of lines, of which this is `left` long or more. None is needed beside a line that is free
  /// on both sides, nor where p is 0.
  bool leads(const Vec2& p, const Line& line, double left, double error) const {
    const double length = p.norm();
    return line.both_sides || left >= -(4 * resolution_ + error + line.slack * length) || length <= 4 * resolution_;
  }

  template <typename Offer>
  void offerFoot(const Line& line, Offer offer) const {
    // By the axis: the ends of a short piece know the direction of a long segment less well.
    const Vec2 p = line.v + footAlong(Vec2::Zero(), line.v, line.axis, 1, line.length) * line.axis;
    const bool is_foot = std::abs(line.axis.dot(p)) <= 4 * resolution_ + line.slack * p.norm();
    if (is_foot && leads(p, line, cross(line.axis, p), 0)) offer(p, 0.0);
  }

  template <typename Offer>
  void offerCrossing(const Line& line, const Line& other, Offer offer) const {
    const Vec2 u = line.w - line.v, w = other.w - other.v, between = other.v - line.v;
    const double area = cross(u, w), turn = area > 0 ? 1 : -1, size = std::abs(area);
    // Segments that end in each other cross a little beyond their ends, where these are rounded: farther the smaller
    // the angle between them.
    const double s = turn * cross(between, w), t = turn * cross(between, u), near = resolution_ + 2 * noise_;
    const auto isBeyond = [&](double place, double length) {
      return !(std::abs(2 * place - size) <= size + 2 * near * length);
    };
    if (area == 0 || isBeyond(s, other.length) || isBeyond(t, line.length)) return;
    const double error = 2 * noise_ * line.length * other.length / size;
    Vec2 p = line.v + std::clamp(s / size, 0.0, 1.0) * u;
    const double slack = error + (line.slack + other.slack) * p.norm();
    if (!leads(p, line, turn * p.dot(other.axis), slack) || !leads(p, other, -turn * p.dot(line.axis), slack)) return;
    const Vec2 on_other = nearestOnSegment(p, other.v, other.w);
    if (!((on_other - p).norm() <= resolution_)) {
      p = on_other;
      if (!((nearestOnSegment(p, line.v, line.w) - p).norm() <= resolution_)) return;
    }
    offer(p, error);
  }

  double noise_, resolution_;
  std::size_t most_ = 0;
  std::vector<Line> lines_;
};

}  // namespace tricover::detail
