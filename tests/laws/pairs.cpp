// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "reference.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/distance.h"

namespace tricover::laws {
namespace {

using namespace support;

constexpr double kTurn = 6.283185307179586;

double powerOf10(Random& random, double low, double high) { return std::pow(10, random.real(low, high)); }

Vec2 anyVector(Random& random, double reach) { return {random.real(-reach, reach), random.real(-reach, reach)}; }

/// Flat as needles, some of them.
Ring convex(Random& random, int most_vertices) {
  const int most = random.oneIn(3) ? 4 : most_vertices;
  return eitherWay(random, random.oneIn(8) ? regular(random.integer(3, most), 1) : anyConvex(random, 1, most, 1e-6));
}

/// A corner cut off by hardly anything, down to an ulp.
Ring chamfered(Random& random, Ring ring) {
  for (int k = random.integer(1, 2); k > 0; --k) {
    const auto n = static_cast<int>(ring.size());
    const auto i = static_cast<std::size_t>(random.integer(0, n - 1));
    const Vec2 p = ring[i], before = ring[i == 0 ? ring.size() - 1 : i - 1], after = ring[(i + 1) % ring.size()];
    const double cut = powerOf10(random, -17, -1);
    ring[i] = p + cut * (before - p);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, p + cut * (after - p));
  }
  return ring;
}

/// Vertices along edges, exactly on them or nearly so, some of them said twice.
Ring straightened(Random& random, const Ring& ring) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &v = ring[i], &w = ring[(i + 1) % ring.size()];
    result.insert(result.end(), random.oneIn(6) ? 2 : 1, v);
    double at = 0;
    while (random.coin() && (at += random.real(0.05, 0.6)) < 1) {
      Vec2 p = (1 - at) * v + at * w;
      if (random.oneIn(3)) p += powerOf10(random, -17, -6) * anyVector(random, 1);
      result.push_back(p);
    }
  }
  return result;
}

/// On one line, or in one point.
Ring flat(Random& random) {
  const Vec2 p = random.coin() ? Vec2(Vec2::Zero()) : anyVector(random, 1), q = p + anyVector(random, 1);
  if (random.oneIn(3)) return Ring(3, p);
  if (random.oneIn(3)) return {p, q, q};
  Ring ring;
  for (int n = random.integer(3, 7); n > 0; --n) ring.push_back(p + random.integer(-4, 4) / 4.0 * (q - p));
  return ring;
}

Ring onGrid(Random& random) {
  Ring ring;
  for (int n = random.integer(3, 9); n > 0; --n)
    ring.emplace_back(random.integer(-4, 4) / 4.0, random.integer(-4, 4) / 4.0);
  return ring;
}

Ring soup(Random& random) {
  Ring ring;
  for (int n = random.integer(3, 9); n > 0; --n) ring.push_back(anyVector(random, 1));
  return ring;
}

/// With a hole, or of several parts.
std::vector<Ring> severalRings(Random& random) {
  if (random.coin()) {
    Ring hole = star(random, random.integer(3, 6), 0.2, 0.5);
    return {star(random, random.integer(5, 10), 0.7, 1), random.coin() ? hole : reversed(hole)};
  }
  std::vector<Ring> rings;
  for (int n = random.integer(2, 4); n > 0; --n)
    rings.push_back(shifted(scaled(random.oneIn(3) ? soup(random) : convex(random, 6), 0.5), anyVector(random, 0.6)));
  return rings;
}

/// Islands of a map, some of which touch: so many that their starts are found by the tree, where as many are asked for.
std::vector<Ring> map(Random& random, int most_vertices) {
  std::vector<Ring> rings;
  const int side = most_vertices < 40 ? 2 : random.integer(4, 5);
  for (int i = 0; i < side * side; ++i) {
    const double x = i % side, y = i / side, reach = random.oneIn(4) ? 1 : random.real(0.1, 0.9);
    rings.push_back(scaled(random.coin() ? Ring{{x, y}, {x + reach, y}, {x + reach, y + reach}, {x, y + reach}}
                                         : Ring{{x, y}, {x + reach, y}, {x, y + reach}},
                           1.0 / side));
  }
  return rings;
}

using Rings = std::vector<Ring>;

struct Shape {
  const char* name;
  bool convex;
  Rings (*make)(Random& random, int most_vertices);
};

constexpr Shape kShapes[] = {
    {"any_convex", true, [](Random& r, int most) { return Rings{convex(r, most)}; }},
    {"any_chamfered", true, [](Random& r, int most) { return Rings{chamfered(r, convex(r, most))}; }},
    {"any_straightened", false, [](Random& r, int) { return Rings{straightened(r, convex(r, 10))}; }},
    {"any_straight", true,
     [](Random& r, int most) { return Rings{withStraightVertices(r, convex(r, std::min(most, 10)))}; }},
    {"any_flat", false, [](Random& r, int) { return Rings{flat(r)}; }},
    {"any_starred", false,
     [](Random& r, int most) { return Rings{star(r, r.integer(4, std::min(most, 24)), 0.2, 1)}; }},
    {"any_comb", false, [](Random& r, int) { return Rings{scaled(comb(r.integer(2, 4), 0.5, 0.25, 1), 0.5)}; }},
    {"any_grid", false, [](Random& r, int) { return Rings{onGrid(r)}; }},
    {"any_soup", false, [](Random& r, int) { return Rings{soup(r)}; }},
    {"any_rings", false, [](Random& r, int) { return severalRings(r); }},
    {"any_map", false, [](Random& r, int most) { return map(r, most); }},
};

Vec2 pointOf(Random& random, const Polygon& polygon) {
  const EdgeIndex edge = anyEdge(random, polygon);
  const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge);
  return random.coin() ? v : Vec2(v + random.integer(1, 7) / 8.0 * (w - v));
}

/// Where b touches a on the way to a's S, and by so much of the sizes aside, either way.
void toContact(Random& random, Case& c, double size) {
  const Vec2 away = direction(random.real(0, kTurn)) * (c.a.radius() + c.b.radius());
  const ContactOnWay way = contactOnWay(c, away, 1.1, random.integer(4, 56));
  c.pose_b.translation() = c.pose_a.translation() + (random.coin() ? way.near : way.far) * away;
  if (random.coin()) c.pose_b.translation() += powerOf10(random, -17, 0) * anyVector(random, size);
}

const Shape& anyKind(Random& random, const Limits& limits) {
  for (;;) {
    const Shape& shape = kShapes[random.integer(0, static_cast<int>(std::size(kShapes)) - 1)];
    if (shape.convex || !limits.convex) return shape;
  }
}

Polygon make(Random& random, const Shape& shape, const Limits& limits) {
  std::vector<Ring> rings = shape.make(random, limits.most_vertices);
  if (!limits.convex && random.oneIn(10)) rings[0] = withRepeatedAndMidpoints(random, rings[0]);
  return Polygon(rings, random.oneIn(3) ? FillRule::NonZero : FillRule::EvenOdd);
}

/// As they come: exact, turned, mirrored, made of floats, hardly rigid any more.
Pose anyRotation(Random& random) {
  Pose result = support::turnedAndMoved(random.integer(0, 3) * kTurn / 4, 0, 0);
  if (random.oneIn(4)) result = Pose::Identity();
  if (random.coin()) result = support::turnedAndMoved(random.real(0, kTurn), 0, 0);
  if (random.oneIn(4)) result = mirrored(result);
  if (random.oneIn(5)) result = throughFloat(result);
  if (random.oneIn(5)) result = distorted(random, result);
  return result;
}

/// b to somewhere about a: anywhere, a vertex on the other one's vertex or edge, at the contact on a way and a little
/// aside, or far away.
void place(Random& random, Case& c) {
  const double size = std::min(c.a.radius(), c.b.radius()), reach = c.a.radius() + c.b.radius();
  const Vec2 before = c.pose_b.translation();
  const int manner = random.integer(0, 7);
  if (manner < 2 && reach + c.pose_a.translation().stableNorm() < 1e306) {
    toContact(random, c, size);
  } else if (manner < 4) {
    c.pose_b.translation() = c.pose_a * pointOf(random, c.a) - c.pose_b.linear() * pointOf(random, c.b);
    if (random.coin()) c.pose_b.translation() += powerOf10(random, -17, 0) * anyVector(random, size);
  } else {
    const double far = manner == 4 ? powerOf10(random, 0, 4) : 0.8;
    c.pose_b.translation() = c.pose_a.translation() + anyVector(random, reach * far);
  }
  if (!c.pose_b.translation().allFinite()) c.pose_b.translation() = before;
}

Case makeCase(Random& random, const Shape& shape, const Limits& limits) {
  Polygon a = make(random, shape, limits), b = anyShape(random, limits);
  const double most = limits.most_exponent, ratio = random.oneIn(4) ? powerOf10(random, -12, 0) : random.real(0.2, 1);
  const double size = random.oneIn(6) ? powerOf10(random, -most, most) : random.oneIn(3) ? random.real(1, 100) : 1;
  if (random.coin()) std::swap(a, b);
  a = a.scaled(size);
  b = b.scaled(size * ratio);
  if (random.coin()) std::swap(a, b);
  Case c{a, anyRotation(random), b, anyRotation(random)};
  if (random.oneIn(3))
    c.pose_a.translation() = anyVector(random, size * (random.oneIn(8) ? powerOf10(random, 0, 9) : 9));
  if (!c.pose_a.translation().allFinite()) c.pose_a.translation().setZero();
  c.pose_b.translation() = c.pose_a.translation();
  place(random, c);
  return c;
}

}  // namespace

std::vector<Family> anyPairs(const Limits& limits) {
  std::vector<Family> families;
  for (const Shape& shape : kShapes)
    if (shape.convex || !limits.convex)
      families.push_back({shape.name, [&shape, limits](std::uint64_t seed) {
                            Random random(seed);
                            return makeCase(random, shape, limits);
                          }});
  return families;
}

Case anyCase(Random& random, const Limits& limits) { return makeCase(random, anyKind(random, limits), limits); }

Polygon anyShape(Random& random, const Limits& limits) { return make(random, anyKind(random, limits), limits); }

double smallerRadius(const Case& c) { return std::min(c.a.radius(), c.b.radius()); }

void step(Random& random, Case& c) {
  if (random.oneIn(20)) return place(random, c);
  const double size = std::min(c.a.radius(), c.b.radius());
  const Vec2 by = powerOf10(random, -17, 0) * anyVector(random, size);
  const double angle = random.coin() ? 0 : random.real(-1, 1) * powerOf10(random, -16, -0.5);
  const int which = random.integer(0, 3);  // b, b, a, or both by the same
  const auto moved = [&](Pose& pose) {
    Pose result = support::turnedAndMoved(angle, 0, 0) * pose;
    result.translation() = pose.translation() + by;
    if (result.translation().allFinite()) pose = result;
  };
  if (which != 2) moved(c.pose_b);
  if (which >= 2) moved(c.pose_a);
}

Case smallAmongManyRings(Random& random) {
  std::vector<Ring> rings;
  for (int k = random.integer(16, 60); k > 0; --k)
    rings.push_back(shifted(rectangle(0, 0, random.real(0.1, 0.8), random.real(0.1, 0.8)), anyVector(random, 6)));
  // Some overlap, or touch.
  for (int k = random.integer(2, 25); k > 0; --k) {
    const Vec2 at(random.integer(0, 9), random.integer(0, 9));
    rings.push_back(
        {at, at + Vec2(random.oneIn(8) ? 20 : 1, random.integer(0, 1)), at + Vec2(random.integer(0, 1), 1)});
  }
  if (random.coin()) rings.push_back(rectangle(-9, -9, 9, 9));
  if (random.coin()) rings.push_back(star(random, 40, 6, 9));
  const Polygon map(rings, random.coin() ? FillRule::NonZero : FillRule::EvenOdd);
  const double reach = random.real(0.2, 1.2);
  std::vector<Ring> small = {random.coin() ? regular(random.integer(3, 8), reach) : star(random, 8, 0.2, reach)};
  if (random.coin()) small.push_back(regular(random.integer(3, 8), 0.15));
  const Pose still = support::turnedAndMoved(random.real(0, kTurn), 3, -2);
  const Pose at = still * randomPose(random, 9);
  return random.coin() ? Case{map, still, Polygon(small), at} : Case{Polygon(small), at, map, still};
}

Case pushed(Random& random, Case c) {
  if (random.coin()) return c;
  const Vec2 way = c.pose_a * c.a.coveringOrigin() - c.pose_b * c.b.coveringOrigin();
  const double length = way.stableNorm();
  if (!(length > 0) || !std::isfinite(length)) return c;
  const double left = random.oneIn(4) ? 0 : std::min({smallerRadius(c), length, 1e300}) * random.unit();
  const Vec2 by = way * ((length - left) / length);
  if ((c.pose_b.translation() + by).allFinite()) c.pose_b.translation() += by;
  return c;
}

double anyMargin(Random& random, const Case& c) {
  const double size = std::max(c.a.radius(), c.b.radius());
  if (random.coin() || !(size > 1e-140 && size < 1e140)) return 0;
  const auto apart = static_cast<double>(Reference(c).distance().low);
  const double margin = random.oneIn(4) ? size * random.unit()
                        : random.coin() ? apart * random.real(0.5, 1.5)
                                        : nudged(apart, random.integer(-1, 1));
  return margin < 1e150 ? std::max(margin, 0.0) : 0;
}

namespace {

/// Through `pose` at some time, or at rest there.
Motion anyMotion(Random& random, const Polygon& polygon, const Pose& pose, double reach) {
  Motion motion = Motion::still(pose);
  if (random.oneIn(4)) return motion;
  const auto way = [&] {
    return Vec2(reach * std::pow(10, random.real(-2, 1)) * Vec2(random.real(-1, 1), random.real(-1, 1)));
  };
  motion.shift = way();
  if (random.coin()) {
    motion.angle = random.real(-1, 1) * (random.oneIn(4) ? 30 : 3);
    motion.pivot = random.coin() ? polygon.coveringOrigin() : random.coin() ? Vec2(Vec2::Zero()) : way();
    if (random.oneIn(4)) motion.shift.setZero();
  }
  if (random.oneIn(4)) {
    motion.shift_2 = way();
    motion.shift_3 = way();
    motion.angle_2 = motion.angle == 0 ? 0 : random.real(-3, 3);
  }
  const double t = random.unit(), turn = t * motion.angle + t * t * motion.angle_2;
  motion.start.linear() = support::turnedAndMoved(-turn, 0, 0).linear() * pose.linear();
  motion.start.translation() = pose * motion.pivot - t * motion.shift - t * t * motion.shift_2 -
                               t * t * t * motion.shift_3 - motion.start.linear() * motion.pivot;
  return motion;
}

}  // namespace

MovingCase anyFlight(Random& random, const Case& c) {
  const double reach = c.a.radius() + c.b.radius();
  const Motion motion_a = anyMotion(random, c.a, c.pose_a, reach), motion_b = anyMotion(random, c.b, c.pose_b, reach);
  return {c.a, motion_a, c.b, motion_b};
}

StrategyCaches cachesOfOthers(Random& random) {
  // Made as they are asked for, each always alike.
  struct Other {
    Case c;
    StrategyCaches caches;
  };
  static std::vector<std::unique_ptr<Other>> others(3 * families().size());
  const auto k = static_cast<std::size_t>(random.integer(0, static_cast<int>(others.size()) - 1));
  if (!others[k]) {
    others[k] = std::make_unique<Other>(Other{families()[k % families().size()].make(k), {}});
    for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper})
      for (int i = 0; i < 2; ++i)
        collide(strategy, others[k]->c.a, others[k]->c.pose_a, others[k]->c.b, others[k]->c.pose_b, others[k]->caches);
    distance(others[k]->c.a, others[k]->c.pose_a, others[k]->c.b, others[k]->c.pose_b, others[k]->caches.of_pair);
  }
  return others[k]->caches;
}

std::vector<Family> joined(std::vector<Family> families, const std::vector<Family>& more) {
  families.insert(families.end(), more.begin(), more.end());
  return families;
}

}  // namespace tricover::laws
