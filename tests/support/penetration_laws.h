// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "families.h"
#include "random.h"
#include "tricover/penetration.h"

/// What penetration() promises, on exact numbers.
namespace tricover::support {

/// How precise penetration.h says a result is.
double precisionOf(const Case& c, double margin = 0);

/// What is wrong with the answer with a margin; empty if nothing is. Whether shorter translations part the regions is
/// tried in so many directions.
std::string wrongPenetration(Random& random, const Case& c, double margin, const std::optional<Penetration>& found,
                             int directions);

/// The depth of two convex polygons is right to 1e-14 of itself, or of 1e-14 of the coordinates.
std::string wrongConvexDepth(const Case& c, double depth);

/// What differs of the answer from swapped operands; empty if nothing does, or they are one region at one place.
std::string wrongSwapped(const Case& c, const Penetration& found);

}  // namespace tricover::support
