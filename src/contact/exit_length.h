// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "contact/crossings.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// A piece of an edge that bounds a component of the overlap, in the WorldFrame.
struct OutlinePiece {
  Ends edge;              ///< all of the edge
  Span on;                ///< the piece
  std::int32_t side;      ///< whose edge it is: 0 is a, 1 is b
  std::int32_t position;  ///< of the edge in the path
  bool left, right;       ///< where the edge's own region is beside it

  Vec2 way() const { return edge.w - edge.v; }
  double length() const { return way().norm() * (on.high - on.low); }
};

/// How far b must move along a direction until it has left a in one component of the overlap: on each line along the
/// direction through the component, from where b begins below to where a ends above. Both are sought on all of the
/// edges whose pieces bound the component. Where none of them is met, the end of the region's disc counts.
class ExitLength {
 public:
  /// Around all of a region's vertices.
  struct Disc {
    Vec2 centre;
    double radius;
  };
  struct Result {
    double length = -std::numeric_limits<double>::infinity();  ///< the longest on any of the lines
    /// The longest that ends at an edge of a, or begins at an edge of b, across the direction.
    double own[2] = {length, length};
    /// On the longest line: where a ends and where b begins; null for an end. And its place across the direction.
    const OutlinePiece *top = nullptr, *bottom = nullptr;
    double place = 0, width = 0;  ///< `width` is that of lines like it
    bool is_top_corner = false;  ///< a has a corner there: what b must pass is the line of its own edge
  };

  /// Distances below `error` count as none.
  ExitLength(const std::vector<OutlinePiece>& pieces, const Disc& a, const Disc& b, double error)
      : pieces_(pieces), a_(a), b_(b), error_(error) {}

  /// `direction` is a unit vector. May end early, with a length that is more than `enough`.
  Result along(const Vec2& direction, double enough);

 private:
  /// An edge as seen along the direction: heights over places across it.
  struct Seen {
    double heightAt(double place) const;
    bool spans(double from, double to, double tiny) const { return low <= from + tiny && high >= to - tiny; }

    const OutlinePiece* piece;
    double low, high;            ///< places of the edge's ends
    double low_height, rise;     ///< the height at `low`, and how much more it is at `high`
    double piece_low, piece_high;
    bool is_exit, is_entry;      ///< a ends, or b begins, here
    bool is_across;              ///< it is a right angle to the direction
  };
  void see(const Vec2& direction);
  void look(double from, double to, Result& result) const;

  const std::vector<OutlinePiece>& pieces_;
  const Disc a_, b_;
  const double error_;
  std::vector<Seen> seen_;      ///< from low places to high ones
  std::vector<double> places_;  ///< where edges or pieces begin or end
  std::vector<const Seen*> active_;
  double highest_ = 0, lowest_ = 0;
};

/// The shortest exit, along `normal`, that is found from the normals of the edges, their sum and where two edges are
/// left at once. Among exits that are equally long but for rounding, the one that leads b's origin away from a's.
struct ShortestExit {
  Vec2 normal = Vec2::UnitX();
  double length = std::numeric_limits<double>::infinity();
  const OutlinePiece *top = nullptr, *bottom = nullptr;
  double place = 0;
  bool of_a = true;  ///< it leads across an edge of a, rather than of b
};
ShortestExit shortestExit(const std::vector<OutlinePiece>& pieces, const ExitLength::Disc& a, const ExitLength::Disc& b,
                          double error);

}  // namespace tricover::detail
