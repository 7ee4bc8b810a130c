// SPDX-License-Identifier: BSD-3-Clause
#include "touching_families.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "random.h"
#include "shapes.h"

namespace tricover::support {
namespace {

/// Rings of integers.
struct Lattice {
  std::vector<Ring> a, b;
  FillRule fill_a, fill_b;
};

FillRule anyFill(Random& random) { return random.coin() ? FillRule::EvenOdd : FillRule::NonZero; }

Vec2 latticePoint(Random& random, int low, int high) {
  const double x = random.integer(low, high);
  return {x, static_cast<double>(random.integer(low, high))};
}

Ring latticeRing(Random& random, int size) {
  Ring ring;
  for (int n = random.integer(3, 6); n > 0; --n) ring.push_back(latticePoint(random, 0, size));
  return ring;
}

std::vector<Ring> moved(std::vector<Ring> rings, const Vec2& by) {
  for (Ring& ring : rings) ring = shifted(ring, by);
  return rings;
}

/// The same points, said otherwise: another direction and start, an edge in two.
Ring retold(Random& random, Ring ring) {
  ring = eitherWay(random, ring);
  std::rotate(ring.begin(), ring.begin() + random.integer(0, static_cast<int>(ring.size()) - 1), ring.end());
  if (random.coin()) ring.push_back(0.5 * ring.front() + 0.5 * ring.back());
  return ring;
}

Lattice anyLattice(Random& random) {
  Lattice c{{latticeRing(random, 4)}, {latticeRing(random, 4)}, anyFill(random), anyFill(random)};
  if (random.oneIn(3)) c.a.push_back(latticeRing(random, 4));
  if (random.oneIn(3)) c.b.push_back(latticeRing(random, 4));
  c.b = moved(c.b, latticePoint(random, -5, 5));
  return c;
}

std::vector<Ring> blocks(Random& random) {
  std::vector<Ring> rings;
  for (int n = random.integer(1, 3); n > 0; --n) {
    const Vec2 low = latticePoint(random, 0, 4), size = latticePoint(random, 1, 3);
    rings.push_back(retold(random, rectangle(low.x(), low.y(), low.x() + size.x(), low.y() + size.y())));
  }
  return rings;
}

Lattice bricks(Random& random) {
  Lattice c{blocks(random), blocks(random), anyFill(random), anyFill(random)};
  c.b = moved(c.b, latticePoint(random, -7, 7));
  return c;
}

/// A hole of any lattice ring, and what fits into it.
Lattice plugs(Random& random) {
  const Ring hole = latticeRing(random, 6);
  Lattice c{{rectangle(-2, -2, 8, 8), hole}, {retold(random, hole)}, FillRule::EvenOdd, FillRule::EvenOdd};
  if (random.oneIn(6)) c.b.push_back(latticeRing(random, 6));
  if (random.oneIn(6)) c.b[0] = {hole[0], hole[1], hole[2]};
  if (random.oneIn(4)) c.b = moved(c.b, latticePoint(random, -1, 1));
  if (random.oneIn(4)) c.b = moved(c.b, {random.coin() ? 15.0 : -15.0, 3});
  if (random.oneIn(4)) std::swap(c.a, c.b);
  return c;
}

/// There and back.
Ring bareRing(Random& random) {
  Ring ring;
  for (int n = random.integer(2, 4); n > 0; --n) ring.push_back(latticePoint(random, 0, 6));
  for (std::size_t i = ring.size() - 1; i-- > 1;) ring.push_back(ring[i]);
  if (ring.size() < 3) ring.push_back(ring.back());
  return ring;
}

/// Without area, or with parts of none: spikes, rings there and back, rings twice.
std::vector<Ring> bareRings(Random& random) {
  std::vector<Ring> rings;
  for (int n = random.integer(1, 2); n > 0; --n) {
    Ring ring = random.oneIn(4) ? bareRing(random) : latticeRing(random, 5);
    if (random.coin()) {
      const Vec2 from = ring.back();
      ring.push_back(latticePoint(random, -1, 7));
      if (random.coin()) ring.push_back(from);
      if (random.coin()) ring.insert(ring.end() - 1, 0.5 * from + 0.5 * ring[ring.size() - 1]);
    }
    rings.push_back(ring);
  }
  if (random.oneIn(3)) rings.push_back(retold(random, rings[0]));
  return rings;
}

Lattice bare(Random& random) {
  Lattice c{bareRings(random), bareRings(random), anyFill(random), anyFill(random)};
  c.b = moved(c.b, latticePoint(random, -6, 6));
  if (random.oneIn(3)) c.a.push_back(rectangle(-9, -9, 9, 9));
  return c;
}

/// Wedges that meet in one point, a polygon each of several.
std::vector<Ring> fan(Random& random) {
  static const Vec2 kAround[] = {{2, 0},  {2, 1},   {2, 2},   {1, 2},   {0, 2},  {-1, 2}, {-2, 2}, {-2, 1},
                                 {-2, 0}, {-2, -1}, {-2, -2}, {-1, -2}, {0, -2}, {1, -2}, {2, -2}, {2, -1}};
  if (random.coin()) {  // in one ring that crosses itself
    const Vec2 p = kAround[random.integer(0, 15)], q = kAround[random.integer(0, 15)];
    return {{p, -p, q, -q}};
  }
  std::vector<Ring> rings;
  for (int n = random.integer(1, 2); n > 0; --n) {
    const int first = random.integer(0, 15), second = first + random.integer(1, 4);
    rings.push_back({{0, 0}, kAround[first], kAround[second % 16]});
  }
  return rings;
}

Lattice fans(Random& random) {
  Lattice c{fan(random), fan(random), anyFill(random), anyFill(random)};
  if (random.coin()) c.b = moved(c.b, latticePoint(random, -4, 4));
  return c;
}

/// As the lattice is, or turned by 3-4-5, under one pose for both or the shift in the pose, of any size, an ulp off.
Case placed(Random& random, Lattice c) {
  const bool turned = random.oneIn(3), nudge = random.oneIn(5);
  const double size = std::ldexp(1, random.oneIn(4) ? random.integer(-900, 900) : random.integer(-3, 3));
  for (std::vector<Ring>* rings : {&c.a, &c.b})
    for (Ring& ring : *rings)
      for (Vec2& p : ring) {
        if (turned) p = {3 * p.x() - 4 * p.y(), 4 * p.x() + 3 * p.y()};
        p *= size;
      }
  if (nudge) {
    Ring& ring = c.b[0];
    Vec2& p = ring[static_cast<std::size_t>(random.integer(0, static_cast<int>(ring.size()) - 1))];
    p = nudged(random, p, 1);
  }
  Pose pose_a = Pose::Identity();
  if (random.oneIn(3)) pose_a = randomPose(random, 4 * size);
  if (random.oneIn(4)) pose_a = mirrored(pose_a);
  Pose pose_b = pose_a;
  if (random.oneIn(6)) {
    const Vec2 by = size * latticePoint(random, -2, 2);
    c.b = moved(c.b, -by);
    pose_b.translation() += by;
  }
  return {Polygon(c.a, c.fill_a), pose_a, Polygon(c.b, c.fill_b), pose_b};
}

template <Lattice (*make)(Random&)>
Case makeCase(std::uint64_t seed) {
  Random random(seed);
  return placed(random, make(random));
}

}  // namespace

const std::vector<Family>& touchingFamilies() {
  static const std::vector<Family> all = {{"AnyLattice", makeCase<anyLattice>},
                                          {"Bricks", makeCase<bricks>},
                                          {"Plugs", makeCase<plugs>},
                                          {"Bare", makeCase<bare>},
                                          {"Fans", makeCase<fans>}};
  return all;
}

}  // namespace tricover::support
