// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "workloads.h"

namespace tricover::bench {

using Countries = std::vector<workloads::NamedPolygon>;

/// Reads workloads::readPolygons' format, leaving out what spans the map: those outlines cross the antimeridian or go
/// around the pole, so that in the plane they are a stripe from edge to edge.
Countries readCountries(std::istream& in);

/// The country whose name ends with "_<name>". Throws std::invalid_argument if there is none.
std::size_t findCountry(const Countries& countries, const std::string& name);

/// The polygon with its origin() shifted to (0, 0), as one authors a shape that is to turn.
Polygon centred(const Polygon& polygon);

}  // namespace tricover::bench
