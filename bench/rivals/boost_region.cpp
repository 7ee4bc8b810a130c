// SPDX-License-Identifier: BSD-3-Clause
#include "boost_region.h"

#include "geos_region.h"

namespace tricover::bench {
namespace {

using BoostRing = BoostPolygon::ring_type;

BoostRing boostRing(const Ring& ring) {
  BoostRing result;
  for (const Vec2& v : ring) result.emplace_back(v.x(), v.y());
  result.push_back(result.front());
  return result;
}

void transform(const BoostRing& from, const Pose& pose, BoostRing& to) {
  const Eigen::Matrix2d linear = pose.linear();
  const Vec2 translation = pose.translation();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec2 v = linear * Vec2(from[i].x(), from[i].y()) + translation;
    to[i] = BoostPoint(v.x(), v.y());
  }
}

}  // namespace

BoostRegion boostRegion(const Polygon& polygon) {
  const auto region = geosRegion(polygon);
  BoostRegion result;
  result.resize(region->getNumGeometries());
  for (std::size_t part = 0; part < result.size(); ++part) {
    const std::vector<Ring> rings = ringsOfPart(*region, part);
    result[part].outer() = boostRing(rings[0]);
    for (std::size_t i = 1; i < rings.size(); ++i) result[part].inners().push_back(boostRing(rings[i]));
  }
  boost::geometry::correct(result);
  return result;
}

const BoostRegion& BoostMoved::at(const Pose& pose) {
  for (std::size_t part = 0; part < moved_.size(); ++part) {
    const BoostPolygon& original = original_[part];
    BoostPolygon& moved = moved_[part];
    transform(original.outer(), pose, moved.outer());
    for (std::size_t k = 0; k < original.inners().size(); ++k) {
      transform(original.inners()[k], pose, moved.inners()[k]);
    }
  }
  return moved_;
}

}  // namespace tricover::bench
