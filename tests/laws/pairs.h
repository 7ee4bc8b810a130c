// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "families.h"
#include "random.h"
#include "strategies.h"

/// Pairs of every kind: shapes from points to soups, sizes from 1e-300 to 1e300, contacts to the ulp and gaps beyond.
namespace tricover::laws {

using support::Case;
using support::Family;
using support::Random;

/// What a query can't do with: sizes whose squares overflow, say.
struct Limits {
  int most_exponent = 300;  ///< of a size, base 10
  int most_vertices = 40;
  bool convex = false;  ///< only
};

/// One for each kind of shape, which either polygon has; the other one has any.
std::vector<Family> anyPairs(const Limits& limits = {});
/// Of any of these.
Case anyCase(Random& random, const Limits& limits = {});

/// Of one of the kinds, of a size of about 1, around the origin.
Polygon anyShape(Random& random, const Limits& limits = {});

double smallerRadius(const Case& c);

/// The next step of a walk: by an ulp or a jump, turning or not, either of them or both.
void step(Random& random, Case& c);

/// A small polygon that holds some of a map's many rings, meets some, or lies among them.
Case smallAmongManyRings(Random& random);

/// b so near to a's S, half of the time, that they are deep in each other, where they would touch at most.
Case pushed(Random& random, Case c);

/// As long as the distance but for an ulp, about as long, any length up to the larger size, or 0: below 1e150.
double anyMargin(Random& random, const Case& c);

/// Both on the way, or at rest: at some times they are where the case has them.
support::MovingCase anyFlight(Random& random, const Case& c);

/// Caches that have seen another pair.
support::StrategyCaches cachesOfOthers(Random& random);

/// A family of these.
std::vector<Family> joined(std::vector<Family> families, const std::vector<Family>& more);

}  // namespace tricover::laws
