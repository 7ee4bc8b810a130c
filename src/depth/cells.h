// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "depth/deepest_point.h"
#include "depth/piece.h"
#include "depth/posed_side.h"

namespace tricover::detail {

/// Triangles of the plane, in which a point inside of the part is sought that is farthest from the area. Such a point
/// is a local maximum of the distance from the area: no direction leads away from all nearest points.
class Cells {
 public:
  Cells(const Overlap& overlap, const PosedSide& part, const PosedSide& area)
      : overlap_(overlap), part_(part), area_(area), rounding_(overlap.frame.error()) {}

  bool isOutsideOfArea(const Vec2& p) const;

  /// Whether a cell may hold a local maximum, by the sides of the edges that may be the nearest ones.
  bool mayHoldMaximum(const Piece& cell);

  /// What is left of a cell: none of it if it certainly holds no local maximum, otherwise its parts on both sides of an
  /// edge that leads through it, or of a line through its middle. A large cell is cut in the middle. The parts stay
  /// until the next call.
  const std::vector<Piece>& divide(const Piece& cell, bool is_large);

 private:
  bool gatherNearest(const Piece& cell);
  bool gather(const PosedSide& side, const Piece& cell, double reach, std::vector<EdgePosition>& edges) const;
  bool leadsAway() const;
  bool leadsAwayFrom(const Piece& cell) const;
  std::optional<Ends> edgeAcross(const Piece& cell, const PosedSide& side,
                                 const std::vector<EdgePosition>& edges) const;
  bool leadsThrough(const Piece& cell, const Ends& ends, double length) const;
  bool isFarFrom(const PosedSide& side, const Vec2& p) const { return side.nearest(p).distance > 4 * rounding_; }
  void cut(const Piece& cell, const std::optional<Ends>& edge);
  void addHalf(const Piece& cell, const OfCorners& beside, double side);

  const Overlap& overlap_;
  const PosedSide &part_, &area_;
  const double rounding_;
  std::vector<EdgePosition> nearest_, part_edges_;  ///< of the area, and of the part, that are near a cell
  std::vector<Piece> parts_;
};

}  // namespace tricover::detail
