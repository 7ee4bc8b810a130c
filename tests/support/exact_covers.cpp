// SPDX-License-Identifier: BSD-3-Clause
#include "exact_covers.h"

#include <gmpxx.h>

#include <algorithm>
#include <cstddef>

namespace tricover::exact {
namespace {

struct Point {
  mpq_class x, y;
};
bool operator==(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }

Point between(const Point& p, const Point& q, const mpq_class& s) {
  return {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)};
}

mpq_class area(const Point& p, const Point& q, const Point& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Of region `of`, where 0 is the part's.
struct Edge {
  Point v, w;
  std::size_t of;
};

bool isOn(const Point& p, const Edge& e) {
  const auto isWithin = [](const mpq_class& x, const mpq_class& a, const mpq_class& b) {
    return std::min(a, b) <= x && x <= std::max(a, b);
  };
  return isWithin(p.x, e.v.x, e.w.x) && isWithin(p.y, e.v.y, e.w.y) && area(e.v, e.w, p) == 0;
}

bool meet(const Edge& e, const Edge& f) {
  return isOn(e.v, f) || isOn(e.w, f) || isOn(f.v, e) || isOn(f.w, e) ||
         (sgn(area(e.v, e.w, f.v)) * sgn(area(e.v, e.w, f.w)) < 0 &&
          sgn(area(f.v, f.w, e.v)) * sgn(area(f.v, f.w, e.w)) < 0);
}

mpq_class squareToSegment(const Point& p, const Edge& e) {
  const mpq_class ux = e.w.x - e.v.x, uy = e.w.y - e.v.y, square = ux * ux + uy * uy;
  mpq_class s = 0;
  if (square != 0) s = std::clamp<mpq_class>(((p.x - e.v.x) * ux + (p.y - e.v.y) * uy) / square, 0, 1);
  const Point q = between(e.v, e.w, s);
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

mpq_class squareBetween(const Edge& e, const Edge& f) {
  if (meet(e, f)) return 0;
  return std::min(std::min(squareToSegment(e.v, f), squareToSegment(e.w, f)),
                  std::min(squareToSegment(f.v, e), squareToSegment(f.w, e)));
}

class Plane {
 public:
  Plane(const std::vector<BodyPlacement>& areas, const Polygon& part, const Pose& pose) {
    add(part, pose);
    for (const BodyPlacement& body : areas) add(body.polygon, body.pose);
  }

  bool isCovered() const {
    if (hasGap(std::vector<int>(fills_.size()))) return false;  // far away
    for (const Edge& e : edges_) {
      if (e.of != 0) continue;
      for (const Point& p : middlesOf(e))
        if (!isInUnion(p)) return false;
    }
    std::vector<mpq_class> breaks;
    for (const Edge& e : edges_)
      for (const mpq_class& s : cutsOf(e)) breaks.push_back(between(e.v, e.w, s).x);
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      if (!isCoveredAt((breaks[i] + breaks[i + 1]) / 2)) return false;
    return true;
  }

  /// Whether a boundary of the union is nearer to the part's edges.
  bool hasBoundaryWithin(const mpq_class& margin) const {
    for (const Edge& e : edges_) {
      if (e.of == 0) continue;
      if (e.v == e.w) {
        if (isNear(e, margin) && !isOnAnother(e)) return true;
        continue;
      }
      const std::vector<mpq_class> cuts = cutsOf(e);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Edge piece{between(e.v, e.w, cuts[i]), between(e.v, e.w, cuts[i + 1]), e.of};
        if (isNear(piece, margin) && isBoundary(piece)) return true;
      }
    }
    return false;
  }

 private:
  void add(const Polygon& polygon, const Pose& pose) {
    const auto& m = pose.matrix();
    const auto at = [&](const Vec2& p, int row) -> mpq_class {
      return mpq_class(m(row, 0)) * p.x() + mpq_class(m(row, 1)) * p.y() + mpq_class(m(row, 2));
    };
    for (const Ring& ring : polygon.rings()) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &v = ring[i], &w = ring[(i + 1) % ring.size()];
        edges_.push_back({{at(v, 0), at(v, 1)}, {at(w, 0), at(w, 1)}, fills_.size()});
      }
    }
    fills_.push_back({polygon.fillRule(), polygon.isComplement()});
  }

  bool isFilled(std::size_t of, int winding) const {
    const bool is_wound = fills_[of].rule == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0;
    return is_wound != fills_[of].is_complement;
  }
  /// Whether the part is filled where nothing else is.
  bool hasGap(const std::vector<int>& windings) const {
    if (!isFilled(0, windings[0])) return false;
    for (std::size_t of = 1; of < fills_.size(); ++of)
      if (isFilled(of, windings[of])) return false;
    return true;
  }

  int windingAround(const Point& p, std::size_t of) const {
    int winding = 0;
    for (const Edge& e : edges_) {
      if (e.of != of) continue;
      if (e.v.y <= p.y && p.y < e.w.y && area(e.v, e.w, p) > 0) ++winding;
      if (e.w.y <= p.y && p.y < e.v.y && area(e.v, e.w, p) < 0) --winding;
    }
    return winding;
  }
  bool isIn(const Point& p, std::size_t of) const {
    const auto holds = [&](const Edge& e) { return e.of == of && isOn(p, e); };
    return std::any_of(edges_.begin(), edges_.end(), holds) || isFilled(of, windingAround(p, of));
  }
  bool isInUnion(const Point& p) const {
    for (std::size_t of = 1; of < fills_.size(); ++of)
      if (isIn(p, of)) return true;
    return false;
  }
  /// Whether the union has more around an edge without length than points.
  bool isOnAnother(const Edge& point) const {
    for (std::size_t of = 1; of < fills_.size(); ++of)
      if (isFilled(of, windingAround(point.v, of))) return true;
    return std::any_of(edges_.begin(), edges_.end(),
                       [&](const Edge& e) { return e.of != 0 && !(e.v == e.w) && isOn(point.v, e); });
  }

  /// Where on an edge others meet it, from 0 to 1, sorted.
  std::vector<mpq_class> cutsOf(const Edge& e) const {
    const mpq_class ux = e.w.x - e.v.x, uy = e.w.y - e.v.y, square = ux * ux + uy * uy;
    std::vector<mpq_class> cuts{0, 1};
    if (square == 0) return cuts;
    const auto cut = [&](const mpq_class& s) {
      if (0 < s && s < 1) cuts.push_back(s);
    };
    for (const Edge& f : edges_) {
      const mpq_class fx = f.w.x - f.v.x, fy = f.w.y - f.v.y, slant = ux * fy - uy * fx;
      if (slant != 0) {
        if (meet(e, f)) cut(((f.v.x - e.v.x) * fy - (f.v.y - e.v.y) * fx) / slant);
      } else if (area(e.v, e.w, f.v) == 0) {
        for (const Point& p : {f.v, f.w}) cut(((p.x - e.v.x) * ux + (p.y - e.v.y) * uy) / square);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }
  std::vector<Point> middlesOf(const Edge& e) const {
    if (e.v == e.w) return {e.v};
    const std::vector<mpq_class> cuts = cutsOf(e);
    std::vector<Point> middles;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) middles.push_back(between(e.v, e.w, (cuts[i] + cuts[i + 1]) / 2));
    return middles;
  }

  /// On the vertical through x, which meets no vertex and no crossing.
  bool isCoveredAt(const mpq_class& x) const {
    struct Step {
      mpq_class y;
      std::size_t of;
      int turn;
    };
    std::vector<Step> steps;
    for (const Edge& e : edges_) {
      if ((e.v.x < x) == (e.w.x < x)) continue;
      steps.push_back({e.v.y + (x - e.v.x) * (e.w.y - e.v.y) / (e.w.x - e.v.x), e.of, e.v.x < e.w.x ? 1 : -1});
    }
    std::sort(steps.begin(), steps.end(), [](const Step& p, const Step& q) { return p.y < q.y; });
    std::vector<int> windings(fills_.size());
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
      windings[steps[i].of] += steps[i].turn;
      if (steps[i].y != steps[i + 1].y && hasGap(windings)) return false;
    }
    return true;
  }

  bool isNear(const Edge& piece, const mpq_class& margin) const {
    return std::any_of(edges_.begin(), edges_.end(),
                       [&](const Edge& e) { return e.of == 0 && squareBetween(piece, e) < margin * margin; });
  }

  /// Whether the union isn't on both sides of a piece: looked at so near its middle that no other edge is between.
  bool isBoundary(const Edge& piece) const {
    const Point middle = between(piece.v, piece.w, mpq_class(1, 2));
    for (const int side : {-1, 1}) {
      mpq_class step(side, 2);
      const auto at = [&] {
        return Point{middle.x - step * (piece.w.y - piece.v.y), middle.y + step * (piece.w.x - piece.v.x)};
      };
      const auto isBetween = [&](const Edge& e) { return !isOn(middle, e) && meet({middle, at(), 0}, e); };
      while (std::any_of(edges_.begin(), edges_.end(), isBetween)) step /= 2;
      if (!isInUnion(at())) return true;
    }
    return false;
  }

  struct Fill {
    FillRule rule;
    bool is_complement;
  };
  std::vector<Edge> edges_;
  std::vector<Fill> fills_;
};

}  // namespace

bool covers(const std::vector<BodyPlacement>& areas, const Polygon& part, const Pose& pose, double margin) {
  const Plane plane(areas, part, pose);
  return plane.isCovered() && !(margin > 0 && plane.hasBoundaryWithin(margin));
}

}  // namespace tricover::exact
