// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "io/input.h"
#include "tricover/geojson.h"

namespace tricover::detail {

/// A shell and its holes.
using Part = std::vector<Ring>;

/// Throws std::invalid_argument for an origin that is not finite.
void requireOrigin(const GeoOptions& options);

/// The polygon of a file's parts, at least one, whose rings are closed as in the file. Throws std::runtime_error with
/// `name`, part, ring and vertex.
GeoFeature featureOf(std::vector<Part> parts, const GeoOptions& options, const std::string& name);

/// The parts of a polygon: shells counter-clockwise, holes clockwise, not closed. Throws std::invalid_argument with
/// `name` for what no valid parts are. `format` has no words for it.
std::vector<Part> partsOf(const Polygon& polygon, const std::string& name, const std::string& format);

/// Appends a number that is read as the same double; with a point or an exponent where it might lose its sign.
void appendNumber(std::string& text, double number);

}  // namespace tricover::detail
