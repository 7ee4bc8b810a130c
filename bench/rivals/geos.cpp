// SPDX-License-Identifier: BSD-3-Clause
#include "geos.h"

#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>
#include <geos/geom/prep/PreparedGeometryFactory.h>
#include <geos/operation/valid/MakeValid.h>

#include <utility>

namespace tricover::bench {
namespace {

using geos::geom::prep::PreparedGeometryFactory;

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

GeosMoved::GeosMoved(const Polygon& polygon) : geometry_(geosRegion(polygon)) {
  for (std::size_t part = 0; part < geometry_->getNumGeometries(); ++part)
    for (Ring& ring : ringsOfPart(*geometry_, part)) {
      ring.push_back(ring.front());
      rings_.push_back(std::move(ring));
    }
}

void GeosMoved::filter_rw(geos::geom::CoordinateSequence& sequence, std::size_t i) {
  if (i != 0) return;
  const Ring& ring = rings_[next_++];
  const Eigen::Matrix2d linear = pose_->linear();
  const Vec2 translation = pose_->translation();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 v = linear * ring[k] + translation;
    sequence.setAt(geos::geom::Coordinate(v.x(), v.y()), k);
  }
}

Geos::Geos(const Polygon& fixed, const Polygon& moving, bool by_facets)
    : by_facets_(by_facets),
      fixed_is_prepared_(fixed.vertexCount() >= moving.vertexCount()),
      still_(geosRegion(fixed_is_prepared_ ? fixed : moving)),
      moved_(fixed_is_prepared_ ? moving : fixed),
      prepared_(PreparedGeometryFactory::prepare(still_.get())) {
  // Builds its indexes, which it puts off to the first query that needs them.
  prepared_->intersects(moved_.at(Pose::Identity()));
}

void Geos::prepare(const std::vector<Pose>& poses) {
  poses_ = poses;
  if (fixed_is_prepared_) return;
  for (Pose& pose : poses_) pose = pose.inverse(Eigen::Isometry);
}

GeosTree::GeosTree(const Placement& placement, const Polygon& moving) : tree_(10, placement.size()), moved_(moving) {
  for (const Placed& placed : placement) {
    still_.push_back(geosRegion(posed(placed.polygon, placed.pose)));
    prepared_.push_back(PreparedGeometryFactory::prepare(still_.back().get()));
    tree_.insert(*still_.back()->getEnvelopeInternal(), prepared_.back().get());
    prepared_.back()->intersects(moved_.at(placed.pose));  // as above
  }
}

bool GeosTree::collide(std::size_t i) {
  const geos::geom::Geometry* moved = moved_.at(poses_[i]);
  bool hit = false;
  tree_.query(*moved->getEnvelopeInternal(), [&](const Prepared* prepared) {
    hit = prepared->intersects(moved);
    return !hit;
  });
  return hit;
}

}  // namespace tricover::bench
