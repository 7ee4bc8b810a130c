// SPDX-License-Identifier: BSD-3-Clause
// How many components contacts() finds, with and without touches, on small lattices where edges meet in every
// degenerate manner: spikes, repeated vertices, edges upon each other, both fill rules.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "exact_depth.h"
#include "exact_reference.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/contacts.h"

namespace tricover::support {
namespace {

/// Different coordinates of these lattices' crossings differ by more.
constexpr double kSame = 1e-7;

struct Edge {
  Vec2 v, w;
  double at(double x) const { return v.y() + (x - v.x()) / (w.x() - v.x()) * (w.y() - v.y()); }
  bool isAcross(double x) const { return std::min(v.x(), w.x()) - kSame < x && x < std::max(v.x(), w.x()) + kSame; }
  bool isUpright() const { return std::abs(v.x() - w.x()) < kSame; }
};

double cross(const Vec2& u, const Vec2& w) { return u.x() * w.y() - u.y() * w.x(); }

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
    if ((cross(u, p - v) > 0) == (w.y() > v.y())) winding += w.y() > v.y() ? 1 : -1;
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
        if (std::abs(cross(u, w)) < kSame) continue;
        const double s = cross(f.v - e.v, w) / cross(u, w), t = cross(f.v - e.v, u) / cross(u, w);
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

TEST(ContactComponent, OfASpikeWithoutAreaIsOneWhereItLeadsThroughAnInterior) {
  const Polygon a({{{1, 0}, {-1, 0}, {0, -1}, {0, 0}}}, FillRule::EvenOdd),
      b({{{0, -1}, {-2, 2}, {2, -1}, {0, 2}}}, FillRule::NonZero);
  const Counts truth = Cells(a, b).count();
  EXPECT_EQ(truth.all, 2u);
  EXPECT_EQ(truth.inner, 1u);
  EXPECT_EQ(truth.entering, 2u);
  for (const ContactDetail detail : kDetails) {
    const Pose here = Pose::Identity();
    EXPECT_EQ(found(a, b, detail).size(), 2u);
    EXPECT_EQ(found(a, b, detail, here, Touching::Allowed).size(), 2u);
    EXPECT_EQ(found(b, a, detail, here, Touching::Allowed).size(), 2u);
  }
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
std::string wrongContacts(const Polygon& a, const Polygon& b, const Pose& both, ContactDetail detail,
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

struct Kind {
  const char* name;
  Polygon (*make)(Random& random);
  int count;
};

class ContactComponents : public testing::TestWithParam<Kind> {};

TEST_P(ContactComponents, AreAsManyAsTheOverlapHas) {
  const int cases = scaledCount(GetParam().count);
  int apart = 0, touching = 0, mixed = 0, several = 0, wrong = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a = GetParam().make(random), b = GetParam().make(random);
    const Cells cells(a, b);
    const Counts truth = cells.count();
    apart += truth.all == 0;
    touching += truth.all > 0 && truth.inner == 0;
    mixed += truth.inner > 0 && truth.inner < truth.all;
    several += truth.inner > 1;
    const Pose here = Pose::Identity();
    ASSERT_EQ(truth.all > 0, exact::collide(a, here, b, here)) << i;
    ASSERT_EQ(truth.inner > 0, exact::interiorsMeet(a, here, b, here)) << i;
    ASSERT_EQ(truth.entering > 0, exact::reachInto(a, here, b, here)) << i;
    Pose both = randomPose(random, 9);
    if (random.oneIn(3)) both.linear().setIdentity();
    if (random.oneIn(3)) both = mirrored(both);
    const std::string problem = wrongContacts(a, b, both, kDetails[i % 3], cells);
    if (!problem.empty() && ++wrong <= 3)
      ADD_FAILURE() << i << ": " << problem << "\n" << reproduction({a, both, b, both});
  }
  std::printf("%d cases: %d apart, %d touch, %d overlap and touch elsewhere, %d overlap in several components\n", cases,
              apart, touching, mixed, several);
  EXPECT_EQ(wrong, 0);
  if (cases < 1000) return;
  EXPECT_GE(apart, 0.01 * cases);
  for (const int count : {touching, mixed, several}) EXPECT_GE(count, 0.05 * cases);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ContactComponents,
                         testing::Values(Kind{"OnALattice", latticePolygon, 6000},
                                         Kind{"Rectilinear", anyRectilinear, 20000}),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace tricover::support
