// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pair/four_ends.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// What both regions have beside one edge of a pair, piece by piece: the edge is cut where others meet its line, and
/// beside a piece both windings are constant.
///
/// Beside the edge from v to w, on its left, leads a way from far away, where the winding number is 0, through v to w.
/// It crosses every edge that ends in, or crosses, the line from the left, at the place s where that edge's line does,
/// from 0 at v to 1 at w. An edge to the left or right of which the way is led doesn't count while it is on the line.
/// So the winding number beside a place is the sum over the edges that are crossed before it, and nothing else has to
/// be known of the edges that are on the line, or end in one point of it, but on which side their ends are.
class EdgeSides {
 public:
  enum Operand { A = 0, B = 1 };

  /// `back` is the pair with its operands swapped.
  EdgeSides(const PosedPair& pair, const PosedPair& back, Operand operand, std::size_t edge);

  /// Whether beside some piece of it, on one side, both regions have their inside.
  bool bordersBoth() const { return !bordering_.empty(); }
  /// Whether that is beside a piece that shares a point with this edge, which meets it. `edge` is the other operand's.
  bool bordersBothAt(std::size_t edge) const;
  /// The same on the way from its start (side 1), or back from its end (-1), to the first of some of the other
  /// operand's edges, which meet it.
  bool bordersBothUntil(const std::vector<std::size_t>& edges, int side) const;
  /// Whether along some piece of it its own polygon has no inside on either side.
  bool isBare() const { return is_bare_; }
  /// Whether along some such piece the other one has it on both.
  bool isBareInside() const { return is_bare_inside_; }

 private:
  /// Where another edge leaves the line or comes to it.
  struct Cut {
    PosedSegment edge;
    Operand operand;
    std::int8_t turn;  ///< what it adds to the winding number of its polygon, as the way crosses it
    bool on_left, on_right;
    double low, high;  ///< of its place
  };
  struct Windings {
    int left = 0, right = 0;
    void add(const Cut& cut) {
      if (cut.on_left) left += cut.turn;
      if (cut.on_right) right += cut.turn;
    }
  };

  const PolygonData& polygon(Operand operand) const { return operand == A ? pair_.a : pair_.b; }
  PosedSegment segment(Operand operand, std::size_t edge) const {
    return {operand == A ? &pair_.pose_a : &pair_.pose_b, &polygon(operand).path[edge]};
  }
  ApproxPoint approx(Operand operand, std::size_t position) const {
    return operand == A ? pair_.fromA(pair_.a.path[position]) : pair_.fromB(pair_.b.path[position]);
  }

  /// The ends of the edge, 0 and 1, and of another one, 2 and 3.
  FourEnds endsWith(Operand operand, std::size_t edge) const;
  void findCuts(Operand operand, const PosedPair& seen);
  void add(Operand operand, std::size_t edge);
  bool isBefore(const Cut& p, const Cut& q) const;
  bool isBeyond(const FourEnds& ends, const Cut& cut, int side) const;
  void look(std::size_t begin, std::size_t end);

  const PosedPair& pair_;
  const Operand operand_;
  const std::size_t edge_;
  Windings windings_[2];   ///< beside the current piece
  std::vector<Cut> cuts_;  ///< between v and w, in order
  /// By a cut at its begin and one at its end; kNone at v and w.
  struct Piece {
    std::size_t begin, end;
  };
  static constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<Piece> bordering_;  ///< pieces beside which, on one side, both regions have their inside
  bool is_bare_ = false, is_bare_inside_ = false;
};

}  // namespace tricover::detail
