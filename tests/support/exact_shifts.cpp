// SPDX-License-Identifier: BSD-3-Clause
#include "exact_shifts.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace tricover::exact {
namespace {

struct Vector {
  mpq_class x, y;
  friend Vector operator-(const Vector& p, const Vector& q) { return {p.x - q.x, p.y - q.y}; }
};

mpq_class cross(const Vector& p, const Vector& q) { return p.x * q.y - p.y * q.x; }
mpq_class dot(const Vector& p, const Vector& q) { return p.x * q.x + p.y * q.y; }
Vector exactly(const Vec2& p) { return {mpq_class(p.x()), mpq_class(p.y())}; }

/// Rounded down, but for perfect squares.
mpq_class rootOf(const mpq_class& square) {
  const mpf_class number(square, 320);
  return mpq_class(sqrt(number));
}

struct PosedRegion {
  PosedRegion(const Polygon& polygon, const Pose& pose) : fill(polygon.fillRule()) {
    const auto& m = pose.matrix();
    const auto place = [&](const Vec2& v) {
      const Vector p = exactly(v);
      return Vector{mpq_class(m(0, 0)) * p.x + mpq_class(m(0, 1)) * p.y + mpq_class(m(0, 2)),
                    mpq_class(m(1, 0)) * p.x + mpq_class(m(1, 1)) * p.y + mpq_class(m(1, 2))};
    };
    for (const Ring& ring : polygon.rings()) {
      starts.push_back(place(ring[0]));
      for (std::size_t i = 0; i < ring.size(); ++i)
        edges.emplace_back(place(ring[i]), place(ring[i + 1 < ring.size() ? i + 1 : 0]));
    }
  }

  /// Of a point that is on no edge.
  bool holds(const Vector& p) const {
    int winding = 0;
    for (const auto& [v, w] : edges) {
      if ((v.y <= p.y) == (w.y <= p.y)) continue;
      const int side = sgn(cross(w - v, p - v));
      if (v.y <= p.y && side > 0) ++winding;
      if (v.y > p.y && side < 0) --winding;
    }
    return fill == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
  }

  std::vector<std::pair<Vector, Vector>> edges;
  std::vector<Vector> starts;
  FillRule fill;
};

/// The times at which all conditions hold.
class Cut {
 public:
  /// at_0 + t slope >= 0.
  void require(const mpq_class& at_0, const mpq_class& slope) {
    if (slope == 0) {
      if (at_0 < 0) is_empty_ = true;
      return;
    }
    const mpq_class root = -at_0 / slope;
    if (slope > 0 && root > begin_) begin_ = root;
    if (slope < 0 && root < end_) end_ = root;
  }
  void unite(std::optional<TimeInterval>& all) const {
    if (is_empty_ || begin_ > end_) return;
    if (!all) all = TimeInterval{begin_, end_};
    if (begin_ < all->begin) all->begin = begin_;
    if (end_ > all->end) all->end = end_;
  }

 private:
  mpq_class begin_ = 0, end_ = 1;
  bool is_empty_ = false;
};

/// When the point t `by` is within the margin of a convex ring of four corners, possibly flat.
std::optional<TimeInterval> timesNear(const Vector (&corner)[4], const Vector& by, const mpq_class& margin) {
  std::optional<TimeInterval> all;
  const mpq_class area = cross(corner[1] - corner[0], corner[3] - corner[0]), square = dot(by, by);
  Cut inside;
  for (int i = 0; i < 4; ++i) {
    const Vector &v = corner[i], side = corner[(i + 1) % 4] - v;
    // Beside a side.
    const mpq_class at_0 = cross(v, side), slope = -cross(by, side), length = dot(side, side);
    if (area != 0) area > 0 ? inside.require(at_0, slope) : inside.require(-at_0, -slope);
    if (length != 0) {
      const mpq_class reach = margin == 0 ? mpq_class(0) : mpq_class(margin * rootOf(length));
      Cut beside;
      beside.require(reach - at_0, -slope);
      beside.require(reach + at_0, slope);
      beside.require(-dot(v, side), dot(by, side));
      beside.require(length + dot(v, side), -dot(by, side));
      beside.unite(all);
    }
    // Around a corner.
    const mpq_class ahead = dot(v, by), left = ahead * ahead - square * (dot(v, v) - margin * margin);
    if (left < 0 || (square == 0 && dot(v, v) > margin * margin)) continue;
    Cut around;
    if (square != 0) {
      const mpq_class root = left == 0 ? mpq_class(0) : rootOf(left);
      around.require(root - ahead, square);
      around.require(root + ahead, -square);
    }
    around.unite(all);
  }
  if (area != 0) inside.unite(all);
  return all;
}

std::vector<TimeInterval> merged(std::vector<TimeInterval> all) {
  std::sort(all.begin(), all.end(), [](const auto& p, const auto& q) { return p.begin < q.begin; });
  std::vector<TimeInterval> result;
  for (const TimeInterval& interval : all) {
    if (result.empty() || interval.begin > result.back().end)
      result.push_back(interval);
    else if (interval.end > result.back().end)
      result.back().end = interval.end;
  }
  return result;
}

}  // namespace

std::vector<TimeInterval> contactsOfShifts(const Polygon& polygon_a, const Motion& motion_a, const Polygon& polygon_b,
                                           const Motion& motion_b, const mpq_class& margin) {
  const PosedRegion a(polygon_a, motion_a.start), b(polygon_b, motion_b.start);
  const Vector by = exactly(motion_b.shift) - exactly(motion_a.shift);
  std::vector<TimeInterval> all;
  for (const auto& [v, w] : a.edges)
    for (const auto& [p, q] : b.edges) {
      const Vector corner[] = {v - p, w - p, w - q, v - q};
      if (const auto times = timesNear(corner, by, margin)) all.push_back(*times);
    }
  all = merged(all);
  // Between them, one may hold the other.
  mpq_class last = 0;
  const std::size_t count = all.size();
  for (std::size_t i = 0; i <= count; ++i) {
    const mpq_class next = i < count ? all[i].begin : mpq_class(1), middle = (last + next) / 2;
    const Vector moved{by.x * middle, by.y * middle};
    const auto holds = [](const PosedRegion& one, const PosedRegion& other, const Vector& against) {
      return std::any_of(other.starts.begin(), other.starts.end(),
                         [&](const Vector& p) { return one.holds(p - against); });
    };
    const Vector back{-moved.x, -moved.y};
    if (last < next && (holds(a, b, back) || holds(b, a, moved))) all.push_back({last, next});
    if (i < count) last = all[i].end;
  }
  return merged(all);
}

}  // namespace tricover::exact
