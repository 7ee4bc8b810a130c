// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// How GeoJSON and WKT are read.
struct GeoOptions {
  /// Subtracted from each coordinate: a place near the data, so that coordinates are small. Finite.
  Vec2 origin = Vec2::Zero();
  /// Whether to leave out geometries that have no area (points, lines, `null`, and what has no coordinates), and
  /// features that are left with no geometry. Otherwise these are errors.
  bool skip_others = false;
};

/// A polygon of a file, with its properties.
///
/// The region is the union of the file's parts, each of which is its shell without its holes. It is closed, so that the
/// borders of holes belong to it.
struct GeoFeature {
  /// All rings of all parts, without the vertex that closes each of them in the file. FillRule::EvenOdd if no two parts
  /// overlap. Otherwise FillRule::NonZero, with shells counter-clockwise and holes clockwise.
  Polygon polygon;
  std::string id = {};          ///< The feature's id as JSON: `17`, or `"dock"` with its quotes. Empty: none.
  std::string properties = {};  ///< The feature's properties as JSON: `{"speed":2.5}`. Empty: none.
  /// How many points were added to parts that overlap: where their edges cross at no vertex, both edges get the
  /// crossing as a vertex, rounded, so that complement() takes the polygon. All vertices of the file stay as they are.
  std::size_t rounded_crossings = 0;
  /// How many coordinates changed by rounding when the origin was subtracted. 0: all differences are exact.
  std::size_t rounded_coordinates = 0;
};

/// Reads a GeoJSON file (RFC 7946). Link tricover::io, which needs nlohmann-json to be built.
///
/// Reads Polygon, MultiPolygon, and GeometryCollection of these, alone, in a Feature or in a FeatureCollection; each
/// becomes one feature. Coordinates beyond x and y are dropped. Nothing is projected, and `crs` and `bbox` are ignored.
///
/// A ring needs at least four positions, and the last one equals the first one. A shell may cross itself: what lies
/// inside by the even-odd rule is the region, and selfCrossings() shows where. Holes must be inside of their shell, and
/// may touch but not overlap each other. A part that crosses itself must not overlap another part.
///
/// Doubles are read exactly, whatever the locale is. The text is UTF-8; a byte order mark is skipped. Arrays and
/// objects nest at most 64 deep, and parts that overlap cross at 2^20 places at most. Memory is bounded by a small
/// multiple of the file's size and these crossings.
///
/// Folders, devices and pipes are refused.
/// \return The features in the file's order.
/// \throws std::runtime_error for a file that can't be read, isn't GeoJSON, or has a geometry that is none of these.
/// The text has the file, the line or the feature with its id, the ring and the vertex.
/// \throws std::invalid_argument for an origin that is not finite
///
/// \snippet geojson.cpp read
TRICOVER_EXPORT std::vector<GeoFeature> readGeoJson(const std::string& path, const GeoOptions& options = {});

/// Reads GeoJSON from a text, as readGeoJson() does from a file.
/// \throws std::runtime_error as readGeoJson() does
/// \throws std::invalid_argument for an origin that is not finite
///
/// \snippet geojson.cpp text
TRICOVER_EXPORT std::vector<GeoFeature> parseGeoJson(const std::string& text, const GeoOptions& options = {});

/// Returns a polygon as a GeoJSON geometry: a Polygon if it has one shell, otherwise a MultiPolygon. Shells are
/// counter-clockwise and holes clockwise, each closed. Doubles are written such that they are read bit for bit.
///
/// Rings under FillRule::NonZero that have the region on both sides are left out. No other vertex is.
///
/// \throws std::invalid_argument for a complement(), and where selfCrossings() finds anything but HoleOutside. GeoJSON
/// has no words for these. The text says where, and what to do: complement() of a complement() leaves the border alone.
///
/// \snippet geojson.cpp text
TRICOVER_EXPORT std::string toGeoJson(const Polygon& polygon);
/// Returns features as a FeatureCollection, one a line. The counts of what was rounded are not written.
/// \throws std::invalid_argument as for a polygon, and for an id that is no JSON string or number, and for properties
/// that are no JSON object or `null`. The text has the feature's number.
///
/// \snippet geojson.cpp text
TRICOVER_EXPORT std::string toGeoJson(const std::vector<GeoFeature>& features);

/// Writes toGeoJson() of features into a file, which it replaces. Nothing is written if a feature is refused.
/// \throws std::invalid_argument as toGeoJson() does
/// \throws std::runtime_error if the file can't be written. The text has the file.
///
/// \snippet geojson.cpp read
TRICOVER_EXPORT void writeGeoJson(const std::string& path, const std::vector<GeoFeature>& features);

}  // namespace tricover
