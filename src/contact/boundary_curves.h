// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "numbers/segment.h"

namespace tricover::detail {

/// In the plane of translations what may bound the free ones within a cell: convolution segments; or, with a margin,
/// lines beside them and circles around their ends.
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
    Vec2 axis;
    double length;
  };
  enum Added { New, Repeated, TooMany };

  void clear() {
    lines_.clear();
    centers_.clear();
  }
  bool isEmpty() const { return lines_.empty() && centers_.empty(); }

  /// What a segment adds within `radius` of t, clipped to that; note(Added) is called for each curve.
  template <typename Note>
  void add(const Ends& segment, const Vec2& t, double radius, Note note) {
    if (margin_ == 0) return note(addLine(clipped(segment, t, radius)));
    const Vec2 along = segment.w - segment.v, aside = margin_ * Vec2(-along.y(), along.x()).stableNormalized();
    for (const Vec2& by : {aside, Vec2(-aside)}) {
      const Ends line{segment.v + by, segment.w + by};
      if (!along.isZero(0) && squaredDistanceToSegment(t, line.v, line.w) <= radius * radius)
        note(addLine(clipped(line, t, radius)));
    }
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
      offer(nearestOnSegment(Vec2::Zero(), line.v, line.w), 0.0);
      if (margin_ == 0) {  // otherwise the boundary goes on smoothly there
        offer(line.v, 0.0);
        offer(line.w, 0.0);
      }
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

  /// Adds the angles at which curves leave a point that they pass, and lessens `room` to what keeps off the others'
  /// reach and ends. Whether a circle is among them.
  bool addRays(const Vec2& p, std::vector<double>& rays, double& room) const;

 private:
  /// Cells with no more curves than this are decided; others are split.
  static constexpr std::size_t kMost = 12;

  static Line clipped(const Ends& line, const Vec2& center, double radius);
  bool merged(Line& into, const Line& line) const;
  Added addLine(const Line& line);
  Added addCircle(const Vec2& center);

  template <typename Offer>
  void offerCrossing(const Line& line, const Line& other, Offer offer) const {
    const Vec2 u = line.w - line.v, w = other.w - other.v;
    const double area = cross(u, w);
    if (area == 0) return;
    const double s = cross(other.v - line.v, w) / area;
    const Vec2 p = line.v + s * u;
    if (s >= -0x1p-20 && s <= 1 + 0x1p-20 && (nearestOnSegment(p, other.v, other.w) - p).norm() <= resolution_)
      offer(p, 2 * noise_ * u.norm() * w.norm() / std::abs(area));
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
  std::vector<Line> lines_;
  std::vector<Vec2> centers_;  ///< of circles, whose radius is the margin
};

}  // namespace tricover::detail
