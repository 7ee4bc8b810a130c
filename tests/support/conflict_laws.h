// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "families.h"
#include "random.h"
#include "tricover/trajectory.h"

/// What conflicts() promises, beside what a reference says at many times on the way. The poses there are computed in
/// long doubles: with a reference on exact numbers nothing is shared with the kernel but the types.
namespace tricover::support {

struct Flight {
  Polygon a;
  Trajectory way_a;
  Polygon b;
  Trajectory way_b;
  double margin = 0;
};

/// Legs and waits within some units of the origin, for about a unit of time.
Trajectory anyPlan(Random& random);

struct ConflictCounts {
  int cases = 0, none = 0, one = 0, more = 0, at_begin = 0, until_end = 0, unseen = 0, spans = 0;
};

/// Whether the polygons are no farther apart than the margin.
using Meet = bool (*)(const Case& c, double margin);
bool meetExactly(const Case& c, double margin);

/// What is wrong with the spans of conflict, or with what they are without those at the start; empty if nothing is.
/// Sizes and speeds are to be between 1e-3 and 1e3.
std::string wrongConflicts(const Flight& f, double error, Meet meet, ConflictCounts& counts);

}  // namespace tricover::support
