// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "overlay/line_sweep.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// Posed polygons, which the first one's translation sees: one, two, or one and many others.
class PosedRegions {
 public:
  /// The first with each of the others. `finds_along`: whether edges of others that run along the first's count.
  explicit PosedRegions(std::vector<PosedPair> pairs, bool finds_along = false)
      : pairs_(std::move(pairs)), size_(pairs_.size() + 1), finds_along_(finds_along) {}
  /// One alone, in its own frame.
  explicit PosedRegions(const PolygonData& polygon);

  std::size_t size() const { return size_; }
  const PolygonData& polygon(std::size_t i) const { return i == 0 ? pairs_[0].a : pairs_[i - 1].b; }
  const Pose& pose(std::size_t i) const { return i == 0 ? pairs_[0].pose_a : pairs_[i - 1].pose_b; }
  bool findsAlong() const { return finds_along_; }

  /// A vertex, by its position in the path.
  SeenPoint at(std::size_t i, EdgePosition position) const {
    const Vec2& p = polygon(i).path[position];
    return {i == 0 ? pairs_[0].fromA(p) : pairs_[i - 1].fromB(p), {&pose(i), p}};
  }
  PosedSegment edge(std::size_t i, EdgePosition edge) const { return {&pose(i), &polygon(i).path[edge]}; }
  /// Whether a region may be as near to a segment as its disc is.
  bool isNear(std::size_t i, const ApproxPoint& v, const ApproxPoint& w) const;
  /// Any point of a polygon's frame.
  ApproxPoint approx(std::size_t i, const Vec2& p) const;
  /// A vertex of `of` in the frame of i.
  ApproxPoint inFrame(std::size_t i, std::size_t of, EdgePosition position) const;

 private:
  std::vector<PosedPair> pairs_;
  std::size_t size_;
  bool finds_along_;
};

/// What regions have beside one edge of theirs, piece by piece. The edge is swept from its start v to its end w. The
/// events are where edges meet it, and between two events all winding numbers beside it are constant.
///
/// The sweep comes to v from a point u where the winding numbers are known: along the edge before, if that was swept,
/// or straight from outside of the polygon. There it goes around v, from u v to v w.
class EdgeSides {
 public:
  enum Operand : std::size_t { A = 0, B = 1 };

  /// On which sides of the edge a region has its inside.
  struct Sides {
    bool both() const { return left && right; }
    bool any() const { return left || right; }
    bool left, right;
  };
  /// What is between two events.
  struct Piece {
    /// Whether the edge's own polygon has its inside on one side alone; on none; on both.
    bool isBorder() const { return own.left != own.right; }
    bool isNoBorder() const { return own.left == own.right; }
    bool isBare() const { return !own.any(); }
    bool isNoSeam() const { return !own.both(); }
    /// Whether the first region and another one have their inside on the same side.
    bool bordersBoth() const { return (first.left && others.left) || (first.right && others.right); }
    /// Whether the piece is in the interior of the other region of a pair.
    bool isInOther() const { return is_of_first ? others.both() : first.both(); }
    /// Whether beside the piece, or on it, the first region has what no other one has.
    bool isUncovered() const {
      const bool is_off = is_of_first && isBare() && !others.any() && !has_along;
      return (first.left && !others.left) || (first.right && !others.right) || is_off;
    }
    /// Whether the piece is not the first's, and no region but the first has its inside on both sides.
    bool isBoundary() const { return !is_of_first && !others.both(); }

    double from, to;    ///< places, rounded: 0 at the edge's start, 1 at its end
    std::size_t event;  ///< the last one before
    bool is_of_first;   ///< the edge
    Sides own, first;
    Sides others;    ///< of some region but the first
    bool has_along;  ///< edges of other regions run along it, if that is asked
  };

  /// `before`: the sides of the edge that ends where this one begins, if they are known.
  EdgeSides(const PosedRegions& regions, std::size_t operand, EdgePosition edge, const EdgeSides* before = nullptr);

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// `Is`: a question to pieces. Whether some piece answers it.
  using Is = bool (Piece::*)() const;
  bool hasAny(Is is) const;
  /// The same of pieces that share a point with another operand's edge, which meets this one.
  bool hasAnyAt(Is is, EdgePosition edge) const;
  /// The same on the way from its start (side 1), or back from its end (-1), to the first of some of the other
  /// operand's edges, which meet it.
  bool hasAnyUntil(Is is, const std::vector<EdgePosition>& edges, int side) const;
  /// Whether some piece that is a boundary is nearer than a margin to an edge of the first region, as the edge as a
  /// whole is. Exact.
  bool hasBoundaryWithin(EdgePosition edge, double margin) const;

 private:
  /// A segment from u to v, and the winding numbers beside it at v.
  struct Approach {
    Pose pose;  ///< of u, where that is no vertex
    SeenPoint u;
    Windings windings;
    int bend = 0;             ///< the side of u v to which v w leads
    bool leads_back = false;  ///< whether that is straight back
  };

  void findEvents(std::size_t operand, const EdgeSides* before);
  void comeFromOutside(Approach& approach, std::size_t operand, const Vec2& at, double error) const;
  void addEvent(const LineMeeting& meeting, const SeenPoint& q, const SeenPoint& r);
  void goAround(const Approach& approach, const LineMeeting& meeting, const SeenPoint& q, const SeenPoint& r);
  Sides insides(std::size_t operand) const;
  void addPiece(std::size_t event);
  bool isBeyond(EdgePosition edge, const SweepEvent& event, int side) const;
  bool isWithin(const Piece& piece, EdgePosition edge, double margin) const;

  const PosedRegions& regions_;
  const std::size_t operand_;
  const EdgePosition edge_;
  const LineSweep line_;
  std::map<std::size_t, Windings> windings_;  ///< of operands that are near, beside the current piece, at last at w
  std::vector<SweepEvent> events_;            ///< from v to w, which are the first and the last one, in order
  std::vector<Piece> pieces_;
};

/// The sides of edges, each looked at once, when it is asked for: from one to the next around their common vertex.
class KnownSides {
 public:
  explicit KnownSides(PosedRegions regions) : regions_(std::move(regions)) {}
  KnownSides(const KnownSides&) = delete;
  KnownSides& operator=(const KnownSides&) = delete;

  const EdgeSides* ifKnown(std::size_t operand, EdgePosition edge) const {
    const auto known = known_.find({operand, edge});
    return known != known_.end() ? &known->second : nullptr;
  }
  const EdgeSides& of(std::size_t operand, EdgePosition edge);

 private:
  const PosedRegions regions_;
  std::map<std::pair<std::size_t, EdgePosition>, EdgeSides> known_;  ///< by operand and edge
};

/// Whether the filters prove that two edges of a pair cross, each with no other edge of its polygon there. Then both
/// regions have their inside in one of the four quadrants: the windings beside each edge differ by 1.
bool crossAlone(const PosedPair& pair, EdgePosition i, EdgePosition j);

}  // namespace tricover::detail
