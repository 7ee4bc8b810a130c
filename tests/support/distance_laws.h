// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <string>

#include "families.h"
#include "limited_distance.h"

/// What distance() promises, on exact numbers.
namespace tricover::support {

/// Whether `distance` is the root of `squared` but for a factor within 1e-14 of 1 and the smallest double.
bool isRootOf(double distance, const mpq_class& squared);

/// What is wrong with the points; empty if nothing is. Says nothing where coordinates overflow.
std::string wrongPoints(const Case& c, const DistanceResult& r);

/// What is wrong with a distance that was asked for with these options; empty if nothing is. `squared` is the exact
/// distance's of the regions, a margin aside.
std::string wrongDistance(double found, const LimitedOptions& options, const mpq_class& squared);

/// The same of distance() and distanceWithin() in both orders and with a cache. Without errors the cache changes no
/// bit.
std::string wrongDistances(const Case& c, const LimitedOptions& options, const mpq_class& squared, PairCache& cache);

/// What is wrong with signedDistance() with this margin, beside distance(), depth() and collide(); empty if nothing
/// is.
std::string wrongSignedDistance(const Case& c, double margin);

/// To the last bit, but for points that overflow.
bool same(const DistanceResult& p, const DistanceResult& q);
DistanceResult swapped(const DistanceResult& r);

}  // namespace tricover::support
