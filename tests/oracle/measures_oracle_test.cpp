// SPDX-License-Identifier: BSD-3-Clause
// Areas, centroids and simplified outlines against exact rationals.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "touching_families.h"
#include "tricover/segment.h"
#include "workloads.h"

namespace tricover::support {
namespace {

struct ExactEdge {
  mpq_class x, y, x_above, y_above;
  int winding;
  mpq_class xAt(const mpq_class& at) const { return x + (x_above - x) * (at - y) / (y_above - y); }
};

bool isInside(const Polygon& polygon, int winding) {
  return polygon.fillRule() == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0;
}

struct ExactMoments {
  mpq_class area, x, y;
};

std::vector<ExactEdge> risingEdges(const Polygon& polygon) {
  std::vector<ExactEdge> edges;
  for (EdgeIndex e = 0; e < polygon.edgeCount(); ++e) {
    const Vec2 v = polygon.edgeStart(e), w = polygon.edgeEnd(e);
    if (v.y() < w.y()) edges.push_back({v.x(), v.y(), w.x(), w.y(), 1});
    if (v.y() > w.y()) edges.push_back({w.x(), w.y(), v.x(), v.y(), -1});
  }
  return edges;
}

/// All heights at which edges begin, end or cross, in order: between two of them regions are trapezoids.
std::vector<mpq_class> heightsOf(const std::vector<ExactEdge>& edges) {
  std::vector<mpq_class> heights;
  for (const ExactEdge& p : edges) {
    heights.insert(heights.end(), {p.y, p.y_above});
    for (const ExactEdge& q : edges) {
      const mpq_class slope_p = (p.x_above - p.x) / (p.y_above - p.y), slope_q = (q.x_above - q.x) / (q.y_above - q.y);
      if (slope_p == slope_q) continue;
      const mpq_class at = p.y + (q.xAt(p.y) - p.x) / (slope_p - slope_q);
      if (p.y < at && at < p.y_above && q.y < at && at < q.y_above) heights.push_back(at);
    }
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

ExactMoments exactMoments(const Polygon& polygon) {
  const std::vector<ExactEdge> edges = risingEdges(polygon);
  const std::vector<mpq_class> heights = heightsOf(edges);
  ExactMoments sum;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const mpq_class &low = heights[i - 1], &high = heights[i], h = high - low, middle = (low + high) / 2;
    std::vector<std::pair<mpq_class, const ExactEdge*>> across;
    for (const ExactEdge& edge : edges)
      if (edge.y <= low && high <= edge.y_above) across.emplace_back(edge.xAt(middle), &edge);
    std::sort(across.begin(), across.end());
    int winding = 0;
    for (const auto& [x, edge] : across) {
      const int before = isInside(polygon, winding);
      winding += edge->winding;
      const int ends = before - isInside(polygon, winding);
      const mpq_class p = edge->xAt(low), q = edge->xAt(high);
      sum.area += ends * h * (p + q) / 2;
      sum.x += ends * h * (p * p + p * q + q * q) / 6;
      sum.y += ends * h * (low * (2 * p + q) + high * (p + 2 * q)) / 6;
    }
  }
  return sum;
}

void expectMeasures(const Polygon& polygon) {
  double length = 0;
  for (EdgeIndex e = 0; e < polygon.edgeCount(); ++e) length += (polygon.edgeEnd(e) - polygon.edgeStart(e)).norm();
  const double most = length * polygon.radius();
  if (!(most < 1e150 && most > 1e-150)) return;
  const ExactMoments exact = exactMoments(polygon);
  const double area = polygon.area();
  EXPECT_LE(std::abs(mpq_class(mpq_class(area) - exact.area).get_d()), 0x1p-48 * most);
  if (area < 1e-9 * most) return;
  const Vec2 center = polygon.centroid();
  const double far = 0x1p-47 * (most * polygon.radius() + center.norm() * area) * (1 + 2 * most / area);
  EXPECT_LE(std::abs(mpq_class(mpq_class(center.x()) * exact.area - exact.x).get_d()), far);
  EXPECT_LE(std::abs(mpq_class(mpq_class(center.y()) * exact.area - exact.y).get_d()), far);
}

TEST(MeasuresOracle, AreasAndCentroidsAreOfTheRegionByItsFillRule) {
  for (const Family& family : families()) {
    for (int seed = 0; seed < scaledCount(40); ++seed) {
      const Case c = family.make(static_cast<std::uint64_t>(seed));
      SCOPED_TRACE(testing::Message() << family.name << " seed " << seed);
      for (const Polygon& polygon : {c.a, c.b})
        if (polygon.vertexCount() <= 40) {
          expectMeasures(polygon);
          expectMeasures(Polygon(polygon.rings(), FillRule::NonZero));
        }
    }
  }
}

/// Lattice polygons, on one line or on few, so that many have no area: then the centroid is the middle of the bounds.
TEST(MeasuresOracle, WithoutAnAreaTheCentroidIsTheMiddleOfTheBounds) {
  Random random(6);
  int without = 0, cases = 0;
  for (; cases < scaledCount(20000); ++cases) {
    const bool is_line = random.integer(0, 1) == 0;
    const Vec2 way(random.integer(-3, 3), random.integer(-3, 3)), from(random.integer(-9, 9), random.integer(-9, 9));
    std::vector<Ring> rings(static_cast<std::size_t>(random.integer(1, 2)));
    for (Ring& ring : rings)
      for (int n = random.integer(3, 7); n > 0; --n)
        ring.push_back(is_line ? Vec2(from + way * random.integer(-4, 4))
                               : Vec2(random.integer(0, 2), 3 * random.integer(0, 2)));
    const Polygon polygon(rings, random.integer(0, 1) == 0 ? FillRule::EvenOdd : FillRule::NonZero);
    const Eigen::AlignedBox2d box = polygon.bounds();
    if (exactMoments(polygon).area == 0) {
      ++without;
      EXPECT_EQ(polygon.centroid(), Vec2(0.5 * box.min() + 0.5 * box.max()))
          << reproduction(polygon, polygon.centroid());
    } else {
      expectMeasures(polygon);
    }
  }
  EXPECT_GT(without, cases / 2);
  EXPECT_LT(without, cases * 9 / 10);
}

/// Points of both regions are no farther from the other one than the tolerance: vertices, middles, and any others.
void expectNear(Random& random, const Polygon& polygon, const Polygon& other, double tolerance) {
  const Pose here = Pose::Identity();
  const auto expect = [&](const Vec2& p) {
    if (exact::locate(polygon, p) == Location::Outside) return;
    EXPECT_TRUE(exact::within(exact::distanceSquared(point(p), here, other, here), mpq_class(tolerance)))
        << p.transpose();
  };
  const Eigen::AlignedBox2d box = polygon.bounds();
  for (int i = 0; i < 8; ++i) {
    const EdgeIndex edge = anyEdge(random, polygon);
    expect(polygon.edgeStart(edge));
    expect(0.5 * (polygon.edgeStart(edge) + polygon.edgeEnd(edge)));
    expect(box.min() + Vec2(random.unit(), random.unit()).cwiseProduct(box.sizes()));
  }
}

void expectSimplified(Random& random, const Polygon& polygon, int& fewer) {
  const double tolerance = polygon.radius() * std::pow(10, random.real(-3, -0.3));
  if (!std::isfinite(tolerance)) return;
  const Polygon simple = polygon.simplified(tolerance);
  EXPECT_EQ(simple.fillRule(), polygon.fillRule());
  fewer += simple.vertexCount() < polygon.vertexCount();
  expectNear(random, polygon, simple, tolerance);
  expectNear(random, simple, polygon, tolerance);
}

/// Whether all of the polygon's interior is in the other region: by the widths between the edges of both, over strips
/// in which no two cross.
bool coversInterior(const Polygon& other, const Polygon& polygon) {
  std::vector<ExactEdge> edges = risingEdges(polygon);
  const std::size_t own = edges.size();
  for (const ExactEdge& edge : risingEdges(other)) edges.push_back(edge);
  const std::vector<mpq_class> heights = heightsOf(edges);
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const mpq_class &low = heights[i - 1], &high = heights[i], middle = (low + high) / 2;
    std::vector<std::pair<mpq_class, std::size_t>> across;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e].y <= low && high <= edges[e].y_above) across.emplace_back(edges[e].xAt(middle), e);
    std::sort(across.begin(), across.end());
    int windings[2] = {};
    for (std::size_t k = 0; k + 1 < across.size(); ++k) {
      const std::size_t e = across[k].second;
      windings[e < own ? 0 : 1] += edges[e].winding;
      if (across[k].first == across[k + 1].first) continue;
      if (isInside(polygon, windings[0]) && !isInside(other, windings[1])) return false;
    }
  }
  return true;
}

void expectCovered(Random& random, const Polygon& polygon, int& fewer) {
  const double tolerance = polygon.radius() * std::pow(10, random.real(-3, -0.3));
  if (!std::isfinite(tolerance)) return;
  const Polygon cover = polygon.simplified(tolerance, Simplify::Outwards);
  EXPECT_EQ(cover.fillRule(), polygon.fillRule());
  fewer += cover.vertexCount() < polygon.vertexCount();
  EXPECT_TRUE(coversInterior(cover, polygon)) << "within " << tolerance;
  expectNear(random, cover, polygon, tolerance);
  expectNear(random, polygon, cover, 0);  // edges without an inside, too
}

using Expect = void (*)(Random& random, const Polygon& polygon, int& fewer);

/// Of families' polygons: their first ones alone are too few that can be simplified.
void expectOfFamilies(const std::vector<Family>& list, Expect expect, int seeds, std::size_t most, double share) {
  Random random(1);
  int fewer = 0, cases = 0;
  for (const Family& family : list)
    for (int seed = 0; seed < std::max(scaledCount(seeds), 4); ++seed) {
      SCOPED_TRACE(testing::Message() << family.name << " seed " << seed);
      const Case c = family.make(static_cast<std::uint64_t>(seed));
      for (const Polygon& polygon : {c.a, c.b, Polygon(c.a.rings(), FillRule::NonZero)})
        if (polygon.vertexCount() <= most) ++cases, expect(random, polygon, fewer);
    }
  EXPECT_GT(fewer, share * cases) << "of " << cases;
}

void expectOfCountries(Expect expect, int countries, std::size_t most) {
  std::ifstream in(TRICOVER_COUNTRIES);
  Random random(2);
  int fewer = 0, left = scaledCount(countries);
  for (const auto& [label, polygon] : workloads::readPolygons(in)) {
    if (left-- == 0) break;
    SCOPED_TRACE(label);
    if (polygon.vertexCount() <= most) expect(random, polygon, fewer);
  }
  EXPECT_GT(fewer, 0);
}

TEST(MeasuresOracle, SimplifiedRegionsAreNearTheirOwn) {
  expectOfFamilies(families(), expectSimplified, 30, 100, 0.2);
  expectOfCountries(expectSimplified, 100, 200);
}

TEST(MeasuresOracle, CoversHoldTheRegionAndAreNearIt) {
  expectOfFamilies(families(), expectCovered, 30, 40, 0.2);
  expectOfFamilies(touchingFamilies(), expectCovered, 400, 40, 0.1);
  expectOfCountries(expectCovered, 60, 150);
}

/// The quarter of a coordinate isn't always a double.
TEST(MeasuresOracle, CoversOfTheSmallestDoublesHoldTheRegion) {
  std::vector<Family> denormals;
  for (const Family& family : families())
    if (family.name == std::string("denormals")) denormals.push_back(family);
  ASSERT_EQ(denormals.size(), 1u);
  expectOfFamilies(denormals, expectCovered, 1000, 40, 0.02);
}

TEST(MeasuresOracle, BoundsOfAPoseHoldAllVertices) {
  int rounded = 0;
  for (const Family& family : families())
    for (int i = 0; i < scaledCount(100); ++i) {
      const Case c = family.make(static_cast<std::uint64_t>(i));
      const auto& m = c.pose_a.matrix();
      const Eigen::AlignedBox2d box = c.a.bounds(c.pose_a);
      if (!box.max().allFinite() || !box.min().allFinite()) continue;
      const double size = c.a.bounds().min().lpNorm<1>() + c.a.bounds().max().lpNorm<1>();
      const double room = 1e-14 * (size + c.pose_a.translation().lpNorm<1>()) + 0x1p-1000;
      for (const int axis : {0, 1}) {
        std::vector<mpq_class> exact;
        Eigen::AlignedBox2d plain;
        for (EdgeIndex e = 0; e < c.a.edgeCount(); ++e) {
          const Vec2 p = c.a.edgeStart(e);
          exact.push_back(mpq_class(m(axis, 0)) * p.x() + mpq_class(m(axis, 1)) * p.y() + m(axis, 2));
          plain.extend(Vec2(c.pose_a * p));
        }
        const auto [least, most] = std::minmax_element(exact.begin(), exact.end());
        ASSERT_TRUE(box.min()[axis] <= *least && *most <= box.max()[axis]) << family.name << " " << i;
        ASSERT_TRUE(box.max()[axis] - *most <= room && *least - box.min()[axis] <= room) << family.name << " " << i;
        rounded += plain.max()[axis] < *most || plain.min()[axis] > *least;
      }
    }
  EXPECT_GT(rounded, 0);
}

/// Where vertices are at the tolerance exactly, or the smallest double beyond it, far from the origin too.
TEST(MeasuresOracle, ToleranceIsExact) {
  for (const double far : {0.0, 1e6, 0x1p52}) {
    const Polygon rough({{{far, 0}, {far + 4, 1}, {far + 8, 0}, {far + 8, -9}, {far, -9}}});
    EXPECT_EQ(rough.simplified(1).vertexCount(), 4u) << far;
    EXPECT_EQ(rough.simplified(std::nextafter(1.0, 0.0)).vertexCount(), 5u) << far;
  }
}

}  // namespace
}  // namespace tricover::support
