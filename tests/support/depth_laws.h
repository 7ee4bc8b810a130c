// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "exact_depth.h"
#include "families.h"
#include "random.h"
#include "tricover/depth.h"

/// What depth(), excess(), hausdorffDistance() and negative margins promise: empty if nothing is wrong.
namespace tricover::support {

/// What depth.h and signed_distance.h say depths are precise to.
double depthPrecision(const Case& c);

/// Both regions moved together until their origins are up to the smaller one's size apart, half of the time.
Case pushedTogether(Random& random, Case c);

/// The numbers of a depth: 0 exactly where no region reaches into the other one, points of the regions that far apart
/// on the edges that are named, a deepest point that is as deep, the same of swapped operands.
std::string wrongDepth(const Case& c, const Depth& found);
/// Whether it is the largest one, by the oracle's bracket.
std::string wrongLargest(const Case& c, double found, const exact::Bracket& truth);
/// What it is at most: the depth of penetration(), and the depth of b elsewhere plus the way there; and what it is of
/// regions whose complements are known, by excess().
std::string wrongBesideOthers(Random& random, const Case& c, const Depth& found);

/// Of a as a part, and b as an area.
std::string wrongExcess(const Case& c, const Excess& found);
/// The largest of all edges' is at most the part's; a way by way of a third region is no shorter; Hausdorff distances.
std::string wrongBesideOthers(Random& random, const Case& c, const Excess& found);

/// covers() with a margin of -e says whether excess() is at most e.
std::string wrongCoversButFor(const Case& c, const Excess& found);

/// collide() with any margin says whether signedDistance() is at most that, or below it where touching is allowed: so
/// its answers are monotone in the margin.
std::string wrongMargins(Random& random, const Case& c);

}  // namespace tricover::support
