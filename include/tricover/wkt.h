// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tricover/export.h"
#include "tricover/geojson.h"
#include "tricover/polygon.h"

namespace tricover {

/// Reads a POLYGON or a MULTIPOLYGON in WKT (well-known text, OGC Simple Features): one of them, and nothing after it.
/// Link tricover::io.
///
/// Parts, rings and options mean what they mean in readGeoJson(). Case and white space don't matter. `Z`, `M` and `ZM`
/// are accepted, and so are up to four coordinates without them; what is beyond x and y is dropped. `SRID=4326;` in
/// front (EWKT) is skipped, for nothing is projected. Doubles are read exactly, whatever the locale is.
///
/// \return A feature without id and properties.
/// \throws std::runtime_error for a text that isn't such WKT, for EMPTY, and for parts that readGeoJson() refuses. The
/// text has the line, the part, the ring and the vertex.
/// \throws std::invalid_argument for an origin that is not finite
///
/// \snippet wkt.cpp wkt
TRICOVER_EXPORT GeoFeature parseWkt(const std::string& text, const GeoOptions& options = {});

/// Returns a polygon in WKT: a POLYGON if it has one shell, otherwise a MULTIPOLYGON. Rings are written as toGeoJson()
/// writes them. Doubles are written such that they are read bit for bit.
///
/// \throws std::invalid_argument as toGeoJson() does
///
/// \snippet wkt.cpp wkt
TRICOVER_EXPORT std::string toWkt(const Polygon& polygon);

}  // namespace tricover
