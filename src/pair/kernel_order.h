// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "polygon/polygon_data.h"
#include "tricover/motion.h"

namespace tricover::detail {

/// A total order of finite doubles: -0 is before 0, because what is asked with one may be asked again with the other,
/// the operands swapped.
inline bool isSmaller(double x, double y) { return x != y ? x < y : std::signbit(x) && !std::signbit(y); }

inline std::array<double, 6> numbersOf(const Pose& pose) {
  const auto& m = pose.matrix();
  return {m(0, 0), m(1, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2)};
}

inline std::array<double, 17> numbersOf(const Motion& motion) {
  const auto& m = motion.start.matrix();
  return {m(0, 0),
          m(1, 0),
          m(0, 1),
          m(1, 1),
          m(0, 2),
          m(1, 2),
          motion.shift.x(),
          motion.shift.y(),
          motion.angle,
          motion.pivot.x(),
          motion.pivot.y(),
          motion.shift_2.x(),
          motion.shift_2.y(),
          motion.shift_3.x(),
          motion.shift_3.y(),
          motion.angle_2,
          motion.angle_3};
}

/// Which of two polygons of one fill rule, with equally many vertices, is first by its edges. Negative: a, positive: b.
/// 0 if their edges are the same, wherever rings begin and whichever way they run; under the non-zero rule, ways count.
int compareEdges(const PolygonData& a, const PolygonData& b);

/// The kernel's own order of two operands, so that answers don't depend on the caller's: the smaller polygon moves. Of
/// polygons of equal radius the number of vertices and the fill rule decide, then the pose or motion, then the edges.
/// Neither ids nor addresses do: results repeat from run to run. Equal operands leave the caller's order.
template <typename PoseOrMotion>
bool inOrder(const PolygonData& a, const PoseOrMotion& pose_a, const PolygonData& b, const PoseOrMotion& pose_b) {
  if (a.radius != b.radius) return a.radius > b.radius;
  if (a.path.size() != b.path.size()) return a.path.size() < b.path.size();
  if (a.fill.number() != b.fill.number()) return a.fill.number() < b.fill.number();
  const auto p = numbersOf(pose_a), q = numbersOf(pose_b);
  if (std::lexicographical_compare(q.begin(), q.end(), p.begin(), p.end(), isSmaller)) return true;
  if (std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(), isSmaller)) return false;
  return &a == &b || compareEdges(a, b) <= 0;
}

/// What query(a, pose_a, b, pose_b) returns of the operands in the kernel's order; in the caller's order again by
/// swapOperands(result).
template <typename PoseOrMotion, typename Query, typename SwapOperands>
auto inKernelOrder(const PolygonData& a, const PoseOrMotion& pose_a, const PolygonData& b, const PoseOrMotion& pose_b,
                   Query query, SwapOperands swapOperands) {
  // One call, so that it can be inlined.
  const bool in_order = inOrder(a, pose_a, b, pose_b);
  auto result = query(in_order ? a : b, in_order ? pose_a : pose_b, in_order ? b : a, in_order ? pose_b : pose_a);
  if (!in_order) swapOperands(result);
  return result;
}

}  // namespace tricover::detail
