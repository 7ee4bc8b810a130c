// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "numbers/segment.h"

namespace tricover::detail {

/// In the plane of translations what may bound the free ones within a cell: convolution segments; or, with a margin,
/// lines beside them and circles around their ends. Free ones may be on the left of a line, and outside of a circle.
class BoundaryCurves {
 public:
  /// noise: what a segment's end is wrong by. What is nearer to each other than `resolution` is taken for one.
  BoundaryCurves(double margin, double noise, double resolution)
      : margin_(margin), noise_(noise), resolution_(resolution) {}

  struct Ends {
    Vec2 v, w;
  };
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

    /// Whether it may come within `radius` of t.
    bool comesNear(const Vec2& t, double radius) const {
      const Vec2 from = t - v;
      const double along = axis.dot(from);
      return (std::abs(cross(axis, from)) <= radius) & (along >= -radius) & (along <= length + radius);
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
  enum Added { New, Repeated, TooMany };

  /// Then no more than `most` are added.
  void clear(std::size_t most) {
    most_ = most;
    lines_.clear();
    centers_.clear();
  }
  bool isEmpty() const { return lines_.empty() && centers_.empty(); }

  /// What a segment adds within `radius` of t, clipped to that; note(Added) is called for each curve.
  template <typename Note>
  void add(Line segment, const Vec2& t, double radius, Note&& note) {
    if (margin_ == 0) {
      segment.clip(t, radius);
      return note(addLine(segment));
    }
    const Vec2 aside = margin_ * Vec2(-segment.axis.y(), segment.axis.x());
    const auto addBeside = [&](const Vec2& v, const Vec2& w) {
      Line line({v, w}, false, noise_);
      if (!(line.length > 0 && line.comesNear(t, radius))) return;
      line.clip(t, radius);
      note(addLine(line));
    };
    addBeside(segment.v + aside, segment.w + aside);
    if (segment.both_sides) addBeside(segment.w - aside, segment.v - aside);
    for (const Vec2& center : {segment.v, segment.w})
      if (std::abs((center - t).norm() - margin_) <= radius) note(addCircle(center));
  }

  /// Calls offer(p, error) for every point of the curves' arrangement that may be the nearest one to 0 of a face: the
  /// nearest point of a curve, an end or a crossing; `error` is what p may be off by along the curves that cross there.
  /// And touch(p, along) where two of them touch, so that a face may end in a cusp there, along a unit vector or back.
  template <typename Offer, typename Touch>
  void forEachPossibleLimit(Offer offer, Touch touch) const {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Line& line = lines_[i];
      offerFoot(line, offer);
      for (std::size_t j = 0; j < i; ++j) offerCrossing(line, lines_[j], offer);
      for (const Vec2& center : centers_) offerCrossings(line, center, offer, touch);
    }
    for (std::size_t i = 0; i < centers_.size(); ++i) {
      const Vec2& center = centers_[i];
      const double length = center.norm();
      offer(length > resolution_ ? Vec2((1 - margin_ / length) * center) : Vec2(margin_, 0), 0.0);
      for (std::size_t j = 0; j < i; ++j) offerCrossings(center, centers_[j], offer, touch);
    }
  }

  /// Calls offer(p, error) where lines cross the segment v w; of what may bound a face nothing is left out.
  template <typename Offer>
  void forEachCrossing(const Vec2& v, const Vec2& w, Offer offer) const {
    for (const Line& line : lines_) {
      const Vec2 u = line.w - line.v;
      const double area = cross(u, w - v), length = u.norm() * (w - v).norm();
      if (!(std::abs(area) > 0x1p-40 * length)) continue;
      const double s = cross(v - line.v, w - v) / area;
      if (s >= -0x1p-20 && s <= 1 + 0x1p-20) offer(line.v + s * u, 2 * noise_ * length / std::abs(area));
    }
  }

  /// A way along which curves leave a point, and on which of its sides, seen along it, free translations may be.
  struct Ray {
    double angle;
    bool left, right;
  };
  /// Adds the rays of the curves through a point, and lessens `room` to what keeps off the others' reach and ends.
  /// Whether a circle is among them.
  bool addRays(const Vec2& p, std::vector<Ray>& rays, double& room) const;

 private:
  bool merged(Line& into, const Line& line) const;
  Added addLine(const Line& line);
  Added addCircle(const Vec2& center);

  /// From 0 to the nearest point p of a free face the way leads out of what bounds it there: it is a sum of normals
  /// that point to the left of lines, of which this is `left` long or more. None is needed beside a line that is free
  /// on both sides, nor where p is 0.
  bool leads(const Vec2& p, const Line& line, double left, double error) const {
    const double length = p.norm();
    return line.both_sides || left >= -(4 * resolution_ + error + line.slack * length) || length <= 4 * resolution_;
  }

  template <typename Offer>
  void offerFoot(const Line& line, Offer offer) const {
    const Vec2 p = nearestOnSegment(Vec2::Zero(), line.v, line.w);
    const bool is_foot = std::abs(line.axis.dot(p)) <= 4 * resolution_ + line.slack * p.norm();
    if (is_foot && leads(p, line, cross(line.axis, p), 0)) offer(p, 0.0);
  }

  template <typename Offer>
  void offerCrossing(const Line& line, const Line& other, Offer offer) const {
    const Vec2 u = line.w - line.v, w = other.w - other.v;
    const double area = cross(u, w);
    if (area == 0) return;
    const double s = cross(other.v - line.v, w) / area;
    if (!(s >= -0x1p-20 && s <= 1 + 0x1p-20)) return;
    const Vec2 p = line.v + s * u;
    const double error = 2 * noise_ * u.norm() * w.norm() / std::abs(area), turn = area > 0 ? 1 : -1;
    const double slack = error + (line.slack + other.slack) * p.norm();
    if (!leads(p, line, turn * p.dot(other.axis), slack) || !leads(p, other, -turn * p.dot(line.axis), slack)) return;
    if ((nearestOnSegment(p, other.v, other.w) - p).norm() <= resolution_) offer(p, error);
  }

  template <typename Offer, typename Touch>
  void offerCrossings(const Line& line, const Vec2& center, Offer offer, Touch touch) const {
    const Vec2 u = line.w - line.v, nearest = nearestOnSegment(center, line.v, line.w);
    const double length = u.norm();
    if (!(length > 0)) return;
    const Vec2 axis = u / length;
    if (std::abs((nearest - center).norm() - margin_) <= 2 * resolution_) touch(nearest, axis);
    const double away = std::abs(cross(axis, center - line.v)), middle = axis.dot(center - line.v);
    if (!(away < margin_ - resolution_)) return;
    const double half = std::sqrt((margin_ - away) * (margin_ + away));
    for (const double at : {middle - half, middle + half})
      if (at >= -resolution_ && at <= length + resolution_) offer(line.v + at * axis, 2 * noise_ * margin_ / half);
  }

  template <typename Offer, typename Touch>
  void offerCrossings(const Vec2& center, const Vec2& other, Offer offer, Touch touch) const {
    const Vec2 way = other - center, middle = center + way / 2;
    const double away = way.norm() / 2;
    if (std::abs(away - margin_) <= 2 * resolution_) touch(middle, Vec2(Vec2(-way.y(), way.x()) / (2 * away)));
    if (!(away > resolution_ && away < margin_ - resolution_)) return;
    const double half = std::sqrt((margin_ - away) * (margin_ + away)),
                 error = noise_ * margin_ / half * (margin_ / away);
    const Vec2 aside = half / (2 * away) * Vec2(-way.y(), way.x());
    offer(middle + aside, error);
    offer(middle - aside, error);
  }

  double margin_, noise_, resolution_;
  std::size_t most_ = 0;
  std::vector<Line> lines_;
  std::vector<Vec2> centers_;  ///< of circles, whose radius is the margin
};

}  // namespace tricover::detail
