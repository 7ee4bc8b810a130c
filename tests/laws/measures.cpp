// SPDX-License-Identifier: BSD-3-Clause
// Areas, centroids, bounds, discs and simplified outlines against exact rationals.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reproduction.h"
#include "shapes.h"
#include "touching_families.h"
#include "tricover/polygon.h"
#include "workloads.h"

namespace tricover::laws {
namespace {

using namespace support;

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

std::string wrongMoments(const Polygon& polygon) {
  double length = 0;
  for (EdgeIndex e = 0; e < polygon.edgeCount(); ++e) length += (polygon.edgeEnd(e) - polygon.edgeStart(e)).norm();
  const double most = length * polygon.radius();
  if (!(most < 1e150 && most > 1e-150)) return {};
  const ExactMoments exact = exactMoments(polygon);
  const double area = polygon.area();
  if (!(std::abs(mpq_class(mpq_class(area) - exact.area).get_d()) <= 0x1p-48 * most)) return "area";
  if (area < 1e-9 * most) return {};
  const Vec2 center = polygon.centroid();
  const double far = 0x1p-47 * (most * polygon.radius() + center.norm() * area) * (1 + 2 * most / area);
  return std::abs(mpq_class(mpq_class(center.x()) * exact.area - exact.x).get_d()) <= far &&
                 std::abs(mpq_class(mpq_class(center.y()) * exact.area - exact.y).get_d()) <= far
             ? ""
             : "centroid";
}

std::string wrongBounds(const Polygon& polygon, const Pose& pose, Tally& tally) {
  const auto& m = pose.matrix();
  const Eigen::AlignedBox2d box = polygon.bounds(pose);
  if (!box.max().allFinite() || !box.min().allFinite()) return {};
  const double size = polygon.bounds().min().lpNorm<1>() + polygon.bounds().max().lpNorm<1>();
  const double room = 1e-14 * (size + pose.translation().lpNorm<1>()) + 0x1p-1000;
  for (const int axis : {0, 1}) {
    std::vector<mpq_class> exact;
    Eigen::AlignedBox2d plain;
    for (EdgeIndex e = 0; e < polygon.edgeCount(); ++e) {
      const Vec2 p = polygon.edgeStart(e);
      exact.push_back(mpq_class(m(axis, 0)) * p.x() + mpq_class(m(axis, 1)) * p.y() + m(axis, 2));
      plain.extend(Vec2(pose * p));
    }
    const auto [least, most] = std::minmax_element(exact.begin(), exact.end());
    if (!(box.min()[axis] <= *least && *most <= box.max()[axis])) return "a vertex out of the bounds";
    if (!(box.max()[axis] - *most <= room && *least - box.min()[axis] <= room)) return "bounds";
    tally.count("rounded", plain.max()[axis] < *most || plain.min()[axis] > *least);
  }
  return {};
}

/// Of both polygons, under both rules.
std::string wrong(Random&, Tally& tally, Case& c) {
  std::string problem = wrongBounds(c.a, c.pose_a, tally);
  for (const Polygon& polygon : {c.a, c.b})
    if (problem.empty() && polygon.vertexCount() <= 40) {
      problem = wrongMoments(polygon);
      if (problem.empty()) problem = wrongMoments(Polygon(polygon.rings(), FillRule::NonZero));
    }
  return problem;
}

/// Lattice polygons, on one line or on few, so that many have no area: then the centroid is the middle of the bounds.
std::string wrongOnLattice(Random& random, Tally& tally) {
  const bool is_line = random.coin();
  const Vec2 way(random.integer(-3, 3), random.integer(-3, 3)), from(random.integer(-9, 9), random.integer(-9, 9));
  std::vector<Ring> rings(static_cast<std::size_t>(random.integer(1, 2)));
  for (Ring& ring : rings)
    for (int n = random.integer(3, 7); n > 0; --n)
      ring.push_back(is_line ? Vec2(from + way * random.integer(-4, 4))
                             : Vec2(random.integer(0, 2), 3 * random.integer(0, 2)));
  const Polygon polygon(rings, random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
  const Eigen::AlignedBox2d box = polygon.bounds();
  const bool is_flat = exactMoments(polygon).area == 0;
  tally.count("without an area", is_flat);
  const std::string problem = !is_flat                                                        ? wrongMoments(polygon)
                              : polygon.centroid() == Vec2(0.5 * box.min() + 0.5 * box.max()) ? ""
                                                                                              : "centroid";
  return problem.empty() ? problem : problem + "\n" + reproduction(polygon, polygon.centroid());
}

/// Whether points of a region are no farther from the other one than the tolerance: vertices, middles, and any others.
bool isNear(Random& random, const Polygon& polygon, const Polygon& other, double tolerance) {
  const Pose here = Pose::Identity();
  const auto is_near = [&](const Vec2& p) {
    return exact::locate(polygon, p) == Location::Outside ||
           exact::within(exact::distanceSquared(Polygon::point(p), here, other, here), mpq_class(tolerance));
  };
  const Eigen::AlignedBox2d box = polygon.bounds();
  for (int i = 0; i < 8; ++i) {
    const EdgeIndex edge = anyEdge(random, polygon);
    if (!is_near(polygon.edgeStart(edge)) || !is_near(0.5 * (polygon.edgeStart(edge) + polygon.edgeEnd(edge))) ||
        !is_near(box.min() + Vec2(random.unit(), random.unit()).cwiseProduct(box.sizes())))
      return false;
  }
  return true;
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

/// Regions are near their own when they are simplified, and held by what they are simplified to outwards.
std::string wrongSimplified(Random& random, Tally& tally, const Polygon& polygon, Simplify how) {
  const double tolerance = polygon.radius() * std::pow(10, random.real(-3, -0.3));
  if (!std::isfinite(tolerance)) return {};
  const bool is_cover = how == Simplify::Outwards;
  const Polygon simple = polygon.simplified(tolerance, how);
  tally.count(is_cover ? "covers have fewer" : "fewer", simple.vertexCount() < polygon.vertexCount());
  const char* wrong = simple.fillRule() != polygon.fillRule()        ? "another fill rule"
                      : is_cover && !coversInterior(simple, polygon) ? "it isn't covered"
                      : !isNear(random, simple, polygon, tolerance)  ? "far from the polygon"
                      // Edges without an inside are held, too.
                      : !isNear(random, polygon, simple, is_cover ? 0 : tolerance) ? "far from the simplified one"
                                                                                   : nullptr;
  return wrong == nullptr ? ""
                          : wrong + std::string(is_cover ? ", outwards" : "") + ", tolerance " + hex(tolerance) + "\n" +
                                reproduction(polygon, polygon.centroid());
}

std::string wrongSimplifiedPair(Random& random, Tally& tally, Case& c) {
  std::string wrong;
  for (const Polygon& polygon : {c.a, c.b, Polygon(c.a.rings(), FillRule::NonZero)}) {
    if (wrong.empty() && polygon.vertexCount() <= 100) wrong = wrongSimplified(random, tally, polygon, Simplify::Both);
    if (wrong.empty() && polygon.vertexCount() <= 40)
      wrong = wrongSimplified(random, tally, polygon, Simplify::Outwards);
  }
  return wrong;
}

std::string wrongCountry(Random& random, Tally& tally) {
  static const std::vector<workloads::NamedPolygon> countries = [] {
    std::ifstream in(TRICOVER_COUNTRIES);
    return workloads::readPolygons(in);
  }();
  const Polygon& polygon = countries[random.bits() % countries.size()].polygon;
  std::string wrong;
  if (polygon.vertexCount() <= 200) wrong = wrongSimplified(random, tally, polygon, Simplify::Both);
  if (wrong.empty() && polygon.vertexCount() <= 150)
    wrong = wrongSimplified(random, tally, polygon, Simplify::Outwards);
  return wrong;
}

/// Where vertices are at the tolerance exactly, or the smallest double beyond it, far from the origin too.
std::string wrongTolerance(Random&, Tally&) {
  for (const double far : {0.0, 1e6, 0x1p52}) {
    const Polygon rough({{{far, 0}, {far + 4, 1}, {far + 8, 0}, {far + 8, -9}, {far, -9}}});
    if (rough.simplified(1).vertexCount() != 4) return "at " + hex(far);
    if (rough.simplified(std::nextafter(1.0, 0.0)).vertexCount() != 5) return "beyond, at " + hex(far);
  }
  return {};
}

/// A polygon's disc holds its vertices, and is tight at every size; its centre is within the bounds. A ring's raw
/// vertices make the same polygon, bit for bit.
std::string wrongDisc(Random&, Tally& tally, Case& c) {
  for (const Polygon& polygon : {c.a, c.b}) {
    const Vec2 s = polygon.coveringOrigin();
    mpq_class farthest = 0;
    for (const Ring& ring : polygon.rings())
      for (const Vec2& v : ring) farthest = std::max(farthest, exact::distanceSquared(v, s, s));
    if (!polygon.bounds().contains(s)) return "the disc's centre";
    const Ring& ring = polygon.rings().back();
    const Polygon by_ring({ring}, polygon.fillRule()), raw(ring.data(), ring.size(), polygon.fillRule());
    if (raw.rings() != by_ring.rings() || raw.fillRule() != polygon.fillRule() ||
        raw.coveringOrigin() != by_ring.coveringOrigin() || raw.radius() != by_ring.radius())
      return "a ring's raw vertices";
    tally.count("finite", std::isfinite(polygon.radius()));
    if (!std::isfinite(polygon.radius())) continue;
    const mpq_class radius(polygon.radius());
    if (!exact::within(farthest, radius)) return "a vertex out of the disc";
    // A few of the smallest doubles more where the distances are no larger themselves.
    const mpq_class tight = (radius - 8 * mpq_class(5e-324)) * mpq_class(1 - 1e-12);
    if (tight > 0 && tight * tight > farthest) return "the disc is too large";
  }
  return {};
}

Case ofTheSmallest(Random& random) {
  const auto polygon = [&] {
    Ring ring;
    for (int k = random.integer(3, 5); k > 0; --k)
      ring.emplace_back(5e-324 * random.integer(-3, 3), 5e-324 * random.integer(-3, 3));
    return Polygon({ring});
  };
  const Polygon a = polygon(), b = polygon();
  return {a, Pose::Identity(), b, Pose::Identity()};
}

Case anyOf(const std::vector<Family>& list, Random& random) {
  return list[random.bits() % list.size()].make(random.bits());
}
Case anyOfFamilies(Random& random) { return anyOf(families(), random); }
Case anyThatTouches(Random& random) { return anyOf(touchingFamilies(), random); }

/// The quarter of a coordinate isn't always a double.
Case denormals(Random& random) {
  for (const Family& family : families())
    if (family.name == std::string("denormals")) return family.make(random.bits());
  throw std::logic_error("no denormals");
}

Laws measuresLaws() {
  Laws laws = {{"lattice", 20000, wrongOnLattice, {{"without an area", 0.5, 0.9}}},
               {"countries", 100, wrongCountry, {{"fewer", 0.01, 1}, {"covers have fewer", 0.01, 1}}},
               {"kept_tolerance", 1, wrongTolerance}};
  add(laws, families(), 100, wrong, {});
  add(laws, {family("families", anyOfFamilies)}, 1000, wrongDisc, {{"finite", 0.8, 1}}, "discs_of_");
  add(laws, {family("the_smallest", ofTheSmallest)}, 1000, wrongDisc, {}, "discs_of_");
  add(laws, {family("families", anyOfFamilies)}, 1000, wrong, {{"rounded", 0.0001, 1}}, "bounds_of_");
  add(laws, {family("families", anyOfFamilies)}, 1000, wrongSimplifiedPair,
      {{"fewer", 0.2, 1}, {"covers have fewer", 0.2, 1}}, "simplified_");
  add(laws, {family("touching", anyThatTouches)}, 2500, wrongSimplifiedPair, {{"covers have fewer", 0.1, 1}},
      "simplified_");
  add(laws, {family("denormals", denormals)}, 1000, wrongSimplifiedPair, {{"covers have fewer", 0.02, 1}},
      "simplified_");
  return laws;
}

const Register registered("measures", measuresLaws);

}  // namespace
}  // namespace tricover::laws
