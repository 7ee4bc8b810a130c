// SPDX-License-Identifier: BSD-3-Clause
#include "boost_geometry.h"

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry's own: no messages about them
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "geos_region.h"

namespace tricover::bench {
namespace {

using Point = boost::geometry::model::d2::point_xy<double>;
using BoostPolygon = boost::geometry::model::polygon<Point>;
using BoostRing = BoostPolygon::ring_type;
using BoostRegion = boost::geometry::model::multi_polygon<BoostPolygon>;

BoostRing boostRing(const Ring& ring) {
  BoostRing result;
  for (const Vec2& v : ring) result.emplace_back(v.x(), v.y());
  result.push_back(result.front());
  return result;
}

BoostRegion boostRegion(const Polygon& polygon) {
  const auto region = geosRegion(polygon);
  BoostRegion result;
  result.resize(region->getNumGeometries());
  for (std::size_t part = 0; part < result.size(); ++part) {
    const std::vector<Ring> rings = ringsOfPart(*region, part);
    result[part].outer() = boostRing(rings[0]);
    for (std::size_t i = 1; i < rings.size(); ++i) result[part].inners().push_back(boostRing(rings[i]));
  }
  boost::geometry::correct(result);  // turns rings the way Boost wants them
  return result;
}

void transform(const BoostRing& from, const Pose& pose, BoostRing& to) {
  const Eigen::Matrix2d linear = pose.linear();
  const Vec2 translation = pose.translation();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec2 v = linear * Vec2(from[i].x(), from[i].y()) + translation;
    to[i] = Point(v.x(), v.y());
  }
}

}  // namespace

struct BoostGeometry::Shapes {
  Shapes(const Polygon& still_polygon, const Polygon& moving_polygon)
      : still(boostRegion(still_polygon)), original(boostRegion(moving_polygon)), moved(original) {}

  BoostRegion still, original, moved;
};

BoostGeometry::BoostGeometry(const Polygon& fixed, const Polygon& moving)
    : fixed_is_still_(fixed.vertexCount() >= moving.vertexCount()),
      shapes_(fixed_is_still_ ? std::make_unique<Shapes>(fixed, moving) : std::make_unique<Shapes>(moving, fixed)) {}

BoostGeometry::~BoostGeometry() = default;

void BoostGeometry::prepare(const std::vector<Pose>& poses) {
  poses_ = poses;
  if (fixed_is_still_) return;
  for (Pose& pose : poses_) pose = pose.inverse(Eigen::Isometry);
}

void BoostGeometry::move(std::size_t i) {
  for (std::size_t part = 0; part < shapes_->moved.size(); ++part) {
    const BoostPolygon& original = shapes_->original[part];
    BoostPolygon& moved = shapes_->moved[part];
    transform(original.outer(), poses_[i], moved.outer());
    for (std::size_t k = 0; k < original.inners().size(); ++k) {
      transform(original.inners()[k], poses_[i], moved.inners()[k]);
    }
  }
}

bool BoostGeometry::collide(std::size_t i) {
  move(i);
  const Shapes& shapes = *shapes_;
  return shapes.still.size() == 1 && shapes.moved.size() == 1
             ? boost::geometry::intersects(shapes.still[0], shapes.moved[0])
             : boost::geometry::intersects(shapes.still, shapes.moved);
}

double BoostGeometry::value(std::size_t i) {
  move(i);
  const Shapes& shapes = *shapes_;
  return shapes.still.size() == 1 && shapes.moved.size() == 1
             ? boost::geometry::distance(shapes.still[0], shapes.moved[0])
             : boost::geometry::distance(shapes.still, shapes.moved);
}

}  // namespace tricover::bench
