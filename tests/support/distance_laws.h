// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <string>

#include "families.h"
#include "tricover/distance.h"

/// What distance() promises, on exact numbers.
namespace tricover::support {

/// Whether `distance` is the root of `squared` but for a factor within 1e-14 of 1 and the smallest double.
bool isRootOf(double distance, const mpq_class& squared);

/// What is wrong with the points; empty if nothing is. Says nothing where coordinates overflow.
std::string wrongPoints(const Case& c, const DistanceResult& r);

/// To the last bit, but for points that overflow.
bool same(const DistanceResult& p, const DistanceResult& q);
DistanceResult swapped(const DistanceResult& r);

}  // namespace tricover::support
