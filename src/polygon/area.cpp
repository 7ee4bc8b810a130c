// SPDX-License-Identifier: BSD-3-Clause
// The area and the centroid of a region, by what its fill rule calls inside: a sweep from the lowest vertex to the
// highest one.
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "numbers/predicates.h"
#include "polygon/covering.h"
#include "polygon/edge_walk.h"
#include "polygon/polygon_data.h"

namespace tricover {
namespace detail {
namespace {

/// The area of a region, or of a piece of it, and its first moments.
struct Moments {
  double area = 0, x = 0, y = 0;

  void add(const Moments& other, double factor) {
    area += factor * other.area;
    x += factor * other.x;
    y += factor * other.y;
  }
};

/// An edge that isn't level, in units, from its lower end to its upper one.
struct RisingEdge {
  Vec2 low, high;
  int winding;  ///< what crossing it to the right adds to the winding number

  double xAt(double y) const {
    if (y <= low.y()) return low.x();
    if (y >= high.y()) return high.x();
    const double part = (y - low.y()) / (high.y() - low.y());
    return (1 - part) * low.x() + part * high.x();
  }
};

/// An edge within a slab.
struct SlabEdge {
  const RisingEdge* edge;
  double bottom, top;  ///< its x there

  double xAt(double part) const { return (1 - part) * bottom + part * top; }
};

std::vector<RisingEdge> risingEdges(const PolygonData& polygon) {
  std::vector<RisingEdge> edges;
  edges.reserve(polygon.path.size());
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (EdgePosition e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      const Vec2 v = polygon.inUnits(polygon.path[e]), w = polygon.inUnits(polygon.path[e + 1]);
      if (v.y() < w.y()) edges.push_back({v, w, -1});
      if (w.y() < v.y()) edges.push_back({w, v, 1});
    }
  return edges;
}

/// The moments of the trapezoid between x = 0 and an edge, from one height to another.
Moments leftOf(double x, double y, double x_above, double y_above) {
  const double h = y_above - y;
  return {0.5 * h * (x + x_above), h / 6 * (x * x + x * x_above + x_above * x_above),
          h / 6 * (y * (2 * x + x_above) + y_above * (x + 2 * x_above))};
}

/// Slabs between neighbouring heights of vertices, from below. Their sides, from left to right, change places where
/// they cross, one pair after another; so a side that is taken for left of another one by mistake is so near to it
/// that it matters as little as rounding does.
class AreaSweep {
 public:
  explicit AreaSweep(const PolygonData& polygon) : fill_(polygon.fill), edges_(risingEdges(polygon)) {
    std::sort(edges_.begin(), edges_.end(),
              [](const RisingEdge& p, const RisingEdge& q) { return p.low.y() < q.low.y(); });
    std::vector<double> heights;
    heights.reserve(2 * edges_.size());
    for (const RisingEdge& edge : edges_) heights.insert(heights.end(), {edge.low.y(), edge.high.y()});
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i) sweepSlab(heights[i - 1], heights[i]);
  }

  const Moments& sum() const { return sum_; }

 private:
  void sweepSlab(double bottom, double top) {
    const auto ends = [&](const SlabEdge& side) { return side.edge->high.y() <= bottom; };
    sides_.erase(std::remove_if(sides_.begin(), sides_.end(), ends), sides_.end());
    for (; next_ < edges_.size() && edges_[next_].low.y() <= bottom; ++next_) sides_.push_back({&edges_[next_], 0, 0});
    for (SlabEdge& side : sides_) side.bottom = side.edge->xAt(bottom), side.top = side.edge->xAt(top);
    sort();
    double part = 0;
    for (std::size_t left; (left = nextCrossing()) < sides_.size();) {
      const double at = std::max(part, partOf(left));
      addBetween(bottom, top, part, at);
      std::swap(sides_[left], sides_[left + 1]);
      part = at;
    }
    addBetween(bottom, top, part, 1);
  }

  /// By insertion: most sides stand as they did in the slab below.
  void sort() {
    const auto isLeft = [](const SlabEdge& p, const SlabEdge& q) {
      return p.bottom != q.bottom ? p.bottom < q.bottom : p.top < q.top;
    };
    for (std::size_t i = 1; i < sides_.size(); ++i) {
      const SlabEdge side = sides_[i];
      std::size_t place = i;
      for (; place > 0 && isLeft(side, sides_[place - 1]); --place) sides_[place] = sides_[place - 1];
      sides_[place] = side;
    }
  }

  /// Where a side meets the next one, as a part of the slab's height.
  double partOf(std::size_t left) const {
    const SlabEdge &p = sides_[left], &q = sides_[left + 1];
    const double below = q.bottom - p.bottom, above = p.top - q.top;
    return std::clamp(below / (below + above), 0.0, 1.0);
  }

  /// The first pair of neighbours that are yet to change places; the number of sides if there is none.
  std::size_t nextCrossing() const {
    std::size_t first = sides_.size();
    for (std::size_t i = 0; i + 1 < sides_.size(); ++i)
      if (sides_[i + 1].top < sides_[i].top && (first == sides_.size() || partOf(i) < partOf(first))) first = i;
    return first;
  }

  /// Between two parts of the slab's height.
  void addBetween(double bottom, double top, double from, double until) {
    if (!(from < until)) return;
    const double y = (1 - from) * bottom + from * top, y_above = (1 - until) * bottom + until * top;
    Moments sum;
    int winding = 0;
    for (const SlabEdge& side : sides_) {
      const int right = winding + side.edge->winding;
      const int is_end = isInside(fill_, winding) - isInside(fill_, right);
      if (is_end != 0) sum.add(leftOf(side.xAt(from), y, side.xAt(until), y_above), is_end);
      winding = right;
    }
    sum_.add(sum, 1);
  }

  const Fill fill_;
  std::vector<RisingEdge> edges_;
  std::size_t next_ = 0;  ///< the first edge that begins above
  std::vector<SlabEdge> sides_;
  Moments sum_;
};

/// Whether the region has an area. It has none exactly if the edges on every line cancel: then no edge separates inside
/// from outside. One line of edges that don't cancel proves an area, and most polygons have it first.
bool hasArea(const PolygonData& polygon) {
  // By the edge's ends, in their order: by how much crossing it changes the winding number.
  std::map<std::array<OrderedPoint, 2>, int> windings;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (EdgePosition e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      const OrderedPoint v = ordered(polygon.path[e]), w = ordered(polygon.path[e + 1]);
      if (v != w) windings[{std::min(v, w), std::max(v, w)}] += v < w ? 1 : -1;
    }
  std::vector<std::pair<std::array<OrderedPoint, 2>, int>> edges;
  for (const auto& edge : windings)
    if (isInside(polygon.fill, edge.second)) edges.push_back(edge);
  for (auto begin = edges.begin(); begin != edges.end();) {
    const Vec2 first(begin->first[0].data()), last(begin->first[1].data());
    const auto isOn = [&](const OrderedPoint& p) { return orientation(first, last, Vec2(p.data())) == 0; };
    const auto end = std::partition(begin, edges.end(),
                                    [&](const auto& edge) { return isOn(edge.first[0]) && isOn(edge.first[1]); });
    std::map<OrderedPoint, int> steps;
    for (; begin != end; ++begin) {
      steps[begin->first[0]] += begin->second;
      steps[begin->first[1]] -= begin->second;
    }
    int winding = 0;
    for (const auto& step : steps)
      if (isInside(polygon.fill, winding += step.second)) return true;
  }
  return false;
}

}  // namespace
}  // namespace detail

double Polygon::area() const {
  if (isComplement()) return std::numeric_limits<double>::infinity();
  const double unit = data_->unit;
  return std::max(0.0, detail::AreaSweep(*data_).sum().area) * unit * unit;
}

Vec2 Polygon::centroid() const {
  Eigen::AlignedBox2d box;
  for (const Vec2& vertex : data_->path) box.extend(vertex);
  const Vec2 middle = 0.5 * box.min() + 0.5 * box.max();
  if (isComplement() || !detail::hasArea(*data_)) return middle;
  const detail::Moments sum = detail::AreaSweep(*data_).sum();
  if (!(sum.area > 0)) return middle;
  const Vec2 center = data_->origin + Vec2(sum.x, sum.y) / sum.area * data_->unit;
  return center.allFinite() ? Vec2(center.cwiseMax(box.min()).cwiseMin(box.max())) : middle;
}

}  // namespace tricover
