// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "impact/time_interval.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// A vertex over an interval, seen from the other polygon: its places at both ends, and how far its way bends.
struct VertexWay {
  Double2 x, y;
  double chord_error;
};

/// An edge in its polygon's units, from S: where it begins, its axis and its length.
struct EdgeInUnits {
  EdgeInUnits() = default;
  EdgeInUnits(const Vec2& v, const Vec2& w) : x(v.x()), y(v.y()) {
    const double dx = w.x() - x, dy = w.y() - y, square = dx * dx + dy * dy;
    length = std::sqrt(square);
    if (square > 0x1p-900) ux = dx / length, uy = dy / length;
  }
  EdgeInUnits(const PolygonData& polygon, std::size_t position)
      : EdgeInUnits(polygon.inUnits(polygon.path[position]), polygon.inUnits(polygon.path[position + 1])) {}

  double half() const { return 0.5 * length; }
  /// A way across its line and along it, from its middle.
  struct Beside {
    Double2 aside, along;
  };
  Beside beside(const VertexWay& way) const {
    const Double2 rx = way.x - x, ry = way.y - y;
    return {ux * ry - uy * rx, ux * rx + uy * ry - half()};
  }

  double x, y, ux = 1, uy = 0, length;
};

/// A vertex that may come to an edge of the other polygon in an interval.
struct Approach {
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  double share = kNever;  ///< of the interval, before which the two don't meet
  double apart = kNever;  ///< at its begin
  double aim = 0;         ///< as in Rest
  bool touches = false;   ///< at the begin already
  bool is_exact = false;  ///< they touch after that share
  bool of_b = false;      ///< the vertex
  std::uint32_t vertex = 0, edge = 0;

  bool operator<(const Approach& other) const {
    return share != other.share ? share < other.share : apart < other.apart;
  }
};

/// The vertices of one polygon over an interval, seen from the other, which stands still, in that one's units. There a
/// vertex leaves the straight way between its places at both ends by a quarter of its chord error at most.
///
/// Rounding, beyond what MovingPair::error allows for, in units of U: turning differences f back by M^T 4.3 f; M^T M,
/// which isn't quite the identity, 64 r; M itself once more 10.1 A r + 7 r. So gaps are within twice that error.
class VertexView {
 public:
  VertexView(const SearchInterval& interval, bool of_b)
      : from_(of_b ? interval.pair.a : interval.pair.b),
        chord_error_(of_b ? interval.with_a : interval.with_b),
        of_b_(of_b) {
    const MovingPair& pair = interval.pair;
    const Places &p = of_b ? interval.a : interval.b, &q = of_b ? interval.b : interval.a;
    unit_ = from_.polygon->isPoint() ? 1 : from_.scale;  // a point has no units
    inverse_ = 1 / unit_;
    const double scale = (of_b ? pair.b : pair.a).scale * inverse_;
    const Double2 dx = (q.x - p.x) * inverse_, dy = (q.y - p.y) * inverse_;
    m00_ = (p.m00 * q.m00 + p.m10 * q.m10) * scale;
    m01_ = (p.m00 * q.m01 + p.m10 * q.m11) * scale;
    m10_ = (p.m01 * q.m00 + p.m11 * q.m10) * scale;
    m11_ = (p.m01 * q.m01 + p.m11 * q.m11) * scale;
    tx_ = p.m00 * dx + p.m10 * dy;
    ty_ = p.m01 * dx + p.m11 * dy;
    room_ = (pair.margin + 2 * pair.error) * inverse_;
    touch_ = (pair.margin + 4 * pair.error) * inverse_;
    if (interval.pull.most > 0 && (of_b ? interval.rates.a : interval.rates.b) == 0) {
      const Double2 x = interval.pull.x * inverse_, y = interval.pull.y * inverse_;
      pull_ = {interval.pull.most * inverse_, p.m00 * x + p.m10 * y, p.m01 * x + p.m11 * y};
    }
    if (chord_error_.by_distance > 0) pivot_ = from_.linear.transpose() * from_.arm * -inverse_;
  }

  VertexWay wayOf(double x, double y, double lever) const {
    const VertexWay way = {m00_ * x + m01_ * y + tx_, m10_ * x + m11_ * y + ty_, 0};
    const double distance =
        chord_error_.by_distance > 0 ? lengthAbove(way.x[0] - pivot_.x(), way.y[0] - pivot_.y()) * unit_ : 0;
    return {way.x, way.y, chord_error_.of(lever, distance) * inverse_};
  }

  /// What a straight way must not come within for its vertex to stay away.
  double reach(const VertexWay& way) const { return room_ + 0.25 * way.chord_error; }

  /// Whether the two may meet in the interval. If they may do so before `best` does, they are the best.
  bool approach(const VertexWay& way, const EdgeInUnits& edge, std::uint32_t vertex, std::uint32_t edge_number,
                Approach& best) const {
    const double half = edge.half();
    auto [n, t] = edge.beside(way);
    if (n[0] < 0) n = -n;
    if (t[0] < 0) t = -t;
    const double beyond = t[0] - half, apart = beyond > 0 ? std::sqrt(n[0] * n[0] + beyond * beyond) : n[0];
    // Written so that NaN is a touch.
    Approach found{0, apart, 0, !(apart > touch_), way.chord_error == 0, of_b_, vertex, edge_number};
    if (way.chord_error == 0) {
      if (apart > room_) found.share = entryOf(t, n, half);
    } else if (pull_.most == 0
                   ? cutByAxes(t, n, half, apart, room_, {way.chord_error, way.chord_error, way.chord_error}, found)
                   : cutByAxes(t, n, half, apart, room_, chordErrorsBeside(edge, beyond, n[0], way.chord_error),
                               found)) {
      return false;
    }
    if (!(found.share <= 1)) return false;
    if (found < best) best = found;
    return true;
  }

  /// Whether the two touch at the interval's end, or have passed each other by then.
  bool touchByEnd(const VertexWay& way, const EdgeInUnits& edge) const {
    const auto [aside, along] = edge.beside(way);
    const Double2 beyond = absolute(along) - edge.half();
    const bool passed = aside[0] * aside[1] < 0 && std::max(beyond[0], beyond[1]) < -reach(way);
    const double past = std::max(beyond[1], 0.0);
    return passed || !(std::sqrt(aside[1] * aside[1] + past * past) > touch_);
  }

 private:
  /// The share at which a straight way comes within the room around an edge from -half to half, where it isn't at its
  /// begin: beside the edge or, if it isn't there by then, around the end that it is beyond. Each root is that of a way
  /// moved aside by a few roundings of the coordinates, however flat it is.
  double entryOf(Double2 along, Double2 aside, double half) const {
    const Vec2 way(along[1] - along[0], aside[1] - aside[0]);
    double at = along[0];
    if (aside[0] > room_) {
      const double share = (room_ - aside[0]) / way.y();
      if (!(way.y() < 0 && share <= 1)) return Approach::kNever;
      at += share * way.x();
      if (std::abs(at) <= half) return share;
    }
    const Vec2 from_end(along[0] - std::copysign(half, at), aside[0]);
    const double length = way.norm(), ahead = -from_end.dot(way);
    if (!(ahead > 0 && length > 0)) return Approach::kNever;
    const double past = std::abs(cross(from_end, way)) / length;
    if (!(past < room_)) return Approach::kNever;
    return std::max((ahead / length - std::sqrt((room_ - past) * (room_ + past))) / length, 0.0);
  }

  /// How far a way bends along an edge's normal, its axis, and from its end to the way's begin.
  struct ChordErrors {
    double aside, along, ahead;
  };
  /// Where the polygon stands still.
  ChordErrors chordErrorsBeside(const EdgeInUnits& edge, double beyond, double aside, double chord_error) const {
    const Vec2 u(edge.ux, edge.uy), v(-edge.uy, edge.ux), along = beyond * u, up = aside * v;
    // On which side of the edge's middle and line the way begins isn't known any more: so either slope.
    const auto spared = [&](const Vec2& axis) { return pull_.sparedAlong(axis.x(), axis.y()); };
    return {chord_error - spared(v), chord_error - spared(u),
            chord_error - std::min(spared((along + up).normalized()), spared((along - up).normalized()))};
  }

  /// Whether a bent way is parted from such an edge by its normal, its axis, or that from its end to the way's begin;
  /// or else from where on it may not be.
  static bool cutByAxes(Double2 t, Double2 n, double half, double apart, double room, const ChordErrors& chord_errors,
                        Approach& found) {
    CutSide first, last;
    const double beyond = t[0] - half;
    if (first.offer(n[0] - room, n[1] - room, chord_errors.aside)) return true;
    if (first.offer(beyond - room, t[1] - half - room, chord_errors.along)) return true;
    if (beyond > 0) {
      const double end = (beyond * (t[1] - half) + n[0] * n[1]) / apart;
      if (first.offer(apart - room, end - room, chord_errors.ahead)) return true;
    }
    if (n[1] < 0) n = -n;
    if (t[1] < 0) t = -t;
    if (last.offer(n[1] - room, n[0] - room, chord_errors.aside)) return true;
    if (last.offer(t[1] - half - room, t[0] - half - room, chord_errors.along)) return true;
    found.share = first.share();
    found.aim = first.aim();
    return found.share > 1 - last.share();
  }

  const Mover& from_;
  const TurningChordError& chord_error_;
  bool of_b_;
  double unit_, inverse_, room_, touch_;  ///< in units: what a gap must exceed, and what is near enough
  Double2 m00_, m01_, m10_, m11_, tx_, ty_;
  Vec2 pivot_;  ///< of the polygon that is looked from
  Pull pull_;   ///< in its units, where it stands still
};

/// How far a vertex, in units, is from its polygon's pivot, at the most; in the pair's length.
double leverOf(const Mover& mover, const Vec2& vertex);

/// The share of the interval that contact of two edges may lie in, which are apart at its begin; none if low > high. By
/// their ends one by one: an end near its pivot moves by little, however far the other one does.
Rest restOfEdges(const SearchInterval& interval, std::size_t edge_a, std::size_t edge_b);

}  // namespace tricover::detail
