// SPDX-License-Identifier: BSD-3-Clause
// Laws of all queries in all families: tests/support/laws.cpp has the laws, queries.cpp the queries.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "laws.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "touching_families.h"

namespace tricover::support {
namespace {

Pose anyPoseOfB(Random& random) {
  const double apart = random.real(0, 3);
  return pose(random.coin() ? random.real(-3, 3) : 0, apart, random.coin() ? std::round(2 * apart) / 4 : 0);
}

/// Rings that are closed by their first vertex again, as WKT's and GeoJSON's are, begun anywhere, convex or not, on a
/// lattice as often as not; here and there a vertex is said thrice.
Ring closedRing(Random& random) {
  Ring ring = random.coin() ? regular(random.integer(3, 9), 1) : star(random, random.integer(3, 20), 0.3, 1);
  if (random.coin())
    for (Vec2& v : ring) v = Vec2(std::round(4 * v.x()), std::round(4 * v.y())) / 4;
  std::rotate(ring.begin(), ring.begin() + random.integer(0, static_cast<int>(ring.size()) - 1), ring.end());
  if (random.coin()) ring = withRepeatedAndMidpoints(random, ring);
  for (int more = random.integer(0, 2); more >= 0; --more) ring.push_back(ring.front());
  return eitherWay(random, ring);
}

Case closedRings(std::uint64_t seed) {
  Random random(seed);
  const auto polygon = [&] {
    std::vector<Ring> rings = {closedRing(random)};
    if (random.oneIn(3)) rings.push_back(shifted(scaled(closedRing(random), 0.25), {0.1, 0}));
    return Polygon(rings);
  };
  const Polygon a = polygon(), b = polygon();
  return {a, Pose::Identity(), b, anyPoseOfB(random)};
}

/// Two rings of the same radius: of equal vertices, mirrored, or begun elsewhere; or the same edges around a hole and
/// around none.
Case twins(std::uint64_t seed) {
  Random random(seed);
  if (random.oneIn(16)) {
    const Ring outer = rectangle(-2, -2, 2, 2), inner = rectangle(-1, -1, 1, 1);
    const Polygon full({outer, inner}, FillRule::NonZero), hollow({outer, reversed(inner)}, FillRule::NonZero);
    const Pose both = randomPose(random, 1);
    return {full, both, hollow, both};
  }
  const Ring ring = random.coin() ? regular(random.integer(3, 12), 1) : star(random, random.integer(3, 24), 0.4, 1);
  Ring other = ring;
  if (random.coin()) std::rotate(other.begin(), other.begin() + 1, other.end());
  if (random.coin())
    for (Vec2& v : other) v.x() = -v.x();
  return {Polygon({ring}), pose(random.real(0, 6.3), 0.1, 0.7), Polygon({other}), anyPoseOfB(random)};
}

std::vector<Family> allFamilies() {
  std::vector<Family> all = familiesOfAllSizes();
  all.insert(all.end(), touchingFamilies().begin(), touchingFamilies().end());
  all.insert(all.end(), {{"closed_rings", closedRings}, {"twins", twins}});
  return all;
}

/// Contacts are shallow; b is pushed into a by up to a radius.
Case pushed(Random& random, Case c) {
  const Vec2 way = c.pose_a * c.a.origin() - c.pose_b * c.b.origin();
  const double length = way.stableNorm(), smaller = std::min(c.a.radius(), c.b.radius());
  if (length > 0 && std::isfinite(length))
    c.pose_b.translation() += way * (std::min(smaller / length, 1.0) * random.unit());
  return c;
}

/// None, the distance itself, or any.
double anyMargin(Random& random, const Case& c) {
  const double size = std::max(c.a.radius(), c.b.radius());
  if (random.coin() || !(size > 1e-140 && size < 1e140)) return 0;
  const double apart = exact::distanceBelow(exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b));
  const double margin = random.coin() ? nudged(apart, random.integer(0, 1)) : size * random.unit();
  return margin < 1e150 ? margin : 0;
}

class Laws : public testing::TestWithParam<Family> {};

TEST_P(Laws, HoldOfAllQueries) {
  const bool is_own = GetParam().make == twins || GetParam().make == closedRings;
  const int cases = scaledCount(is_own ? 400 : 40);
  int hits = 0, broken = 0;
  PairCache old;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Case made = GetParam().make(static_cast<std::uint64_t>(i) + 40000),
               c = i % 2 == 0 ? made : pushed(random, made);
    const double margin = anyMargin(random, c);
    const Touching touching = i % 3 == 0 ? Touching::Allowed : Touching::Collides;
    const bool truth = areWithin(c, margin, touching);
    hits += truth;
    const std::string wrong = brokenLaw(c, margin, touching, truth, random, old);
    if (!wrong.empty() && ++broken <= 3)
      ADD_FAILURE() << GetParam().name << " seed " << i << ": " << wrong << "\n" << reproduction(c);
  }
  std::printf("%-22s %4d cases %4d hits %4d broken\n", GetParam().name, cases, hits, broken);
  EXPECT_EQ(broken, 0);
  if (cases < 20) return;
  EXPECT_GE(hits, cases / 4);
  EXPECT_LT(hits, cases);
}

INSTANTIATE_TEST_SUITE_P(Families, Laws, testing::ValuesIn(allFamilies()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace tricover::support
