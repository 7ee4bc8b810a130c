// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "contact/crossings.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// A piece of an edge that bounds a component of the overlap, in the WorldFrame.
struct OutlinePiece {
  Ends edge;              ///< all of the edge
  Span on;                ///< the piece
  Span known;             ///< the part of the edge that has its region where `left` and `right` say
  int side;               ///< whose edge it is: 0 is a, 1 is b
  EdgePosition position;  ///< of the edge
  bool left, right;       ///< where the edge's own region is beside it

  Vec2 way() const { return edge.w - edge.v; }
  double length() const { return way().norm() * (on.high - on.low); }
  Ends knownEnds() const { return {edge.v + known.low * way(), edge.w - (1 - known.high) * way()}; }
  /// Whether the region is on the left (turn > 0), or on the right.
  bool isInside(double turn) const { return turn > 0 ? left : right; }
};

/// How far b must move along a direction until it has left a in one component of the overlap: on each line along the
/// direction through the component, from where b begins below to where a ends above. Both are sought on all that is
/// known of the edges whose pieces bound the component. Where none of them is met, the end of the region's disc counts.
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
    bool is_top_corner = false;   ///< a has a corner there: what b must pass is the line of its own edge
    Vec2 inside = Vec2::Zero();   ///< a point of the component on a line beside
  };

  /// Distances below `error` count as none.
  ExitLength(const std::vector<OutlinePiece>& pieces, const Disc& a, const Disc& b, double error)
      : pieces_(pieces),
        a_(a),
        b_(b),
        error_(error),
        thin_(16 * error),
        steps_left_(kFewSteps + kStepsAPiece * pieces.size()) {}

  /// Edges that lean by less are across a direction.
  static constexpr double kSameAngle = 0x1p-40;

  // Directions are unit vectors.
  /// Whether so many steps were taken that no other length is known.
  bool isSpent() const { return is_spent_; }
  /// May end early, with a length that is more than `enough`. The length is infinite once they are spent.
  Result along(const Vec2& direction, double enough);
  /// At least that length, in O(n): between the ends of all pieces. Where the component ends above at an edge of b, a
  /// goes on, and its disc's end counts; below at an edge of a, b's. Its place isn't known.
  Result atMost(const Vec2& direction) const;
  /// At most that length, but for rounding, in O(n): on the line through a point of the component. And between the ends
  /// that are known there.
  struct Through {
    double length, thickness;
  };
  Through throughPoint(const Vec2& point, const Vec2& direction) const;

 private:
  /// An edge as seen along the direction: heights over places across it.
  struct Seen {
    double heightAt(double place) const {
      return place - low < high - place ? low_height + std::max(place - low, 0.0) * slope
                                        : high_height - std::max(high - place, 0.0) * slope;
    }
    bool isPiece(double from, double to, double error) const {
      return piece_low <= from + error && piece_high >= to - error;
    }

    const OutlinePiece* piece;
    double low, high;  ///< places of the edge's ends
    double low_height, high_height, slope;
    double piece_low, piece_high;
    bool is_exit, is_entry;  ///< a ends, or b begins, here
    bool is_across;          ///< it is a right angle to the direction
    double height;           ///< where lines are looked at
  };
  void see(const Vec2& direction);
  void spend(std::size_t steps);
  void sortActive(double place);
  void look(double from, double to, Result& result);

  static constexpr std::size_t kFewSteps = 1792, kStepsAPiece = 28, kStepsToSee = 16, kStepsToLook = 6;

  const std::vector<OutlinePiece>& pieces_;
  const Disc a_, b_;
  const double error_;
  const double thin_;  ///< lines in a range that is no wider don't count: ends of pieces are off by some errors
  std::vector<Seen> seen_;
  std::vector<std::pair<double, std::size_t>> order_;  ///< of those, by their low places
  std::vector<double> places_;                         ///< where edges end, or pieces begin or end within them
  std::vector<Seen*> active_;                          ///< of those, the lowest first
  double highest_ = 0, lowest_ = 0;
  std::size_t steps_left_;
  bool is_spent_ = false;
};

}  // namespace tricover::detail
