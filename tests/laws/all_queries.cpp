// SPDX-License-Identifier: BSD-3-Clause
// The laws that hold of all queries, laws.h, of every family, with margins and where touching is allowed.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "families.h"
#include "law.h"
#include "laws.h"
#include "pairs.h"
#include "shapes.h"
#include "touching_families.h"

namespace tricover::laws {
namespace {

using namespace support;

Pose anyPoseOfB(Random& random) {
  const double apart = random.real(0, 3);
  return turnedAndMoved(random.coin() ? random.real(-3, 3) : 0, apart, random.coin() ? std::round(2 * apart) / 4 : 0);
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

Case closedRings(Random& random) {
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
Case twins(Random& random) {
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
  return {Polygon({ring}), turnedAndMoved(random.real(0, 6.3), 0.1, 0.7), Polygon({other}), anyPoseOfB(random)};
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  c = pushed(random, c);
  const double margin = anyMargin(random, c);
  const Touching touching = random.oneIn(3) ? Touching::Allowed : Touching::Collides;
  const bool truth = areWithin(c, margin, touching);
  tally.count("hits", truth);
  PairCache old = cachesOfOthers(random).of_pair;
  return brokenLaw(c, margin, touching, truth, random, old);
}

Laws allQueriesLaws() {
  Limits limits;
  limits.most_vertices = 12;
  Laws laws;
  add(laws, {family("closed_rings", closedRings), family("twins", twins)}, 400, wrong, {{"hits", 0.25, 0.99}});
  add(laws, joined(familiesOfAllSizes(), touchingFamilies()), 40, wrong, {{"hits", 0.25, 0.99}});
  add(laws, anyPairs(limits), 20, wrong, {{"hits", 0.1, 0.99}});
  return laws;
}

const Register registered("all_queries", allQueriesLaws);

}  // namespace
}  // namespace tricover::laws
