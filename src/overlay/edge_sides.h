// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "pair/posed_pair.h"

namespace tricover::detail {

/// A point as filters see it, and as it is.
struct SeenPoint {
  ApproxPoint approx;
  PosedPoint exact;
};

/// Posed polygons, which the first one's translation sees: two, or one and many others.
class PosedRegions {
 public:
  /// What is sought beside the inside of the first: the inside of another one, or that no other one has it there. With
  /// that also pieces of the first that aren't beside its inside, nor on another one.
  enum Others { Inside, Outside };

  /// The first with each of the others.
  explicit PosedRegions(std::vector<PosedPair> pairs, Others sought = Inside)
      : pairs_(std::move(pairs)), sought_(sought) {}

  std::size_t size() const { return pairs_.size() + 1; }
  const PolygonData& polygon(std::size_t i) const { return i == 0 ? pairs_[0].a : pairs_[i - 1].b; }
  const Pose& pose(std::size_t i) const { return i == 0 ? pairs_[0].pose_a : pairs_[i - 1].pose_b; }
  Others sought() const { return sought_; }

  /// A vertex, by its position in the path.
  SeenPoint at(std::size_t i, std::size_t position) const {
    const Vec2& p = polygon(i).path[position];
    return {i == 0 ? pairs_[0].fromA(p) : pairs_[i - 1].fromB(p), {&pose(i), p}};
  }
  /// Whether a region may be as near to a segment as its disc is.
  bool isNear(std::size_t i, const ApproxPoint& v, const ApproxPoint& w) const;
  /// Any point of a polygon's frame.
  ApproxPoint approx(std::size_t i, const Vec2& p) const;
  /// A vertex of `of` in the frame of i.
  ApproxPoint inFrame(std::size_t i, std::size_t of, std::size_t position) const;

 private:
  std::vector<PosedPair> pairs_;
  Others sought_;
};

/// What regions have beside one edge of theirs, piece by piece: the edge is cut where others meet its line, and beside
/// a piece all windings are constant.
///
/// To the edge from v to w leads a way from where the winding number is known on its right: the edge before, or a way
/// from outside. Around v, counter-clockwise from that way back, edges leave v, or come to it: each that is passed
/// before v w adds to the winding numbers beside v w, on its left and right, and one along v w to the left alone. From
/// v to w each edge that ends in, or crosses, the line from the left adds where its line does, at the place s from 0 at
/// v to 1 at w. An edge to the left or right of which the way is led doesn't count while it is on the line. Nothing
/// else has to be known of edges on the line, or that end in one point of it, but on which side their ends are.
class EdgeSides {
 public:
  enum Operand : std::size_t { A = 0, B = 1 };

  /// `before`: the sides of the edge that ends where this one begins, if they are known.
  EdgeSides(const PosedRegions& regions, std::size_t operand, std::size_t edge, const EdgeSides* before = nullptr);

  /// Whether some piece of it is what is sought, or beside that on one side: of a pair, the inside of both regions.
  bool hasSought() const { return !sought_.empty(); }
  /// Whether that is, of a pair, beside a piece that shares a point with this edge, which meets it. `edge` is the other
  /// operand's.
  bool bordersBothAt(std::size_t edge) const { return isAnyAt(sought_, edge); }
  /// The same on the way from its start (side 1), or back from its end (-1), to the first of some of the other
  /// operand's edges, which meet it.
  bool bordersBothUntil(const std::vector<std::size_t>& edges, int side) const {
    return isAnyUntil(sought_, edges, side);
  }
  /// Whether some piece of an area's edge, beside which no area has its inside on one side at least, is nearer than a
  /// margin to an edge of the first region, as the edge as a whole is. For regions of which what others don't hold is
  /// sought. Exact.
  bool hasBoundaryWithin(std::size_t edge, double margin) const;
  /// Whether along some piece of it its own polygon has no inside on either side.
  bool isBare() const { return !bare_.empty(); }
  /// Whether its own polygon has its inside on both sides of all pieces that share a point with this edge, as above.
  bool isSeamAt(std::size_t edge) const { return !isAnyAt(borders_, edge) && !isAnyAt(bare_, edge); }
  /// Whether some piece of it is in the interior of the other region of a pair; at an edge and until some, as above.
  bool isInOther() const { return !in_other_.empty(); }
  bool isInOtherAt(std::size_t edge) const { return isAnyAt(in_other_, edge); }
  bool isInOtherUntil(const std::vector<std::size_t>& edges, int side) const {
    return isAnyUntil(in_other_, edges, side);
  }
  /// Whether along some piece of it that polygon has its inside on one side alone; or on both, or on none.
  bool isBorder() const { return !borders_.empty(); }
  bool isSeam() const { return is_seam_; }
  struct Piece {
    double from, to;   ///< places, rounded: 0 at its start, 1 at its end
    bool is_border;    ///< whether its own polygon has its inside on one side alone
    bool is_boundary;  ///< whether no region but the first has its inside on both sides, if it isn't the first one's
  };
  std::vector<Piece> pieces() const;

 private:
  /// Where another edge leaves the line or comes to it; v and w are the first and the last one.
  struct Cut {
    PosedSegment edge() const { return {pose, ends}; }

    const Pose* pose;
    Vec2 ends[2];  ///< of its edge, or twice that of an edge along the line
    std::size_t operand;
    std::int8_t turn;  ///< what it adds to the winding number of its polygon, as the way crosses it
    bool on_left, on_right;
    std::int8_t along;  ///< what it adds to the number of edges along the line
    double low, high;   ///< of its place; infinite at v and w
  };
  struct Windings {
    void add(const Cut& cut) {
      if (cut.on_left) left += cut.turn;
      if (cut.on_right) right += cut.turn;
      along += cut.along;
    }
    int left = 0, right = 0;
    int along = 0;  ///< edges of other operands along the line: counted where that matters
  };
  struct Sides {
    bool left, right;
  };
  /// A place from which the way comes straight to v, and the winding number on its right at v.
  struct Way {
    Pose pose;  ///< of its begin, where that is no vertex
    SeenPoint from;
    int winding = 0;
    int course = kUncertain;  ///< the side of v from on which w is, once it is known
    bool leads_back = false;  ///< whether w is straight back
  };

  void findCuts(std::size_t operand, const EdgeSides* before);
  void leadFromOutside(Way& way, std::size_t operand, const Vec2& at, double error) const;
  void add(std::size_t operand, std::size_t edge, Way& way);
  void addAlong(std::size_t operand, const SeenPoint& q, const SeenPoint& r);
  void addPoint(std::size_t operand, const PosedPoint& point, std::int8_t along, double low, double high);
  void pass(Way& way, const SeenPoint& end, int side, int turn);
  int compareAlong(const SeenPoint& p, const SeenPoint& q) const;
  bool isBefore(const Cut& p, const Cut& q) const;
  bool isBeyond(std::size_t edge, const Cut& cut, int side) const;
  bool isAnyAt(const std::vector<std::size_t>& pieces, std::size_t edge) const;
  bool isAnyUntil(const std::vector<std::size_t>& pieces, const std::vector<std::size_t>& edges, int side) const;
  Sides insides(std::size_t operand) const;
  PosedSegment edgeOf(std::size_t operand, std::size_t edge) const {
    return {&regions_.pose(operand), &regions_.polygon(operand).path[edge]};
  }
  bool isWithin(std::size_t piece, std::size_t edge, double margin) const;
  void look(std::size_t piece);

  const PosedRegions& regions_;
  const std::size_t operand_, edge_;
  SeenPoint v_, w_;
  std::map<std::size_t, Windings> windings_;  ///< of operands that are near, beside the current piece, at last at w
  std::vector<Cut> cuts_;                     ///< from v to w, in order; a piece has the number of the cut before it
  std::vector<std::size_t> sought_;           ///< pieces that are what is sought, or beside it on one side
  std::vector<std::size_t> boundary_;  ///< those beside which no other region but the first has its inside on both
  std::vector<std::size_t> bare_;      ///< those beside which it has that on neither
  std::vector<std::size_t> in_other_;  ///< those in the interior of the other region of a pair
  std::vector<std::size_t> borders_;   ///< those beside which its own polygon has its inside on one side alone
  bool is_seam_ = false;
};

/// The sides of edges, each looked at once, when it is asked for: from one to the next around their common vertex.
class KnownSides {
 public:
  explicit KnownSides(PosedRegions regions) : regions_(std::move(regions)) {}
  KnownSides(const KnownSides&) = delete;
  KnownSides& operator=(const KnownSides&) = delete;

  const EdgeSides* ifKnown(std::size_t operand, std::size_t edge) const {
    const auto known = known_.find({operand, edge});
    return known != known_.end() ? &known->second : nullptr;
  }
  const EdgeSides& of(std::size_t operand, std::size_t edge);

 private:
  const PosedRegions regions_;
  std::map<std::pair<std::size_t, std::size_t>, EdgeSides> known_;  ///< by operand and edge
};

/// Whether the filters prove that two edges of a pair cross, each with no other edge of its polygon there. Then both
/// regions have their inside in one of the four quadrants: the windings beside each edge differ by 1.
bool crossAlone(const PosedPair& pair, std::size_t i, std::size_t j);

}  // namespace tricover::detail
