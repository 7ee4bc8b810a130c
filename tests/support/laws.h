// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "families.h"
#include "random.h"
#include "tricover/pair_cache.h"
#include "tricover/touching.h"

/// The table of laws that hold of all queries (queries.h).
namespace tricover::support {

/// By exact rationals.
bool areWithin(const Case& c, double margin, Touching touching);

/// The first law that some query breaks, empty if none does. `truth` is areWithin(); `old` is a cache that has seen
/// other pairs.
std::string brokenLaw(const Case& c, double margin, Touching touching, bool truth, Random& random, PairCache& old);

}  // namespace tricover::support
