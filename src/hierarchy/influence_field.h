// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
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
  /// The polygon fitsUnit() and isn't degenerate. O(cells), which are kCellsOfEdge an edge, kMostCells at most.
  explicit InfluenceField(const PolygonData& polygon);

  /// A place beside the outline.
  struct Look {
    double free;  ///< no edge is nearer
    double near;  ///< some edge is no farther
    bool inside;  ///< whether the place is in the region; certain where `free` is more than the place's error
  };
  Look at(double x, double y) const {
    const double column = (x - low_.x()) * inverse_side_, row = (y - low_.y()) * inverse_side_;
    if (!(column >= 0 && row >= 0 && column < columns_ && row < rows_)) return beyond(column, row);
    const unsigned cell =
        cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
    const unsigned steps = cell & kSteps;
    return {kStep * side_ * (steps > 0 ? steps - 1 : 0), steps < kSteps ? kFar * side_ + kStep * side_ * steps : kNone,
            cell > kInside};
  }

  /// Calls visit(edge) for each edge, by its position, that may come within a box of half such a width and height,
  /// until that returns false. Some more than once.
  template <typename Visit>
  void forEachEdge(const Vec2& middle, const Vec2& half, Visit visit) const {
    const Vec2 at = (middle - low_) * inverse_side_, reach = half * inverse_side_;
    const std::size_t first = tileOf(at.x() - reach.x(), columns_), last = tileOf(at.x() + reach.x(), columns_);
    const std::size_t end = tileOf(at.y() + reach.y(), rows_);
    for (std::size_t row = tileOf(at.y() - reach.y(), rows_); row <= end; ++row) {
      const std::uint32_t row_end = tile_begins_[row * tile_columns_ + last + 1];
      for (std::uint32_t k = tile_begins_[row * tile_columns_ + first]; k < row_end; ++k)
        if (!visit(tile_edges_[k])) return;
    }
  }
  /// How many rows a box of half such a height has.
  double rowsOf(double half) const { return 2 * half * inverse_side_; }

  std::size_t bytes() const {
    return cells_.size() + tile_edges_.size() * sizeof(EdgePosition) + tile_begins_.size() * sizeof(std::uint32_t);
  }
  double side() const { return side_; }

  /// Where no edge is known.
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  static constexpr std::size_t kCellsOfEdge = 16, kMostCells = std::size_t{1} << 22;

 private:
  // A cell: whether it is inside, and 0 where the outline touches it; otherwise 1 + the number of half sides that the
  // outline is away from it at least.
  static constexpr unsigned kInside = 128, kSteps = 127;
  /// Half a side, less what places and vertices are rounded by: up to 2^-30 sides in 2^20.
  static constexpr double kStep = 0.5 * (1 - 0x1p-20);
  /// In sides: from any point of a cell to any point of the touched one that is nearest to it, beyond the steps between
  /// their middles. That one is next to a marked one: 2 diagonals, and the same rounding.
  static constexpr double kFar = 2 * 1.4142135623730951 + 0x1p-10;

  /// A tile is so many cells wide and high, and has the edges that touch it.
  static constexpr int kTile = 4;

  Look beyond(double column, double row) const;
  static std::size_t tileOf(double at, double cells) {
    return static_cast<std::size_t>(std::clamp(at, 0.0, cells - 1)) / kTile;
  }
  void addEdges(const PolygonData& polygon);

  Vec2 low_;
  double side_, inverse_side_;
  double columns_, rows_;
  bool is_complement_;
  std::vector<std::uint8_t> cells_;
  std::size_t tile_columns_;
  std::vector<std::uint32_t> tile_begins_;  ///< of each tile's edges, and the end
  std::vector<EdgePosition> tile_edges_;
};

/// Of few edges, which are tested at once, of degenerate polygons and of the largest there is no field.
inline bool hasField(const PolygonData& polygon) {
  constexpr std::size_t kFewest = 64;
  return polygon.path.size() >= kFewest && polygon.fitsUnit() && !polygon.isDegenerate();
}

/// Built at the first call, of a polygon that has one.
const InfluenceField& fieldOf(const PolygonData& polygon);

/// The field if it has been built, otherwise null.
inline const InfluenceField* fieldIfBuilt(const PolygonData& polygon) {
  const Hierarchy* top = topIfBuilt(polygon);
  if (top == nullptr) return nullptr;
  return static_cast<const InfluenceField*>(top->field.ifBuilt());
}

/// For a query that the field may answer, and that costs so much without it: builds it once such queries have paid.
[[gnu::cold]] void payForField(const PolygonData& polygon, std::size_t cost);
inline const InfluenceField* fieldIfPaid(const PolygonData& polygon, std::size_t cost) {
  if (!hasField(polygon)) return nullptr;
  if (topOf(polygon).field.ifBuilt() == nullptr) payForField(polygon, cost);
  return fieldIfBuilt(polygon);
}

}  // namespace tricover::detail
