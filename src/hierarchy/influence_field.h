// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// A field of influence lengths: a grid over a polygon's bounding box, in units from S. Each cell knows how far the
/// outline is at least from all of its points, how far at most, and on which side of it they are. So it is the paper's
/// influence area, kept for all places instead of for one edge.
class InfluenceField : public Derived::Thing {
 public:
  /// Of a polygon that fitsUnit() and isn't degenerate. O(cells), which are kCellsOfEdge an edge, kMostCells at most.
  explicit InfluenceField(const PolygonData& polygon);

  /// What is known of a place.
  struct Look {
    double free;  ///< no edge is nearer
    double near;  ///< some edge is no farther
    bool inside;  ///< whether the place is in the region; certain where `free` is more than the place's error
  };
  Look at(double x, double y) const {
    const double column = (x - low_x_) * inverse_side_, row = (y - low_y_) * inverse_side_;
    if (!(column >= 0 && row >= 0 && column < columns_ && row < rows_)) return beyond(column, row);
    const unsigned cell = cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                 static_cast<std::size_t>(column)];
    const unsigned steps = cell & kSteps;
    return {kStep * side_ * (steps > 0 ? steps - 1 : 0), steps < kSteps ? kFar * side_ + kStep * side_ * steps : kNone,
            cell > kInside};
  }

  std::size_t cellCount() const { return cells_.size(); }
  double side() const { return side_; }

  /// Where no edge is known.
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  static constexpr std::size_t kCellsOfEdge = 32, kMostCells = std::size_t{1} << 20;

 private:
  // A cell: whether it is inside, and 0 where the outline touches it; otherwise 1 + the number of half sides that the
  // outline is away from it at least.
  static constexpr unsigned kInside = 128, kSteps = 127;
  /// Half a side, less what places and vertices are rounded by: up to 2^-30 sides in 2^20.
  static constexpr double kStep = 0.5 * (1 - 0x1p-20);
  /// In sides: from any point of a cell to any point of the touched one that is nearest to it, beyond the steps between
  /// their middles. That one is next to a marked one: 2 diagonals, and the same rounding.
  static constexpr double kFar = 2 * 1.4142135623730951 + 0x1p-10;

  Look beyond(double column, double row) const;

  double low_x_, low_y_, side_, inverse_side_;
  double columns_, rows_;
  bool is_complement_;
  std::vector<std::uint8_t> cells_;
};

/// For a query that the field may answer: builds it once such queries have paid for it, until then null. Of few edges,
/// which are tested at once, and of the largest of polygons there is none.
[[gnu::cold]] const InfluenceField* payForField(const PolygonData& polygon);
inline const InfluenceField* fieldIfPaid(const PolygonData& polygon) {
  constexpr std::size_t kFewest = 64;
  if (polygon.path.size() < kFewest || !polygon.fitsUnit()) return nullptr;
  const auto* ready = static_cast<const InfluenceField*>(topOf(polygon).field.ifBuilt());
  return ready != nullptr ? ready : payForField(polygon);
}

}  // namespace tricover::detail
