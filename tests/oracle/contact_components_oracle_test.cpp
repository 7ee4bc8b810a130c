// SPDX-License-Identifier: BSD-3-Clause
// How many components contacts() finds, with and without touches, on small lattices where edges meet in every
// degenerate manner: spikes, repeated vertices, edges upon each other, both fill rules.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

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

void sortAndMerge(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(), [](double p, double q) { return q - p < kSame; }),
               values.end());
}

struct Counts {
  std::size_t all = 0, inner = 0;
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

  Counts count() {
    std::vector<char> seen(cells_.size()), inner(cells_.size());
    for (std::size_t k = 0; k < cells_.size(); ++k)
      if (cells_[k].held) {
        seen[find(k)] = 1;
        inner[find(k)] = inner[find(k)] || cells_[k].is_area;
      }
    Counts counts;
    counts.all = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), 1));
    counts.inner = static_cast<std::size_t>(std::count(inner.begin(), inner.end(), 1));
    return counts;
  }

 private:
  struct Cell {
    bool held, is_area;
    double left_low, left_high, right_low, right_high;  ///< its closure at its column's ends
  };
  struct Column {
    std::size_t begin, end;
    bool is_strip;
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
    const Column column{cells_.size(), cells_.size() + (ys.empty() ? 0 : 2 * ys.size() - 1), is_strip};
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
    cells_.push_back(
        {held, held && left < right && low < high, yAt(low, left), yAt(high, left), yAt(low, right), yAt(high, right)});
    parent_.push_back(parent_.size());
  }

  void joinColumns(std::size_t k) {
    const Column &of_strip = columns_[columns_[k].is_strip ? k : k - 1],
                 &of_line = columns_[columns_[k].is_strip ? k - 1 : k];
    const bool line_is_left = columns_[k].is_strip;
    for (std::size_t i = of_strip.begin; i < of_strip.end; ++i) {
      if (!cells_[i].held) continue;
      const double low = line_is_left ? cells_[i].left_low : cells_[i].right_low,
                   high = line_is_left ? cells_[i].left_high : cells_[i].right_high;
      for (std::size_t j = of_line.begin; j < of_line.end; ++j)
        if (cells_[j].held && low < cells_[j].left_low + kSame && cells_[j].left_high < high + kSame) join(i, j);
    }
  }

  std::size_t find(std::size_t k) {
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

Counts found(const Polygon& a, const Polygon& b, ContactDetail detail) {
  ContactOptions options;
  options.detail = detail;
  Counts counts;
  counts.all = contacts(a, Pose::Identity(), b, Pose::Identity(), options).size();
  options.touching = Touching::Allowed;
  counts.inner = contacts(a, Pose::Identity(), b, Pose::Identity(), options).size();
  return counts;
}

TEST(ContactComponents, OfASpikeWithoutAreaIsNone) {
  const Polygon a({{{1, 0}, {-1, 0}, {0, -1}, {0, 0}}}, FillRule::EvenOdd),
      b({{{0, -1}, {-2, 2}, {2, -1}, {0, 2}}}, FillRule::NonZero);
  const Counts truth = Cells(a, b).count();
  EXPECT_EQ(truth.all, 2u);
  EXPECT_EQ(truth.inner, 1u);
  for (const ContactDetail detail : {ContactDetail::Points, ContactDetail::LocalDepth, ContactDetail::GlobalDepth}) {
    EXPECT_EQ(found(a, b, detail).all, 2u);
    EXPECT_EQ(found(a, b, detail).inner, 1u);
    EXPECT_EQ(found(b, a, detail).inner, 1u);
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

TEST(ContactComponents, AreAsManyAsOnTheLattice) {
  const int cases = scaledCount(6000);
  int apart = 0, touching = 0, mixed = 0, several = 0, wrong = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a = latticePolygon(random), b = latticePolygon(random);
    const Counts truth = Cells(a, b).count();
    apart += truth.all == 0;
    touching += truth.all > 0 && truth.inner == 0;
    mixed += truth.inner > 0 && truth.inner < truth.all;
    several += truth.inner > 1;
    const Pose here = Pose::Identity();
    ASSERT_EQ(truth.all > 0, exact::collide(a, here, b, here)) << i;
    ASSERT_EQ(truth.inner > 0, exact::interiorsMeet(a, here, b, here)) << i;
    const auto detail = static_cast<ContactDetail>(i % 3);
    const Counts counts = found(a, b, detail);
    if (counts.all == truth.all && counts.inner == truth.inner) continue;
    if (++wrong <= 3)
      ADD_FAILURE() << i << ": " << counts.all << " of " << truth.all << ", with an interior " << counts.inner << " of "
                    << truth.inner << "\n"
                    << reproduction({a, here, b, here});
  }
  std::printf("%d cases: %d apart, %d touch, %d overlap and touch elsewhere, %d overlap in several components\n", cases,
              apart, touching, mixed, several);
  EXPECT_EQ(wrong, 0);
  if (cases >= 1000) {
    EXPECT_GE(apart, 0.02 * cases);
    EXPECT_GE(touching, 0.05 * cases);
    EXPECT_GE(mixed, 0.05 * cases);
    EXPECT_GE(several, 0.05 * cases);
  }
}

}  // namespace
}  // namespace tricover::support
