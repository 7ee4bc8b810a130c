// SPDX-License-Identifier: BSD-3-Clause
#include "workloads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace tricover::workloads {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadius = 50;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// std::uniform_real_distribution differs between standard libraries; this does not.
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

Vec2 onGrid(double x, double y) { return {std::round(x / kGrid) * kGrid, std::round(y / kGrid) * kGrid}; }

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// Sign of the triangle (a, b, c); exact on the grid.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double area = cross(b - a, c - a);
  return (area > 0) - (area < 0);
}

/// A ring around the origin with one vertex in each of n equal sectors; `radius` is called with the vertex's index and
/// angle.
template <class Radius>
Ring starShaped(std::size_t n, double squeeze, Random& random, Radius radius) {
  Ring ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = (static_cast<double>(i) + random.uniform(0, 0.5)) * 2 * kPi / static_cast<double>(n);
    const double r = radius(i, angle);
    ring.push_back(onGrid(r * std::cos(angle), squeeze * r * std::sin(angle)));
  }
  return ring;
}

Ring convexRing(std::size_t n, double squeeze, Random& random) {
  return starShaped(n, squeeze, random, [](std::size_t, double) { return kRadius; });
}

Ring starredRing(std::size_t n, double radius, Random& random) {
  return starShaped(n, 0.6, random, [&](std::size_t i, double) {
    return radius * (i % 2 == 0 ? random.uniform(0.8, 1) : random.uniform(0.35, 0.55));
  });
}

/// Oblong by the second harmonic; the others, up to a quarter of the vertices, fall as 1/k: as rough as a coast at
/// every scale.
Ring contourRing(std::size_t n, Random& random) {
  std::vector<std::pair<double, double>> harmonics = {{0.25, 0}};
  for (std::size_t k = 3; k <= std::max<std::size_t>(n / 4, 3); ++k) {
    harmonics.emplace_back(random.uniform(0.05, 0.2) / static_cast<double>(k), random.uniform(0, 2 * kPi));
  }
  return starShaped(n, 1, random, [&](std::size_t, double angle) {
    double sum = 0.65;
    double k = 2;
    for (const auto& [size, phase] : harmonics) sum += size * std::cos(k++ * angle + phase);
    return kRadius * std::clamp(sum, 0.25, 1.0);
  });
}

/// Whether the closed segments share a point; exact on the grid.
bool segmentsMeet(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
  const int pr = orientation(p, q, r), ps = orientation(p, q, s);
  const int rp = orientation(r, s, p), rq = orientation(r, s, q);
  if (pr != ps && rp != rq) return true;
  if (pr != 0 || ps != 0) return false;
  const Vec2 low = p.cwiseMin(q), high = p.cwiseMax(q);
  return (r.cwiseMax(s).array() >= low.array()).all() && (r.cwiseMin(s).array() <= high.array()).all();
}

/// Random points visited along a row-wise serpentine; then every crossing is undone by reversing the walk between the
/// two edges, which shortens it each time and therefore ends.
Ring irregularRing(std::size_t n, Random& random) {
  const auto rows = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n) / 2)));
  Ring ring;
  for (std::size_t i = 0; i < n; ++i) {
    ring.push_back(onGrid(random.uniform(-0.9, 0.9) * kRadius, random.uniform(-0.4, 0.4) * kRadius));
  }
  std::sort(ring.begin(), ring.end(), [](const Vec2& u, const Vec2& v) { return u.y() < v.y(); });
  for (std::size_t row = 0; row < rows; ++row) {
    const auto first = ring.begin() + static_cast<std::ptrdiff_t>(row * n / rows);
    const auto last = ring.begin() + static_cast<std::ptrdiff_t>((row + 1) * n / rows);
    std::sort(first, last, [&](const Vec2& u, const Vec2& v) { return row % 2 ? u.x() > v.x() : u.x() < v.x(); });
  }
  for (bool crossed = true; crossed;) {
    crossed = false;
    for (std::size_t i = 0; i + 2 < n; ++i) {
      for (std::size_t j = i + 2; j < n; ++j) {
        if ((j + 1) % n == i || !segmentsMeet(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) continue;
        std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        crossed = true;
      }
    }
  }
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) area += cross(ring[i], ring[(i + 1) % n]);
  if (area < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

double distanceToSegment(const Vec2& p, const Vec2& v, const Vec2& w) {
  const Vec2 edge = w - v;
  const double along = std::clamp((p - v).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (p - v - along * edge).norm();
}

std::vector<Ring> ringsWithHole(std::size_t n, Random& random) {
  Ring outer = contourRing(n - n / 2, random);
  double inner_radius = kRadius;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    inner_radius = std::min(inner_radius, distanceToSegment(Vec2::Zero(), outer[i], outer[(i + 1) % outer.size()]));
  }
  Ring hole = starredRing(n / 2, 0.9 * inner_radius, random);
  std::reverse(hole.begin(), hole.end());
  return {std::move(outer), std::move(hole)};
}

std::vector<Ring> makeRings(Kind kind, std::size_t vertices, Random& random) {
  switch (kind) {
    case Kind::Convex:
      return {convexRing(vertices, 1, random)};
    case Kind::Slim:
      return {convexRing(vertices, 0.15, random)};
    case Kind::Starred:
      return {starredRing(vertices, kRadius, random)};
    case Kind::Contour:
      return {contourRing(vertices, random)};
    case Kind::Irregular:
      return {irregularRing(vertices, random)};
    case Kind::WithHole:
      return ringsWithHole(vertices, random);
  }
  throw std::invalid_argument("kind: not a Kind");
}

/// The largest x at which (v, w), shifted by x to the right, is `distance` away from `point` (it is farther at every
/// larger x); -infinity where it passes by.
double lastApproach(const Vec2& point, const Vec2& v, const Vec2& w, double distance) {
  double last = -std::numeric_limits<double>::infinity();
  for (const Vec2& end : {v, w}) {
    const double y = end.y() - point.y();
    if (std::abs(y) > distance) continue;
    last = std::max(last, point.x() - end.x() + std::sqrt((distance - y) * (distance + y)));
  }
  // The disc around the point touches the inside of the edge at the foot of the normal that has the disc on its left.
  Vec2 normal = Vec2(w.y() - v.y(), v.x() - w.x());
  if (normal.x() == 0) return last;
  normal *= (normal.x() > 0 ? distance : -distance) / normal.norm();
  const double y = point.y() + normal.y();
  if (y < std::min(v.y(), w.y()) || y > std::max(v.y(), w.y())) return last;
  const double x = v.x() + (w.x() - v.x()) * (y - v.y()) / (w.y() - v.y());
  return std::max(last, point.x() + normal.x() - x);
}

struct Edge {
  Vec2 v, w;
};

std::vector<Edge> edgesAroundOrigin(const Polygon& polygon) {
  std::vector<Edge> edges;
  for (EdgeIndex i = 0; i < polygon.edgeCount(); ++i) {
    edges.push_back({polygon.edgeStart(i) - polygon.coveringOrigin(), polygon.edgeEnd(i) - polygon.coveringOrigin()});
  }
  return edges;
}

/// The same for polygons whose origins lie at (0, 0) and (x, 0).
double lastApproach(const Polygon& fixed, const Polygon& moving, double distance) {
  const auto mirrored = [](const Vec2& p) { return Vec2(-p.x(), p.y()); };
  const auto fixed_edges = edgesAroundOrigin(fixed), moving_edges = edgesAroundOrigin(moving);
  double last = -std::numeric_limits<double>::infinity();
  for (const auto& [v, w] : fixed_edges) {
    for (const auto& [p, q] : moving_edges) {
      last = std::max(
          {last, lastApproach(v, p, q, distance), lastApproach(mirrored(p), mirrored(v), mirrored(w), distance)});
    }
  }
  return last;
}

/// The polygon's origin where an arm ends that turns around the fixed one's origin; on the arm the polygon is turned by
/// `own_angle` more.
Pose onArm(const Polygon& fixed, const Polygon& moving, double arm_angle, double arm, double own_angle) {
  const Eigen::Rotation2Dd turn(arm_angle);
  Pose pose = Pose::Identity();
  pose.linear() = (turn * Eigen::Rotation2Dd(own_angle)).toRotationMatrix();
  pose.translation() = fixed.coveringOrigin() + turn * Vec2(arm, 0) - pose.linear() * moving.coveringOrigin();
  return pose;
}

/// How long the arm must be for a polygon turned by own_angle, with its nearest point at that distance from the pivot,
/// and the direction in which that point lies.
struct Arm {
  double own_angle, length, nearest_angle;
};

Arm fittingArm(const std::vector<Edge>& edges, double own_angle, double distance) {
  const Eigen::Rotation2Dd turn(own_angle);
  Arm result{own_angle, -std::numeric_limits<double>::infinity(), 0};
  for (const Edge& edge : edges) {
    const Vec2 v = turn * edge.v, w = turn * edge.w;
    const double length = lastApproach(Vec2::Zero(), v, w, distance);
    if (length <= result.length) continue;
    const Vec2 start = v + Vec2(length, 0);
    const Vec2 nearest = start + (w - v) * std::clamp(-start.dot(w - v) / (w - v).squaredNorm(), 0.0, 1.0);
    result = {own_angle, length, std::atan2(nearest.y(), nearest.x())};
  }
  return result;
}

std::vector<Edge> turned(std::vector<Edge> edges, double angle) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  for (Edge& edge : edges) edge = {turn * edge.v, turn * edge.w};
  return edges;
}

/// For each height the largest x at which an edge has it; -infinity where none does. Heights are in ascending order.
std::vector<double> rightmost(const std::vector<Edge>& edges, const std::vector<double>& heights) {
  std::vector<double> profile(heights.size(), -std::numeric_limits<double>::infinity());
  for (Edge edge : edges) {
    if (edge.v.y() > edge.w.y()) std::swap(edge.v, edge.w);
    const double rise = edge.w.y() - edge.v.y();
    auto i = static_cast<std::size_t>(std::lower_bound(heights.begin(), heights.end(), edge.v.y()) - heights.begin());
    for (; i < heights.size() && heights[i] <= edge.w.y(); ++i) {
      const double part = rise > 0 ? (heights[i] - edge.v.y()) / rise : 0;
      profile[i] = std::max(profile[i], edge.v.x() + part * (edge.w.x() - edge.v.x()));
      if (heights[i] == edge.w.y()) profile[i] = std::max(profile[i], edge.w.x());
    }
  }
  return profile;
}

/// How far to the right of its own frame the moving outline touches the fixed one when it comes from the far right. The
/// gap at a height is linear between the vertices' heights, so that one of these is where they touch.
double firstContact(const std::vector<Edge>& fixed, std::vector<Edge> moving) {
  std::vector<double> heights;
  for (const Edge& edge : fixed) heights.push_back(edge.v.y());
  for (const Edge& edge : moving) heights.push_back(edge.v.y());
  std::sort(heights.begin(), heights.end());
  for (Edge& edge : moving) edge = {Vec2(-edge.v.x(), edge.v.y()), Vec2(-edge.w.x(), edge.w.y())};
  const auto right = rightmost(fixed, heights), left = rightmost(moving, heights);
  double shift = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < heights.size(); ++i) shift = std::max(shift, right[i] + left[i]);
  return shift;
}

/// `arm(arm_angle, own_angle, random)` is the distance between the origins.
template <class ArmLength>
std::vector<Pose> randomPoses(const Polygon& fixed, const Polygon& moving, std::uint64_t seed, std::size_t positions,
                              ArmLength arm) {
  Random random(seed);
  std::vector<Pose> poses;
  poses.reserve(positions);
  for (std::size_t i = 0; i < positions; ++i) {
    const double arm_angle = random.uniform(0, 2 * kPi), own_angle = random.uniform(0, 2 * kPi);
    poses.push_back(onArm(fixed, moving, arm_angle, arm(arm_angle, own_angle, random), own_angle));
  }
  return poses;
}

}  // namespace

const std::vector<Kind>& allKinds() {
  static const std::vector<Kind> kinds = {Kind::Convex,  Kind::Slim,      Kind::Starred,
                                          Kind::Contour, Kind::Irregular, Kind::WithHole};
  return kinds;
}

std::string name(Kind kind) {
  switch (kind) {
    case Kind::Convex:
      return "convex";
    case Kind::Slim:
      return "slim";
    case Kind::Starred:
      return "starred";
    case Kind::Contour:
      return "contour";
    case Kind::Irregular:
      return "irregular";
    case Kind::WithHole:
      return "with hole";
  }
  throw std::invalid_argument("kind: not a Kind");
}

Polygon makePolygon(Kind kind, std::size_t vertices, std::uint64_t seed) {
  if (vertices < 8 || vertices > 1024 || vertices % 2 != 0) {
    throw std::invalid_argument("vertices: " + std::to_string(vertices) + " is not an even number from 8 to 1024");
  }
  Random random(seed);
  return Polygon(makeRings(kind, vertices, random));
}

Polygon makeOverlapping(std::size_t rings, std::size_t corners, double squeeze, std::uint64_t seed) {
  if (rings < 2 || corners < 3) throw std::invalid_argument("rings, corners: at least 2 of at least 3");
  if (!(squeeze >= 0.05 && squeeze <= 1)) throw std::invalid_argument("squeeze: not in [0.05, 1]");
  Random random(seed);
  // About three rings cover each point of an ellipse, 1 x 0.6.
  const double length = kRadius * std::sqrt(3 / (static_cast<double>(rings) * squeeze));
  std::vector<Ring> all;
  for (std::size_t i = 0; i < rings; ++i) {
    const double angle = random.uniform(0, 2 * kPi), far = kRadius * std::sqrt(random.uniform(0, 1));
    const Vec2 middle(far * std::cos(angle), 0.6 * far * std::sin(angle));
    const Eigen::Rotation2Dd turn(random.uniform(0, 2 * kPi));
    Ring ring = starShaped(corners, squeeze, random,
                           [&](std::size_t, double) { return std::min(length, kRadius) * random.uniform(0.6, 1); });
    for (Vec2& v : ring) {
      const Vec2 placed = middle + turn * v;
      v = onGrid(placed.x(), placed.y());
    }
    all.push_back(std::move(ring));
  }
  return Polygon(std::move(all), FillRule::NonZero);
}

std::vector<Pose> circularTrajectory(const Polygon& fixed, const Polygon& moving, double gap, std::size_t positions) {
  double swept = 0, farthest_angle = 0;
  for (const auto& [v, w] : edgesAroundOrigin(fixed)) {
    if (v.norm() <= swept) continue;
    swept = v.norm();
    farthest_angle = std::atan2(v.y(), v.x());
  }
  const auto edges = edgesAroundOrigin(moving);
  Arm arm = fittingArm(edges, 0, swept + gap);
  for (int degrees = 1; degrees < 360; ++degrees) {
    const Arm other = fittingArm(edges, degrees * kPi / 180, swept + gap);
    if (other.length < arm.length) arm = other;
  }
  std::vector<Pose> poses;
  poses.reserve(positions);
  for (std::size_t i = 0; i < positions; ++i) {
    const double turn = 2 * kPi * static_cast<double>(i) / static_cast<double>(positions);
    poses.push_back(onArm(fixed, moving, farthest_angle - arm.nearest_angle + turn, arm.length, arm.own_angle));
  }
  return poses;
}

std::vector<Pose> linearTrajectory(const Polygon& fixed, const Polygon& moving, double gap, std::size_t positions) {
  const double start = lastApproach(fixed, moving, gap), contact = lastApproach(fixed, moving, 0);
  const double end = contact - (start - contact) / 9;
  std::vector<Pose> poses;
  poses.reserve(positions);
  for (std::size_t i = 0; i < positions; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(positions - 1);
    poses.push_back(onArm(fixed, moving, 0, start + part * (end - start), 0));
  }
  return poses;
}

std::vector<Pose> contactPoses(const Polygon& fixed, const Polygon& moving, std::uint64_t seed, std::size_t positions) {
  const auto fixed_edges = edgesAroundOrigin(fixed), moving_edges = edgesAroundOrigin(moving);
  return randomPoses(fixed, moving, seed, positions, [&](double arm_angle, double own_angle, Random& random) {
    const double first = firstContact(turned(fixed_edges, -arm_angle), turned(moving_edges, own_angle));
    return first * random.uniform(0.98, 1.02);
  });
}

std::vector<Pose> nearPoses(const Polygon& fixed, const Polygon& moving, std::uint64_t seed, std::size_t positions) {
  const double radius = (fixed.radius() + moving.radius()) / 2;
  return randomPoses(fixed, moving, seed, positions,
                     [&](double, double, Random& random) { return radius * random.uniform(1.3, 2); });
}

std::vector<Pose> overlapPoses(const Polygon& fixed, const Polygon& moving, std::uint64_t seed, std::size_t positions) {
  const double radius = (fixed.radius() + moving.radius()) / 2;
  return randomPoses(fixed, moving, seed, positions,
                     [&](double, double, Random& random) { return radius * std::sqrt(random.uniform(0, 1)); });
}

std::vector<NamedPolygon> readPolygons(std::istream& in) {
  std::vector<NamedPolygon> polygons;
  std::string word, name;
  std::size_t ring_count = 0;
  while (in >> word) {
    const auto refuse = [&](const std::string& what) { throw std::runtime_error("polygon '" + name + "': " + what); };
    if (word != "polygon" || !(in >> name >> ring_count)) refuse("expected 'polygon <name> <rings>' after it");
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < ring_count; ++i) {
      std::size_t vertex_count = 0;
      if (!(in >> word >> vertex_count) || word != "ring") refuse("expected 'ring <n>' for ring " + std::to_string(i));
      Ring ring;
      for (std::size_t k = 0; k < vertex_count; ++k) {
        Vec2 vertex;
        if (!(in >> vertex.x() >> vertex.y())) {
          refuse("ring " + std::to_string(i) + ": expected 'x y' for vertex " + std::to_string(k));
        }
        ring.push_back(vertex);
      }
      rings.push_back(std::move(ring));
    }
    polygons.push_back({name, Polygon(std::move(rings))});
  }
  return polygons;
}

}  // namespace tricover::workloads
