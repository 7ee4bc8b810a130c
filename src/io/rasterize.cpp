// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/rasterize.h"

#include <algorithm>

#include "numbers/errors.h"
#include "polygon/grid_corners.h"
#include "tricover/collide.h"
#include "tricover/covers.h"

namespace tricover {
namespace {

/// Cells side by side in one row, by their indices.
struct Run {
  std::size_t begin, end;
};

/// A block of cells, [left, right) x [bottom, top).
struct Block {
  std::size_t left, bottom, right, top;

  std::size_t width() const { return right - left; }
  std::size_t height() const { return top - bottom; }
};

/// Decides blocks of cells. A block's corners are corners of cells, so its region is that of its cells, exactly.
class Rasterizer {
 public:
  Rasterizer(const Polygon& polygon, const Pose& pose, const OccupancyGrid& grid, const Pose& pose_grid,
             const CollideOptions& options)
      : polygon_(polygon),
        pose_(pose),
        pose_grid_(pose_grid),
        options_(options),
        stride_(grid.width),
        x_(detail::gridCorners(grid.origin.x(), grid.resolution, grid.width)),
        y_(detail::gridCorners(grid.origin.y(), grid.resolution, grid.height)) {
    add({0, 0, grid.width, grid.height});
  }

  std::vector<std::size_t> cells() {
    std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) { return a.begin < b.begin; });
    std::vector<std::size_t> result;
    for (const Run& run : runs_)
      for (std::size_t cell = run.begin; cell < run.end; ++cell) result.push_back(cell);
    return result;
  }

 private:
  /// Adds what the polygon meets of a block. Its longer side is halved, 32 times at most.
  void add(const Block& block) {
    const Polygon region({{x_[block.left], y_[block.bottom]},
                          {x_[block.right], y_[block.bottom]},
                          {x_[block.right], y_[block.top]},
                          {x_[block.left], y_[block.top]}});
    if (!collide(polygon_, pose_, region, pose_grid_, options_)) return;
    if ((block.width() == 1 && block.height() == 1) || isAllIn(block, region)) {
      for (std::size_t row = block.bottom; row < block.top; ++row)
        runs_.push_back({row * stride_ + block.left, row * stride_ + block.right});
      return;
    }
    Block low = block, high = block;
    if (block.width() > block.height())
      low.right = high.left = block.left + block.width() / 2;
    else
      low.top = high.bottom = block.bottom + block.height() / 2;
    add(low);
    add(high);
  }

  /// Whether it is known at once that the polygon meets every cell.
  bool isAllIn(const Block& block, const Polygon& region) const {
    // Lengths in the world differ from these by what poses may stretch, and by rounding.
    constexpr double kMore = 1.001;
    if (options_.margin < 0) return covers(polygon_, pose_, region, pose_grid_, {-kMore * options_.margin});
    if (options_.margin > 0) {
      // What one point of the block is within of the polygon, all of it is within of that and the block's diagonal.
      const Vec2 diagonal(x_[block.right] - x_[block.left], y_[block.top] - y_[block.bottom]);
      const double margin = options_.margin - kMore * diagonal.norm();
      if (margin > 0 && collide(polygon_, pose_, region, pose_grid_, {margin})) return true;
    }
    return covers(polygon_, pose_, region, pose_grid_);
  }

  const Polygon& polygon_;
  const Pose &pose_, &pose_grid_;
  CollideOptions options_;
  std::size_t stride_;
  std::vector<double> x_, y_;  ///< of the corners
  std::vector<Run> runs_;
};

std::vector<std::size_t> rasterized(const Polygon& polygon, const Pose& pose, const OccupancyGrid& grid,
                                    const Pose& pose_grid, const CollideOptions& options) {
  detail::checkCells(grid);
  checkPose(pose);
  checkPose(pose_grid, "map.pose");
  detail::requireFiniteMargin(options.margin, "margin");
  detail::requireFiniteNotNegative(options.tolerance, "tolerance");
  detail::requireTouching(options.touching);
  if (grid.cells.empty()) return {};
  return Rasterizer(polygon, pose, grid, pose_grid, options).cells();
}

}  // namespace

std::vector<std::size_t> rasterize(const Polygon& polygon, const Pose& pose, const OccupancyMap& map,
                                   const CollideOptions& options) {
  return rasterized(polygon, pose, map.grid, map.pose, options);
}

std::vector<std::size_t> rasterize(const Polygon& polygon, const Pose& pose, const OccupancyGrid& grid,
                                   const CollideOptions& options) {
  return rasterized(polygon, pose, grid, Pose::Identity(), options);
}

}  // namespace tricover
