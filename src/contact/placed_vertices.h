// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/region_sides.h"
#include "numbers/rounding.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

struct PlacedVertex {
  Vec2 at;
  Vec2 incoming, outgoing;  ///< edges at it, beyond its repetitions
  bool is_edge;             ///< not a repetition of the next one
  bool is_reflex;           ///< certainly, seen from its region
  std::int8_t side;         ///< of the outgoing edge on which the region is: 1: left, -1: right, 0: nobody knows
};

/// A way of a polygon's frame in the world, in units. Of the points in units, as their difference may overflow.
template <typename Linear>
Vec2 turnedInUnits(const Linear& linear, double inverse_unit, const Vec2& p, const Vec2& from) {
  return linear * (p * inverse_unit - from * inverse_unit);
}

/// A polygon's vertices by position, each placed when it is asked for first: overlaps that are shallow need few.
class PlacedVertices {
 public:
  PlacedVertices() = default;
  /// origin: where the polygon's S is. sides: null if they are not needed.
  PlacedVertices(const PolygonData& polygon, const Pose& pose, const Vec2& origin, double inverse_unit,
                 const RegionSides* sides)
      : polygon_(&polygon),
        linear_(pose.linear()),
        origin_(origin),
        inverse_unit_(inverse_unit),
        sides_(sides),
        is_placed_(polygon.path.size()),
        vertices_(new PlacedVertex[polygon.path.size()]) {}

  std::size_t size() const { return is_placed_.size(); }
  const PlacedVertex& operator[](std::size_t i) const {
    if (!is_placed_[i]) place(i);
    return vertices_[i];
  }

 private:
  bool isEdge(std::size_t i) const { return polygon_->path[i] != polygon_->path[i + 1]; }
  Vec2 edge(std::size_t i) const { return inUnits(polygon_->path[i + 1], polygon_->path[i]); }
  Vec2 inUnits(const Vec2& p, const Vec2& from) const { return turnedInUnits(linear_, inverse_unit_, p, from); }
  void place(std::size_t i) const;

  const PolygonData* polygon_ = nullptr;
  Eigen::Matrix2d linear_;
  Vec2 origin_;
  double inverse_unit_ = 0;
  const RegionSides* sides_ = nullptr;
  mutable std::vector<std::uint8_t> is_placed_;
  std::unique_ptr<PlacedVertex[]> vertices_;
};

}  // namespace tricover::detail
