// SPDX-License-Identifier: BSD-3-Clause
// Contacts are as many as the overlap has components, which are counted by cutting the plane into cells.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "exact_depth.h"
#include "exact_reference.h"
#include "law.h"
#include "shapes.h"
#include "tricover/contacts.h"

namespace tricover::laws {
namespace {

using namespace support;

/// Different coordinates of these lattices' crossings differ by more.
constexpr double kSame = 1e-7;

struct Edge {
  Vec2 v, w;
  double at(double x) const { return v.y() + (x - v.x()) / (w.x() - v.x()) * (w.y() - v.y()); }
  bool isAcross(double x) const { return std::min(v.x(), w.x()) - kSame < x && x < std::max(v.x(), w.x()) + kSame; }
  bool isUpright() const { return std::abs(v.x() - w.x()) < kSame; }
};

double crossProduct(const Vec2& u, const Vec2& w) { return u.x() * w.y() - u.y() * w.x(); }

std::vector<Edge> edgesOf(const Polygon& polygon) {
  std::vector<Edge> edges;
  for (const Ring& ring : polygon.rings())
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return edges;
}

Location locationOf(const Polygon& polygon, const std::vector<Edge>& edges, const Vec2& p) {
  int winding = 0;
  for (const auto& [v, w] : edges) {
    const Vec2 u = w - v;
    const double length = u.norm(), along = length > 0 ? std::clamp((p - v).dot(u) / (length * length), 0.0, 1.0) : 0;
    if ((v + along * u - p).norm() < kSame) return Location::Boundary;
    if ((v.y() <= p.y()) == (w.y() <= p.y())) continue;
    if ((crossProduct(u, p - v) > 0) == (w.y() > v.y())) winding += w.y() > v.y() ? 1 : -1;
  }
  const bool inside = polygon.fillRule() == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0;
  return inside ? Location::Inside : Location::Outside;
}

/// Whether the region has its inside all around a point.
bool isInterior(const Polygon& polygon, const std::vector<Edge>& edges, const Vec2& p) {
  const Location location = locationOf(polygon, edges, p);
  if (location != Location::Boundary) return location == Location::Inside;
  std::vector<double> ways = {0};
  for (const auto& [v, w] : edges) {
    const Vec2 u = w - v;
    const double length = u.norm(), along = length > 0 ? std::clamp((p - v).dot(u) / (length * length), 0.0, 1.0) : 0;
    if (!((v + along * u - p).norm() < kSame)) continue;
    for (const Vec2& end : {v, w})
      if (!((end - p).norm() < kSame)) ways.push_back(std::atan2(end.y() - p.y(), end.x() - p.x()));
  }
  std::sort(ways.begin(), ways.end());
  ways.push_back(ways.front() + 2 * M_PI);
  for (std::size_t k = 0; k + 1 < ways.size(); ++k) {
    const double middle = (ways[k] + ways[k + 1]) / 2;
    if (ways[k + 1] - ways[k] < 1e-6) continue;
    if (locationOf(polygon, edges, p + 1e-4 * Vec2(std::cos(middle), std::sin(middle))) != Location::Inside)
      return false;
  }
  return true;
}

void sortAndMerge(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(), [](double p, double q) { return q - p < kSame; }),
               values.end());
}

struct Counts {
  std::size_t all = 0;
  std::size_t inner = 0;     ///< with an area
  std::size_t entering = 0;  ///< with a point of either region in the other one's interior
};

/// Cuts the plane into cells: at every x where edges end or cross, and between two of these. Along each such line there
/// are points on edges and intervals between. The overlap is the closed union of the cells that both regions hold.
class Cells {
 public:
  Cells(const Polygon& a, const Polygon& b) : a_(a), b_(b), edges_a_(edgesOf(a)), edges_b_(edgesOf(b)) {
    all_ = edges_a_;
    all_.insert(all_.end(), edges_b_.begin(), edges_b_.end());
    std::vector<double> lines;
    for (const Edge& e : all_) {
      lines.insert(lines.end(), {e.v.x(), e.w.x()});
      for (const Edge& f : all_) {
        const Vec2 u = e.w - e.v, w = f.w - f.v;
        if (std::abs(crossProduct(u, w)) < kSame) continue;
        const double s = crossProduct(f.v - e.v, w) / crossProduct(u, w),
                     t = crossProduct(f.v - e.v, u) / crossProduct(u, w);
        if (s > -kSame && s < 1 + kSame && t > -kSame && t < 1 + kSame) lines.push_back(e.v.x() + s * u.x());
      }
    }
    sortAndMerge(lines);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      addColumn(lines[k], lines[k], lines[k]);
      if (k + 1 < lines.size()) addColumn((lines[k] + lines[k + 1]) / 2, lines[k], lines[k + 1]);
    }
    for (std::size_t k = 1; k < columns_.size(); ++k) joinColumns(k);
  }

  Counts count() const {
    std::set<std::size_t> all, inner, entering;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (!cells_[k].held) continue;
      all.insert(find(k));
      if (cells_[k].is_area) inner.insert(find(k));
      if (cells_[k].enters) entering.insert(find(k));
    }
    return {all.size(), inner.size(), entering.size()};
  }

  /// The component that a point is in, which may be rounded; kNone.
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::size_t componentAt(const Vec2& p) const {
    for (const Column& column : columns_) {
      if (p.x() < column.left - kSame || column.right + kSame < p.x()) continue;
      const double width = column.right - column.left,
                   share = width > 0 ? std::clamp((p.x() - column.left) / width, 0.0, 1.0) : 0;
      for (std::size_t k = column.begin; k < column.end; ++k) {
        const Cell& cell = cells_[k];
        const double low = cell.left_low + share * (cell.right_low - cell.left_low),
                     high = cell.left_high + share * (cell.right_high - cell.left_high);
        if (cell.held && low - kSame < p.y() && p.y() < high + kSame) return find(k);
      }
    }
    return kNone;
  }

 private:
  struct Cell {
    bool held, is_area, enters;
    double left_low, left_high, right_low, right_high;  ///< its closure at its column's ends
  };
  struct Column {
    std::size_t begin, end;
    double left, right;
    bool isStrip() const { return left < right; }
  };

  /// At x, of which the cells reach from `left` to `right`.
  void addColumn(double x, double left, double right) {
    const bool is_strip = left < right;
    std::vector<double> ys;
    for (const Edge& e : all_) {
      if (e.isUpright() && !is_strip && e.isAcross(x)) ys.insert(ys.end(), {e.v.y(), e.w.y()});
      if (!e.isUpright() && e.isAcross(x)) ys.push_back(e.at(x));
    }
    sortAndMerge(ys);
    const auto yAt = [&](double y, double end) {
      for (const Edge& e : all_)
        if (is_strip && !e.isUpright() && e.isAcross(x) && std::abs(e.at(x) - y) < kSame) return e.at(end);
      return y;
    };
    const Column column{cells_.size(), cells_.size() + (ys.empty() ? 0 : 2 * ys.size() - 1), left, right};
    for (std::size_t k = 0; k < ys.size(); ++k) {
      addCell(x, ys[k], ys[k], left, right, yAt);
      if (k + 1 < ys.size()) addCell(x, ys[k], ys[k + 1], left, right, yAt);
    }
    for (std::size_t k = column.begin + 1; k < column.end; ++k)
      if (cells_[k - 1].held && cells_[k].held) join(k - 1, k);
    columns_.push_back(column);
  }

  template <typename YAt>
  void addCell(double x, double low, double high, double left, double right, YAt yAt) {
    const Vec2 p(x, (low + high) / 2);
    const Location in_a = locationOf(a_, edges_a_, p), in_b = locationOf(b_, edges_b_, p);
    const bool held = in_a != Location::Outside && in_b != Location::Outside;
    cells_.push_back({held, held && left < right && low < high,
                      held && (isInterior(a_, edges_a_, p) || isInterior(b_, edges_b_, p)), yAt(low, left),
                      yAt(high, left), yAt(low, right), yAt(high, right)});
    parent_.push_back(parent_.size());
  }

  void joinColumns(std::size_t k) {
    const Column &of_strip = columns_[columns_[k].isStrip() ? k : k - 1],
                 &of_line = columns_[columns_[k].isStrip() ? k - 1 : k];
    const bool line_is_left = columns_[k].isStrip();
    for (std::size_t i = of_strip.begin; i < of_strip.end; ++i) {
      if (!cells_[i].held) continue;
      const double low = line_is_left ? cells_[i].left_low : cells_[i].right_low,
                   high = line_is_left ? cells_[i].left_high : cells_[i].right_high;
      for (std::size_t j = of_line.begin; j < of_line.end; ++j)
        if (cells_[j].held && low < cells_[j].left_low + kSame && cells_[j].left_high < high + kSame) join(i, j);
    }
  }

  std::size_t find(std::size_t k) const {
    while (parent_[k] != k) k = parent_[k];
    return k;
  }
  void join(std::size_t i, std::size_t j) { parent_[find(i)] = find(j); }

  const Polygon &a_, &b_;
  std::vector<Edge> edges_a_, edges_b_, all_;
  std::vector<Cell> cells_;
  std::vector<Column> columns_;
  std::vector<std::size_t> parent_;
};

std::vector<Contact> found(const Polygon& a, const Polygon& b, ContactDetail detail,
                           const Pose& both = Pose::Identity(), Touching touching = Touching::Collides) {
  ContactOptions options;
  options.detail = detail;
  options.touching = touching;
  return contacts(a, both, b, both, options);
}

constexpr ContactDetail kDetails[] = {ContactDetail::Points, ContactDetail::LocalDepth, ContactDetail::GlobalDepth};

/// A spike without area is a component where it leads through an interior.
std::string wrongSpike(Random&, Tally&) {
  const Polygon a({{{1, 0}, {-1, 0}, {0, -1}, {0, 0}}}, FillRule::EvenOdd),
      b({{{0, -1}, {-2, 2}, {2, -1}, {0, 2}}}, FillRule::NonZero);
  const Counts truth = Cells(a, b).count();
  if (truth.all != 2 || truth.inner != 1 || truth.entering != 2) return "cells";
  for (const ContactDetail detail : kDetails) {
    const Pose here = Pose::Identity();
    if (found(a, b, detail).size() != 2 || found(a, b, detail, here, Touching::Allowed).size() != 2 ||
        found(b, a, detail, here, Touching::Allowed).size() != 2)
      return "a spike isn't one";
  }
  return {};
}

Ring latticeRing(Random& random) {
  Ring ring;
  for (int k = random.integer(3, 7); k > 0; --k) {
    ring.emplace_back(random.integer(-2, 2), random.integer(-2, 2));
    if (random.oneIn(6)) ring.push_back(ring.back());
    // A spike: there and back.
    if (ring.size() > 1 && random.oneIn(5)) ring.push_back(ring[ring.size() - 2]);
  }
  if (random.oneIn(3)) ring.push_back(ring.front());
  return ring;
}

Polygon latticePolygon(Random& random) {
  std::vector<Ring> rings = {latticeRing(random)};
  if (random.oneIn(4)) rings.push_back(latticeRing(random));
  return Polygon(rings, random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
}

constexpr int kCells = 12;

/// A ring whose edges run along the axes from grid point to grid point, crossing and covering each other at will.
Ring rectilinear(Random& random, int corners) {
  Ring ring;
  int x = random.integer(0, kCells), y = random.integer(0, kCells);
  const int first_x = x;
  for (int i = 0; i < corners; ++i) {
    ring.emplace_back(x, y);
    x = i + 1 < corners ? random.integer(0, kCells) : first_x;
    ring.emplace_back(x, y);
    y = random.integer(0, kCells);
  }
  ring.back().x() = first_x;
  ring.emplace_back(first_x, ring.front().y());
  return ring;
}

/// A ring without area: there and back along the grid, or one point.
Ring withoutArea(Random& random) {
  const Vec2 p(random.integer(0, kCells), random.integer(0, kCells));
  Vec2 q = p;
  (random.coin() ? q.x() : q.y()) = random.integer(0, kCells);
  if (random.oneIn(4)) return {p, q, p, Vec2(p.x(), random.integer(0, kCells))};
  return random.coin() ? Ring{p, q, q} : Ring{p, q, p};
}

Polygon anyRectilinear(Random& random) {
  std::vector<Ring> rings;
  // Beside others, or alone.
  if (random.oneIn(3))
    for (int i = random.integer(1, 3); i > 0; --i) rings.push_back(withoutArea(random));
  if (!rings.empty() && random.oneIn(4)) return Polygon(rings);
  for (int i = random.integer(1, 4); i > 0; --i) {
    const int x = random.integer(0, kCells - 1), y = random.integer(0, kCells - 1);
    rings.push_back(random.oneIn(3) ? rectilinear(random, random.integer(2, 4))
                                    : rectangle(x, y, random.integer(x + 1, kCells), random.integer(y + 1, kCells)));
  }
  return Polygon(redirected(random, std::move(rings)), random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
}

/// What is wrong with the contacts of a pair that both are posed by the same map, which leaves the collinear collinear,
/// exactly, whatever rounding does to it; empty if nothing is.
std::string wrongCounts(const Polygon& a, const Polygon& b, const Pose& both, ContactDetail detail,
                        const Cells& cells) {
  const Counts truth = cells.count();
  const std::vector<Contact> all = found(a, b, detail, both), inner = found(a, b, detail, both, Touching::Allowed);
  const auto counted = [](std::size_t count, std::size_t of) {
    return count == of ? "" : std::to_string(count) + " of " + std::to_string(of);
  };
  if (all.size() != truth.all) return counted(all.size(), truth.all);
  if (inner.size() != truth.entering) return "that enter " + counted(inner.size(), truth.entering);
  const auto deep = static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const Contact& contact) { return contact.depth > 0; }));
  if (detail == ContactDetail::GlobalDepth && !(truth.inner <= deep && deep <= truth.entering))
    return std::to_string(deep) + " are deep";
  std::set<std::size_t> components;
  for (const Contact& contact : all) components.insert(cells.componentAt(both.inverse() * contact.point));
  if (components.count(Cells::kNone) != 0) return "a point outside";
  return components.size() == all.size() ? "" : "two points on one component";
}

template <Polygon (*make)(Random& random)>
Case pairOf(Random& random) {
  const Polygon a = make(random), b = make(random);
  Pose both = randomPose(random, 9);
  if (random.oneIn(3)) both.linear().setIdentity();
  if (random.oneIn(3)) both = mirrored(both);
  return {a, both, b, both};
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  const Cells cells(c.a, c.b);
  const Counts truth = cells.count();
  tally.count("apart", truth.all == 0);
  tally.count("touch", truth.all > 0 && truth.inner == 0);
  tally.count("overlap and touch elsewhere", truth.inner > 0 && truth.inner < truth.all);
  tally.count("overlap in several components", truth.inner > 1);
  const Pose here = Pose::Identity();
  if ((truth.all > 0) != exact::collide(c.a, here, c.b, here) ||
      (truth.inner > 0) != exact::interiorsMeet(c.a, here, c.b, here) ||
      (truth.entering > 0) != exact::reachInto(c.a, here, c.b, here))
    return "cells";
  return wrongCounts(c.a, c.b, c.pose_a, kDetails[random.integer(0, 2)], cells);
}

Laws contactComponentsLaws() {
  const Shares shares = {{"apart", 0.01, 0.8},
                         {"touch", 0.05, 0.8},
                         {"overlap and touch elsewhere", 0.05, 0.8},
                         {"overlap in several components", 0.05, 0.8}};
  Laws laws = {{"kept_spike", 1, wrongSpike}};
  add(laws, {family("on_a_lattice", pairOf<latticePolygon>)}, 6000, wrong, shares);
  add(laws, {family("rectilinear", pairOf<anyRectilinear>)}, 20000, wrong, shares);
  return laws;
}

const Register registered("contact_components", contactComponentsLaws);

}  // namespace
}  // namespace tricover::laws
