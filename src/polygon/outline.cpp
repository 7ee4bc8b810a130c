// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/outline.h"

#include <utility>

#include "numbers/errors.h"
#include "polygon/grid_corners.h"

namespace tricover {
namespace {

/// The four directions along a grid's lines, counter-clockwise.
enum Heading { kEast, kNorth, kWest, kSouth };

class Tracer {
 public:
  Tracer(const OccupancyGrid& grid, const IsOccupied& is_occupied)
      : width_(grid.width),
        height_(grid.height),
        stride_(grid.width + 2),
        occupied_(stride_ * (grid.height + 2)),
        traced_(occupied_.size()),
        x_(detail::gridCorners(grid.origin.x(), grid.resolution, grid.width)),
        y_(detail::gridCorners(grid.origin.y(), grid.resolution, grid.height)) {
    for (std::size_t y = 0; y < height_; ++y)
      for (std::size_t x = 0; x < width_; ++x) occupied_[cell(x, y)] = is_occupied(grid.cells[y * width_ + x]);
  }

  /// A closed outline has an edge that leads east: every one is found by its first.
  std::vector<Ring> rings() {
    std::vector<Ring> result;
    for (std::size_t y = 0; y < height_; ++y)
      for (std::size_t x = 0; x < width_; ++x)
        if (occupied_[cell(x, y)] && !occupied_[cell(x, y) - stride_] && !traced_[cell(x, y)])
          result.push_back(trace(x, y));
    return result;
  }

 private:
  /// Cells are kept with a free margin around them.
  std::size_t cell(std::size_t x, std::size_t y) const { return (y + 1) * stride_ + x + 1; }

  static Heading toTheLeft(Heading heading) { return static_cast<Heading>((heading + 1) % 4); }
  static Heading toTheRight(Heading heading) { return static_cast<Heading>((heading + 3) % 4); }

  /// The cell ahead of the corner (x, y), on the left.
  bool aheadLeft(std::size_t x, std::size_t y, Heading heading) const {
    return occupied_[cell(x, y) - (heading == kWest || heading == kNorth ? 1 : 0) -
                     (heading == kWest || heading == kSouth ? stride_ : 0)];
  }

  /// Along the occupied cell's lower side, and on with the occupied cells on the left.
  Ring trace(std::size_t x, std::size_t y) {
    Ring ring;
    Heading heading = kEast;
    while (true) {
      if (heading == kEast) {
        // The first edge comes up again only when the ring is closed: nothing else leads east along it.
        if (traced_[cell(x, y)]) break;
        traced_[cell(x, y)] = true;
      }
      x += heading == kEast ? 1 : 0;
      y += heading == kNorth ? 1 : 0;
      x -= heading == kWest ? 1 : 0;
      y -= heading == kSouth ? 1 : 0;
      const bool left = aheadLeft(x, y, heading), right = aheadLeft(x, y, toTheRight(heading));
      if (left && !right) continue;
      ring.emplace_back(x_[x], y_[y]);
      // With the cells ahead free or the right one alone occupied, which shares but a corner, around this one.
      heading = left ? toTheRight(heading) : toTheLeft(heading);
    }
    return ring;
  }

  std::size_t width_, height_, stride_;
  std::vector<bool> occupied_, traced_;  ///< by cell; its lower side is part of a ring that was traced
  std::vector<double> x_, y_;            ///< of the corners
};

}  // namespace

std::optional<Polygon> outline(const OccupancyGrid& grid, const IsOccupied& is_occupied) {
  if (!is_occupied) detail::refuse("is_occupied", "it is empty");
  detail::checkCells(grid);
  std::vector<Ring> rings = Tracer(grid, is_occupied).rings();
  if (rings.empty()) return std::nullopt;
  return Polygon(std::move(rings));
}

}  // namespace tricover
