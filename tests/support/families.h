// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "random.h"
#include "tricover/motion.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover::support {

struct Case {
  Polygon a;
  Pose pose_a;
  Polygon b;
  Pose pose_b;
};

struct MovingCase {
  Polygon a;
  Motion motion_a;
  Polygon b;
  Motion motion_b;
  double margin = 0;
};

/// What time_of_impact.h calls L, of one of the two.
double lengthOf(const Polygon& polygon, const Motion& motion);
/// Of both: coming within 1e-13 of it may count as a contact.
double lengthOf(const MovingCase& c);

/// a: three quarters of a plane, cut off somewhere, around its corner at the origin; b: some cells of a grid near
/// there, smaller than a by up to 1e11. Many edges lie on one line, but for rounding.
Case tinyInCorner(Random& random);

/// The same region twice, at one place: there no direction from a to b is better than its opposite.
bool isOneTwice(const Case& c);

/// b near where it is: certificates about these poses are about to be used at the case's own.
Pose elsewhere(Random& random, const Case& c);

/// Moves b along `away` from a's place: between a distance at which the polygons meet, or 0, and one at which they
/// don't, or `far`, after so many halvings.
struct ContactOnWay {
  double near, far;
};
ContactOnWay contactOnWay(Case c, const Vec2& away, double far, int halvings);

/// One way in which a pair can be degenerate; the same seed always makes the same case, and both outcomes are common.
struct Family {
  const char* name;
  std::function<Case(std::uint64_t seed)> make;
};

const std::vector<Family>& families();

/// And "large_outlines", of up to some hundred vertices, whose trees are several blocks deep: too slow for every
/// law.
std::vector<Family> familiesOfAllSizes();

}  // namespace tricover::support
