// SPDX-License-Identifier: BSD-3-Clause
#include "geos_region.h"

#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>
#include <geos/operation/valid/MakeValid.h>

#include <utility>

namespace tricover::bench {
namespace {

std::unique_ptr<geos::geom::LinearRing> closedRing(const Ring& ring) {
  std::vector<geos::geom::Coordinate> coordinates;
  for (const Vec2& v : ring) coordinates.emplace_back(v.x(), v.y());
  coordinates.push_back(coordinates.front());
  return geos::geom::GeometryFactory::getDefaultInstance()->createLinearRing(
      std::make_unique<geos::geom::CoordinateArraySequence>(std::move(coordinates)));
}

Ring vertices(const geos::geom::LinearRing& ring) {
  Ring result;
  for (std::size_t i = 0; i + 1 < ring.getNumPoints(); ++i) {
    const geos::geom::Coordinate& c = ring.getCoordinateN(i);
    result.emplace_back(c.x, c.y);
  }
  return result;
}

}  // namespace

/// Rings as shell and holes where that is valid, else the even-odd region: the symmetric difference of all rings.
std::unique_ptr<geos::geom::Geometry> geosRegion(const Polygon& polygon) {
  const auto& factory = *geos::geom::GeometryFactory::getDefaultInstance();
  const std::vector<Ring>& rings = polygon.rings();
  std::vector<std::unique_ptr<geos::geom::LinearRing>> holes;
  for (std::size_t i = 1; i < rings.size(); ++i) holes.push_back(closedRing(rings[i]));
  std::unique_ptr<geos::geom::Geometry> region = factory.createPolygon(closedRing(rings[0]), std::move(holes));
  if (region->isValid()) return region;
  region.reset();
  for (const Ring& ring : rings) {
    auto part = geos::operation::valid::MakeValid().build(factory.createPolygon(closedRing(ring)).get());
    region = region ? region->symDifference(part.get()) : std::move(part);
  }
  return region;
}

std::vector<Ring> ringsOfPart(const geos::geom::Geometry& region, std::size_t part) {
  const auto& polygon = dynamic_cast<const geos::geom::Polygon&>(*region.getGeometryN(part));
  std::vector<Ring> rings = {vertices(*polygon.getExteriorRing())};
  for (std::size_t i = 0; i < polygon.getNumInteriorRing(); ++i)
    rings.push_back(vertices(*polygon.getInteriorRingN(i)));
  return rings;
}

}  // namespace tricover::bench
