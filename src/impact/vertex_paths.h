// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "impact/time_interval.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// A vertex over an interval, seen from the other polygon: its places at both ends, and how far its path bends.
struct VertexPath {
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
  EdgeInUnits(const Mover& mover, EdgePosition position)
      : EdgeInUnits(mover.inView(position), mover.inView(position + 1)) {}

  double half() const { return 0.5 * length; }
  /// A path across its line and along it, from its middle.
  struct AsideAlong {
    Double2 aside, along;
  };
  AsideAlong beside(const VertexPath& path) const {
    const Double2 rx = path.x - x, ry = path.y - y;
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
/// vertex leaves the straight path between its places at both ends by a quarter of its chord error at most.
///
/// Rounding, beyond what MovingPair::error allows for, in units of U: turning differences f back by M^T 4.3 f; M^T M,
/// which isn't quite the identity, 64 r; M itself once more 10.1 A r + 7 r. So gaps are within twice that error.
class VertexView {
 public:
  VertexView(const TimeInterval& interval, bool of_b)
      : from_(of_b ? interval.pair.a : interval.pair.b),
        chord_error_(of_b ? interval.with_a : interval.with_b),
        of_b_(of_b) {
    const MovingPair& pair = interval.pair;
    const Places &p = of_b ? interval.a : interval.b, &q = of_b ? interval.b : interval.a;
    unit_ = from_.view;
    inverse_ = 1 / unit_;
    scale_ = (of_b ? pair.b : pair.a).view * inverse_;
    seen_ = p.seen(q, inverse_);
    rounding_ = 2 * pair.error * inverse_;
    limit_ = (pair.margin + 2 * pair.error) * inverse_;
    touch_ = (pair.margin + 4 * pair.error) * inverse_;
    near_ = (pair.margin + 8 * pair.error) * inverse_;
    if (interval.pull.most > 0 && (of_b ? interval.rates.a : interval.rates.b) == 0) {
      const Double2 x = interval.pull.x * inverse_, y = interval.pull.y * inverse_;
      pull_ = {interval.pull.most * inverse_, p.m00 * x + p.m10 * y, p.m01 * x + p.m11 * y};
    }
    if (chord_error_.by_distance > 0) pivot_ = from_.linear.transpose() * from_.arm * -inverse_;
  }

  VertexPath pathOf(const Vec2& vertex, double lever) const {
    const double x = scale_ * vertex.x(), y = scale_ * vertex.y();
    const VertexPath path = {seen_.mappedX(x, y), seen_.mappedY(x, y), 0};
    const double distance =
        chord_error_.by_distance > 0 ? lengthAbove(path.x[0] - pivot_.x(), path.y[0] - pivot_.y()) * unit_ : 0;
    return {path.x, path.y, chord_error_.of(lever, distance) * inverse_};
  }

  /// What a straight path must not come within for its vertex to stay away.
  double reach(const VertexPath& path) const { return limit_ + 0.25 * path.chord_error; }
  /// The same beside the polygon as it is before it is stretched, all of it within 2 of S.
  double reachOfRing(const VertexPath& path) const { return reach(path) + 2 * from_.stretched; }

  /// Whether the two may meet in the interval. If they may do so before `best` does, they are the best.
  bool approach(const VertexPath& path, const EdgeInUnits& edge, std::uint32_t vertex, std::uint32_t edge_number,
                Approach& best) const {
    const double half = edge.half();
    auto [n, t] = edge.beside(path);
    if (n[0] < 0) n = -n;
    if (t[0] < 0) t = -t;
    const double beyond = t[0] - half, apart = beyond > 0 ? std::sqrt(n[0] * n[0] + beyond * beyond) : n[0];
    // Written so that NaN is a touch.
    Approach found{0, apart, 0, !(apart > touch_), path.chord_error == 0, of_b_, vertex, edge_number};
    if (path.chord_error == 0) {
      if (apart > limit_) found.share = entryOf(t, n, half);
    } else if (pull_.most == 0
                   ? cutByAxes(t, n, half, apart, limit_, {path.chord_error, path.chord_error, path.chord_error}, found)
                   : cutByAxes(t, n, half, apart, limit_, chordErrorsBeside(edge, beyond, n[0], path.chord_error),
                               found)) {
      return false;
    }
    if (!(found.share <= 1)) return false;
    if (found < best) best = found;
    return true;
  }

  /// Whether the vertex stays in contact with the edge. The distance of a straight path from an edge is convex, and so
  /// is the distance plus what the path bends across and along: it is most at an end. Each end counts with its own
  /// distances across and along, which may change in opposite ways.
  bool staysBeside(const VertexPath& path, const EdgeInUnits& edge) const {
    const auto [aside, along] = edge.beside(path);
    const Double2 across = absolute(aside) + 0.25 * (path.chord_error - pull_.sparedAlong(-edge.uy, edge.ux));
    const Double2 beyond =
        absolute(along) - edge.half() + 0.25 * (path.chord_error - pull_.sparedAlong(edge.ux, edge.uy));
    const auto isNear = [&](int end) { return std::hypot(across[end], std::max(beyond[end], 0.0)) <= near_; };
    return isNear(0) && isNear(1);
  }

  /// On which side of an edge's line the vertex stays: 1 on the left, -1 on the right, 0 if that isn't known.
  int sideOf(const VertexPath& path, const EdgeInUnits& edge) const {
    const Double2 aside = edge.beside(path).aside;
    const double off = rounding_ + 0.25 * (path.chord_error - pull_.sparedAlong(-edge.uy, edge.ux));
    return std::min(aside[0], aside[1]) > off ? 1 : std::max(aside[0], aside[1]) < -off ? -1 : 0;
  }

  /// Whether the two touch at the interval's end, or have passed each other by then.
  bool touchByEnd(const VertexPath& path, const EdgeInUnits& edge) const {
    const auto [aside, along] = edge.beside(path);
    const Double2 beyond = absolute(along) - edge.half();
    const bool passed = aside[0] * aside[1] < 0 && std::max(beyond[0], beyond[1]) < -reach(path);
    const double past = std::max(beyond[1], 0.0);
    return passed || !(std::sqrt(aside[1] * aside[1] + past * past) > touch_);
  }

 private:
  /// The share at which a straight path comes within the limit around an edge from -half to half, where it isn't at its
  /// begin: beside the edge or, if it isn't there by then, around the end that it is beyond. Each root is that of a
  /// path moved aside by a few roundings of the coordinates, however flat it is.
  double entryOf(Double2 along, Double2 aside, double half) const {
    const Vec2 path(along[1] - along[0], aside[1] - aside[0]);
    double at = along[0];
    if (aside[0] > limit_) {
      const double share = (limit_ - aside[0]) / path.y();
      if (!(path.y() < 0 && share <= 1)) return Approach::kNever;
      at += share * path.x();
      if (std::abs(at) <= half) return share;
    }
    const Vec2 from_end(along[0] - std::copysign(half, at), aside[0]);
    const double length = path.norm(), ahead = -from_end.dot(path);
    if (!(ahead > 0 && length > 0)) return Approach::kNever;
    const double past = std::abs(cross(from_end, path)) / length;
    if (!(past < limit_)) return Approach::kNever;
    return std::max((ahead / length - std::sqrt((limit_ - past) * (limit_ + past))) / length, 0.0);
  }

  /// How far a path bends along an edge's normal, its axis, and from its end to the path's begin.
  struct ChordErrors {
    double aside, along, ahead;
  };
  /// Where the polygon stands still.
  ChordErrors chordErrorsBeside(const EdgeInUnits& edge, double beyond, double aside, double chord_error) const {
    const Vec2 u(edge.ux, edge.uy), v(-edge.uy, edge.ux), along = beyond * u, up = aside * v;
    // On which side of the edge's middle and line the path begins isn't known any more: so either slope.
    const auto spared = [&](const Vec2& axis) { return pull_.sparedAlong(axis.x(), axis.y()); };
    return {chord_error - spared(v), chord_error - spared(u),
            chord_error - std::min(spared((along + up).normalized()), spared((along - up).normalized()))};
  }

  /// Whether a bent path is separated from such an edge by its normal, its axis, or that from its end to the path's
  /// begin; or else from where on it may not be.
  static bool cutByAxes(Double2 t, Double2 n, double half, double apart, double limit, const ChordErrors& chord_errors,
                        Approach& found) {
    CutSide first, last;
    const double beyond = t[0] - half;
    if (first.offer(n[0] - limit, n[1] - limit, chord_errors.aside)) return true;
    if (first.offer(beyond - limit, t[1] - half - limit, chord_errors.along)) return true;
    if (beyond > 0) {
      const double end = (beyond * (t[1] - half) + n[0] * n[1]) / apart;
      if (first.offer(apart - limit, end - limit, chord_errors.ahead)) return true;
    }
    if (n[1] < 0) n = -n;
    if (t[1] < 0) t = -t;
    if (last.offer(n[1] - limit, n[0] - limit, chord_errors.aside)) return true;
    if (last.offer(t[1] - half - limit, t[0] - half - limit, chord_errors.along)) return true;
    found.share = first.share();
    found.aim = first.aim();
    return found.share > 1 - last.share();
  }

  const Mover& from_;
  const RotatingChordError& chord_error_;
  bool of_b_;
  double unit_, inverse_, scale_;
  double rounding_;              ///< of gaps, in units
  double limit_, touch_, near_;  ///< in units: what a gap must exceed, what is near enough, and what stays in contact
  Places seen_;                  ///< the vertices' polygon, in units
  Vec2 pivot_;                   ///< of the polygon that is looked from
  Pull pull_;                    ///< in its units, where it stands still
};

/// How far a vertex, in units, is from its polygon's pivot, at the most; in the pair's length.
inline double leverOf(const Mover& mover, const Vec2& vertex) {
  const Vec2 lever = mover.arm + mover.view * (mover.linear * vertex);
  return lengthAbove(lever.x(), lever.y());
}

/// visit(view, path, edge, end) for each end of two edges beside the other one, until it returns true.
template <typename Visit>
bool anyEndBeside(const TimeInterval& interval, EdgePosition edge_a, EdgePosition edge_b, Visit visit) {
  for (const bool of_b : {false, true}) {
    const VertexView view(interval, of_b);
    const Mover &of = of_b ? interval.pair.b : interval.pair.a, &from = of_b ? interval.pair.a : interval.pair.b;
    const EdgePosition own = of_b ? edge_b : edge_a, other = of_b ? edge_a : edge_b;
    const EdgeInUnits edge(from, other);
    for (std::uint32_t end = 0; end < 2; ++end) {
      const Vec2 vertex = of.inView(own + end);
      if (visit(view, view.pathOf(vertex, leverOf(of, vertex)), edge, end)) return true;
    }
  }
  return false;
}

/// Whether an end of one of two edges stays in contact with the other one throughout.
inline bool endStaysBeside(const TimeInterval& interval, EdgePosition edge_a, EdgePosition edge_b) {
  return anyEndBeside(interval, edge_a, edge_b,
                      [](const VertexView& view, const VertexPath& path, const EdgeInUnits& edge, std::uint32_t) {
                        return view.staysBeside(path, edge);
                      });
}

/// Whether two edges cross throughout: the ends of either stay on different sides of the other one's line.
inline bool edgesStayCrossed(const TimeInterval& interval, EdgePosition edge_a, EdgePosition edge_b) {
  int sides[4], count = 0;
  anyEndBeside(interval, edge_a, edge_b,
               [&](const VertexView& view, const VertexPath& path, const EdgeInUnits& edge, std::uint32_t) {
                 sides[count++] = view.sideOf(path, edge);
                 return false;
               });
  return sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0;
}

/// The share of the interval that contact of two edges may lie in, which are apart at its begin; none if low > high. By
/// their ends one by one: an end near its pivot moves by little, however far the other one does.
inline Rest restOfEdges(const TimeInterval& interval, EdgePosition edge_a, EdgePosition edge_b) {
  Approach first;
  anyEndBeside(interval, edge_a, edge_b,
               [&](const VertexView& view, const VertexPath& path, const EdgeInUnits& edge, std::uint32_t end) {
                 view.approach(path, edge, end, 0, first);
                 return false;
               });
  return {first.share, 1, first.aim};
}

}  // namespace tricover::detail
