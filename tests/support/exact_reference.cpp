// SPDX-License-Identifier: BSD-3-Clause
#include "exact_reference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace tricover::exact {
namespace {

/// mantissa * 2^exponent. Every double, sum and product of doubles is one.
struct Dyadic {
  mpz_class mantissa;
  long exponent = 0;
};

struct Point {
  mpz_class x, y;
};

/// Both polygons on one integer grid, whose unit is 2^exponent: signs are those of the true coordinates, and no
/// rational has to be reduced on the way.
struct Shape {
  std::vector<std::vector<Point>> rings;
  FillRule fill;
  bool is_complement;
};
struct Edge {
  const Point *v, *w;
  const mpz_class *x_low, *x_high, *y_low, *y_high;
};

Dyadic dyadic(double value) {
  if (value == 0) return {};
  int exponent;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  for (; mantissa % 2 == 0; ++exponent) mantissa /= 2;
  return {mpz_class(static_cast<long>(mantissa)), exponent};
}

Dyadic product(const Dyadic& left, const Dyadic& right) {
  return {left.mantissa * right.mantissa, left.exponent + right.exponent};
}

mpz_class onGrid(const Dyadic& value, long exponent) {
  if (value.mantissa == 0) return 0;
  return value.mantissa << static_cast<mp_bitcnt_t>(value.exponent - exponent);
}

Dyadic sum(const Dyadic& left, const Dyadic& right) {
  if (left.mantissa == 0) return right;
  if (right.mantissa == 0) return left;
  const long exponent = std::min(left.exponent, right.exponent);
  return {onGrid(left, exponent) + onGrid(right, exponent), exponent};
}

using DyadicPoint = std::pair<Dyadic, Dyadic>;
using DyadicRings = std::vector<std::vector<DyadicPoint>>;

DyadicRings posed(const Polygon& polygon, const Pose& pose) {
  Dyadic m[2][3];
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) m[row][column] = dyadic(pose.matrix()(row, column));
  }
  DyadicRings rings;
  for (const Ring& ring : polygon.rings()) {
    auto& out = rings.emplace_back();
    for (const Vec2& vertex : ring) {
      const Dyadic x = dyadic(vertex.x()), y = dyadic(vertex.y());
      out.emplace_back(sum(sum(product(m[0][0], x), product(m[0][1], y)), m[0][2]),
                       sum(sum(product(m[1][0], x), product(m[1][1], y)), m[1][2]));
    }
  }
  return rings;
}

DyadicRings unposed(const std::vector<Ring>& rings) {
  DyadicRings result;
  for (const Ring& ring : rings) {
    auto& out = result.emplace_back();
    for (const Vec2& vertex : ring) out.emplace_back(dyadic(vertex.x()), dyadic(vertex.y()));
  }
  return result;
}

long finestExponent(const DyadicRings& rings, long so_far) {
  for (const auto& ring : rings) {
    for (const auto& [x, y] : ring) {
      if (x.mantissa != 0) so_far = std::min(so_far, x.exponent);
      if (y.mantissa != 0) so_far = std::min(so_far, y.exponent);
    }
  }
  return so_far;
}

Shape gridded(const DyadicRings& rings, FillRule fill, bool is_complement, long exponent) {
  Shape shape{{}, fill, is_complement};
  for (const auto& ring : rings) {
    auto& out = shape.rings.emplace_back();
    for (const auto& [x, y] : ring) out.push_back({onGrid(x, exponent), onGrid(y, exponent)});
  }
  return shape;
}

struct Pair {
  Shape a, b;
  long exponent;
};

Pair griddedPair(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const DyadicRings rings_a = posed(a, pose_a), rings_b = posed(b, pose_b);
  const long exponent = finestExponent(rings_b, finestExponent(rings_a, 0));
  return {gridded(rings_a, a.fillRule(), a.isComplement(), exponent),
          gridded(rings_b, b.fillRule(), b.isComplement(), exponent), exponent};
}

Edge edge(const Point& v, const Point& w) {
  const bool x_up = v.x <= w.x, y_up = v.y <= w.y;
  return {&v, &w, x_up ? &v.x : &w.x, x_up ? &w.x : &v.x, y_up ? &v.y : &w.y, y_up ? &w.y : &v.y};
}

std::vector<Edge> edges(const Shape& shape) {
  std::vector<Edge> result;
  for (const auto& ring : shape.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) result.push_back(edge(ring[i], ring[(i + 1) % ring.size()]));
  }
  return result;
}

int orientation(const Point& p, const Point& q, const Point& r) {
  const mpz_class left = (q.x - p.x) * (r.y - p.y), right = (q.y - p.y) * (r.x - p.x);
  return sgn(mpz_class(left - right));
}

bool boxesMeet(const Edge& e, const Edge& f) {
  return *e.x_low <= *f.x_high && *f.x_low <= *e.x_high && *e.y_low <= *f.y_high && *f.y_low <= *e.y_high;
}

/// Boxes that meet and lines that separate nothing: right for collinear and for single-point edges too.
bool edgesMeet(const Edge& e, const Edge& f) {
  return boxesMeet(e, f) && orientation(*e.v, *e.w, *f.v) * orientation(*e.v, *e.w, *f.w) <= 0 &&
         orientation(*f.v, *f.w, *e.v) * orientation(*f.v, *f.w, *e.w) <= 0;
}

bool isFilled(const Shape& shape, int winding) {
  return (shape.fill == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0) != shape.is_complement;
}

Location locate(const Shape& shape, const std::vector<Edge>& shape_edges, const Point& p) {
  int winding = 0;
  for (const Edge& e : shape_edges) {
    if (p.y < *e.y_low || *e.y_high < p.y) continue;
    const int side = orientation(*e.v, *e.w, p);
    if (side == 0 && *e.x_low <= p.x && p.x <= *e.x_high) return Location::Boundary;
    // Half-open in y, so that a vertex on the ray counts for one of its two edges.
    if (e.v->y <= p.y && p.y < e.w->y && side > 0) ++winding;
    if (e.w->y <= p.y && p.y < e.v->y && side < 0) --winding;
  }
  return isFilled(shape, winding) ? Location::Inside : Location::Outside;
}

/// Where no edges meet, a ring lies on one side of the other polygon as a whole.
bool holdsARing(const Shape& holder, const std::vector<Edge>& holder_edges, const Shape& held) {
  return std::any_of(held.rings.begin(), held.rings.end(), [&](const std::vector<Point>& ring) {
    return locate(holder, holder_edges, ring.front()) != Location::Outside;
  });
}

bool collide(const Pair& pair, const std::vector<Edge>& edges_a, const std::vector<Edge>& edges_b) {
  for (const Edge& e : edges_a) {
    for (const Edge& f : edges_b) {
      if (edgesMeet(e, f)) return true;
    }
  }
  return holdsARing(pair.a, edges_a, pair.b) || holdsARing(pair.b, edges_b, pair.a);
}

/// x of every vertex, and of every point in which two edges cross; sorted.
std::vector<mpq_class> breaksOf(const std::vector<Edge>& edges) {
  std::vector<mpq_class> breaks;
  for (const Edge& e : edges) breaks.emplace_back(e.v->x);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Edge &e = edges[i], &f = edges[j];
      const mpz_class ex = e.w->x - e.v->x, ey = e.w->y - e.v->y, fx = f.w->x - f.v->x, fy = f.w->y - f.v->y;
      const mpz_class slant = ex * fy - ey * fx;
      if (slant == 0 || !edgesMeet(e, f)) continue;
      mpq_class part((f.v->x - e.v->x) * fy - (f.v->y - e.v->y) * fx, slant);
      part.canonicalize();
      breaks.push_back(e.v->x + part * ex);
    }
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

/// Whether somewhere on the vertical through x, which meets no vertex and no crossing, both are filled.
bool bothFilledAt(const mpq_class& x, const Pair& pair, const std::vector<Edge>& all, std::size_t count_of_a) {
  struct Step {
    mpq_class y;
    bool of_a;
    int turn;
  };
  std::vector<Step> steps;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Edge& e = all[i];
    if (!(*e.x_low < x && x < *e.x_high)) continue;
    mpq_class slope(e.w->y - e.v->y, e.w->x - e.v->x);
    slope.canonicalize();
    steps.push_back({e.v->y + (x - e.v->x) * slope, i < count_of_a, e.v->x < e.w->x ? 1 : -1});
  }
  std::sort(steps.begin(), steps.end(), [](const Step& p, const Step& q) { return p.y < q.y; });
  int winding_a = 0, winding_b = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    (steps[i].of_a ? winding_a : winding_b) += steps[i].turn;
    const bool has_room = i + 1 < steps.size() && steps[i].y < steps[i + 1].y;
    if (has_room && isFilled(pair.a, winding_a) && isFilled(pair.b, winding_b)) return true;
  }
  return false;
}

/// numerator / denominator, in squared grid units; not reduced.
struct Fraction {
  mpz_class numerator, denominator;
};

bool operator<(const Fraction& left, const Fraction& right) {
  return left.numerator * right.denominator < right.numerator * left.denominator;
}

Fraction squaredDistance(const Point& p, const Point& v, const Point& w) {
  const mpz_class dx = w.x - v.x, dy = w.y - v.y, px = p.x - v.x, py = p.y - v.y;
  const mpz_class along = dx * px + dy * py, length_squared = dx * dx + dy * dy;
  if (along <= 0) return {px * px + py * py, 1};
  if (along >= length_squared) {
    const mpz_class qx = p.x - w.x, qy = p.y - w.y;
    return {qx * qx + qy * qy, 1};
  }
  const mpz_class cross = dx * py - dy * px;
  return {cross * cross, length_squared};
}

/// Where the way from p along d first meets an edge, which it does: where both lines meet, by Cramer's rule; along a
/// line at the end that is least far along.
Fraction fractionOfWay(const Point& p, const Point& d, const Edge& e) {
  const mpz_class ux = e.w->x - e.v->x, uy = e.w->y - e.v->y, vx = e.v->x - p.x, vy = e.v->y - p.y;
  const mpz_class determinant = ux * d.y - uy * d.x;
  if (determinant != 0) {
    const mpz_class part = ux * vy - uy * vx;
    return determinant > 0 ? Fraction{part, determinant} : Fraction{-part, -determinant};
  }
  const mpz_class to_v = vx * d.x + vy * d.y, to_w = to_v + ux * d.x + uy * d.y;
  return {to_v < to_w ? to_v : to_w, d.x * d.x + d.y * d.y};
}

mpq_class inWorldUnits(const Fraction& fraction, long exponent) {
  mpq_class result(fraction.numerator, fraction.denominator);
  result.canonicalize();
  return exponent >= 0 ? mpq_class(result << static_cast<mp_bitcnt_t>(2 * exponent))
                       : mpq_class(result >> static_cast<mp_bitcnt_t>(-2 * exponent));
}

}  // namespace

Location locate(const Polygon& polygon, const Vec2& point) {
  const DyadicRings rings = unposed(polygon.rings()), points = unposed({{point}});
  const long exponent = finestExponent(points, finestExponent(rings, 0));
  const Shape shape = gridded(rings, polygon.fillRule(), polygon.isComplement(), exponent);
  return locate(shape, edges(shape), gridded(points, FillRule::EvenOdd, false, exponent).rings[0][0]);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const Pair pair = griddedPair(a, pose_a, b, pose_b);
  return collide(pair, edges(pair.a), edges(pair.b));
}

bool interiorsMeet(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  if (a.isComplement() && b.isComplement()) return true;  // far away
  const Pair pair = griddedPair(a, pose_a, b, pose_b);
  std::vector<Edge> all = edges(pair.a);
  const std::size_t count_of_a = all.size();
  for (const Edge& e : edges(pair.b)) all.push_back(e);
  const std::vector<mpq_class> breaks = breaksOf(all);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (bothFilledAt((breaks[i] + breaks[i + 1]) / 2, pair, all, count_of_a)) return true;
  }
  return false;
}

std::vector<bool> edgesOfCrossings(const Polygon& polygon) {
  std::vector<bool> are_edges;
  for (const Ring& ring : polygon.rings()) {
    const bool is_point = std::all_of(ring.begin(), ring.end(), [&](const Vec2& p) { return p == ring[0]; });
    for (std::size_t i = 0; i < ring.size(); ++i)
      are_edges.push_back(ring.size() == 3 || (is_point ? i == 0 : ring[i] != ring[i + 1 < ring.size() ? i + 1 : 0]));
  }
  return are_edges;
}

std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> meetingEdges(const Polygon& a, const Pose& pose_a,
                                                                    const Polygon& b, const Pose& pose_b) {
  const Pair pair = griddedPair(a, pose_a, b, pose_b);
  const std::vector<Edge> edges_a = edges(pair.a), edges_b = edges(pair.b);
  const std::vector<bool> cross_a = edgesOfCrossings(a), cross_b = edgesOfCrossings(b);
  std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> result;
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    for (std::size_t j = 0; j < edges_b.size(); ++j) {
      if (cross_a[i] && cross_b[j] && edgesMeet(edges_a[i], edges_b[j])) result.emplace_back(i, j);
    }
  }
  return result;
}

mpq_class distanceSquared(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const Pair pair = griddedPair(a, pose_a, b, pose_b);
  const std::vector<Edge> edges_a = edges(pair.a), edges_b = edges(pair.b);
  if (collide(pair, edges_a, edges_b)) return 0;
  Fraction least = squaredDistance(*edges_a[0].v, *edges_b[0].v, *edges_b[0].w);
  for (const Edge& e : edges_a) {
    for (const Edge& f : edges_b) {
      // Every vertex starts an edge, so the starts against the other's edges are all pairs.
      least = std::min({least, squaredDistance(*e.v, *f.v, *f.w), squaredDistance(*f.v, *e.v, *e.w)});
    }
  }
  return inWorldUnits(least, pair.exponent);
}

mpq_class distanceSquared(const Vec2& point, const Vec2& v, const Vec2& w) {
  const DyadicRings points = unposed({{point, v, w}});
  const long exponent = finestExponent(points, 0);
  const Shape grid = gridded(points, FillRule::EvenOdd, false, exponent);
  const std::vector<Point>& p = grid.rings[0];
  return inWorldUnits(squaredDistance(p[0], p[1], p[2]), exponent);
}

std::optional<FirstHit> castRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to) {
  const Pair pair = griddedPair(polygon, pose, Polygon({{from, to, to}}), Pose::Identity());
  const std::vector<Edge> all = edges(pair.a);
  const Point &start = pair.b.rings[0][0], &end = pair.b.rings[0][1], way = {end.x - start.x, end.y - start.y};
  if (locate(pair.a, all, start) != Location::Outside) return FirstHit{0, -1};
  const Edge ray = edge(start, end);
  std::optional<Fraction> least;
  std::ptrdiff_t first = -1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!edgesMeet(ray, all[i])) continue;
    const Fraction fraction = fractionOfWay(start, way, all[i]);
    if (least && !(fraction < *least)) continue;
    least = fraction;
    first = static_cast<std::ptrdiff_t>(i);
  }
  if (!least) return std::nullopt;
  return FirstHit{inWorldUnits(*least, 0), first};
}

std::vector<RayPart> castRayAll(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to) {
  const Pair pair = griddedPair(polygon, pose, Polygon({{from, to, to}}), Pose::Identity());
  const std::vector<Edge> all = edges(pair.a);
  const Point &start = pair.b.rings[0][0], &end = pair.b.rings[0][1], way = {end.x - start.x, end.y - start.y};
  std::vector<RayPart> intervals;
  if (from == to) {
    if (locate(pair.a, all, start) != Location::Outside) intervals.push_back({{0, -1}, {1, -1}});
    return intervals;
  }
  const Edge ray = edge(start, end);
  std::map<mpq_class, std::ptrdiff_t> firsts, lasts;  // the lowest edge at each fraction
  std::vector<mpq_class> cuts = {0, 1};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!edgesMeet(ray, all[i])) continue;
    const mpq_class first = inWorldUnits(fractionOfWay(start, way, all[i]), 0);
    const mpq_class last = 1 - inWorldUnits(fractionOfWay(end, {-way.x, -way.y}, all[i]), 0);
    firsts.emplace(first, i);
    lasts.emplace(last, i);
    cuts.insert(cuts.end(), {first, last});
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  while (cuts.front() < 0) cuts.erase(cuts.begin());  // an edge along the ray may begin before it
  while (cuts.back() > 1) cuts.pop_back();
  // On a grid as fine as the middle needs.
  const auto isInsideAt = [&](const mpq_class& fraction) {
    Shape fine = pair.a;
    const mpz_class &n = fraction.get_num(), &d = fraction.get_den();
    for (auto& ring : fine.rings)
      for (Point& p : ring) p = {p.x * d, p.y * d};
    return locate(fine, edges(fine), {start.x * d + way.x * n, start.y * d + way.y * n}) != Location::Outside;
  };
  bool is_open = false;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const mpq_class& cut = cuts[i];
    const bool is_in = firsts.count(cut) + lasts.count(cut) > 0 || (i > 0 && i + 1 < cuts.size()) ||
                       locate(pair.a, all, i == 0 ? start : end) != Location::Outside;
    if (!is_in) continue;
    if (!is_open) intervals.push_back({{cut, i == 0 ? -1 : firsts.at(cut)}, {}});
    is_open = i + 1 < cuts.size() && isInsideAt((cut + cuts[i + 1]) / 2);
    if (!is_open) intervals.back().end = {cut, i + 1 == cuts.size() ? -1 : lasts.at(cut)};
  }
  return intervals;
}

bool within(const mpq_class& distance_squared, const mpq_class& length) { return distance_squared <= length * length; }

double distanceBelow(const mpq_class& distance_squared) {
  double root = mpf_class(sqrt(mpf_class(distance_squared, 256))).get_d();
  if (!std::isfinite(root)) return std::numeric_limits<double>::infinity();
  while (mpq_class(root) * root > distance_squared) root = std::nextafter(root, 0.0);
  return root;
}

}  // namespace tricover::exact
