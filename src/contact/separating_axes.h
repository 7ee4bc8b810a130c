// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "convex/convex_outline.h"
#include "convex/convex_ring.h"
#include "hierarchy/simd.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// One of two polygons as its own frame sees it, and the other one's points there.
struct AxisSide {
  AxisSide(const PosedPair& seen_, const ConvexOutline& outline_);

  const Vec2& corner(std::size_t k) const { return outline.points[k]; }
  /// The other one's point in this frame, off by at most SeparatingAxes::error().
  Vec2 fromOther(const Vec2& p) const {
    const ApproxPoint mapped = seen.fromB(p);
    return {mapped.x, mapped.y};
  }
  /// Of this frame, in the world.
  Vec2 inWorld(const Vec2& way) const { return linear * way; }
  /// Outwards from an edge, in the world; a unit vector.
  Vec2 normalOf(std::uint32_t edge) const;

  const PosedPair& seen;
  const ConvexOutline& outline;
  const ConvexRing ring;  ///< counter-clockwise
  const Eigen::Matrix2d linear;
  const bool mirrors;        ///< the pose
  const double determinant;  ///< its magnitude
};

/// A face of either outline, and the corner of the other one that is deepest behind it.
struct FaceDepth {
  bool of_a;
  bool certain;  ///< no other corner may be as deep
  std::uint32_t edge, deepest;
  double depth;  ///< in the world
};

/// Separating axes of two convex outlines with an area, in plain doubles: how deep either one reaches behind the faces
/// of the other. Each face is asked in its own polygon's frame, so that its direction is as precise as it was given,
/// however short it is.
class SeparatingAxes {
 public:
  enum Verdict { Unsure, Apart, Meet };

  explicit SeparatingAxes(const PosedPair& pair);
  SeparatingAxes(const SeparatingAxes&) = delete;
  SeparatingAxes& operator=(const SeparatingAxes&) = delete;

  /// Unsure where doubles don't tell, or too many faces are the best.
  Verdict verdict() const { return verdict_; }
  /// Of a pair that meets all faces that are deeper than the least one by no more than tie() and what depths are off
  /// by.
  const FaceDepth* begin() const { return least_.data(); }
  const FaceDepth* end() const { return least_.data() + count_; }
  double leastDepth() const { return least_depth_; }

  const AxisSide& side(bool of_a) const { return of_a ? a_ : b_; }
  /// At least what a corner of either is off by in the other one's frame, and 16U of any coordinate there.
  double error() const { return error_; }
  /// What counts as equally deep.
  double tie() const { return 4 * error_; }

 private:
  Verdict lookBehindAll(std::uint32_t first_of_a);
  Verdict lookBehind(bool of_a, std::uint32_t edge, std::uint32_t at, FaceDepth& face, Vec2& deepest);
  std::uint32_t edgeTowardsOther(const AxisSide& side) const;
  void skipDeep(const AxisSide& side, const Vec2& p, std::uint32_t& edge, std::uint32_t& left) const;
  double limit() const;
  void add(const FaceDepth& face);
  void removeDeep();

  /// What a depth is off by, at most, in units of error().
  static constexpr double kDepthError = 12;

  const PosedPair swapped_;
  const AxisSide a_, b_;
  const double error_, within_;
  double least_depth_ = std::numeric_limits<double>::infinity(), least_left_out_ = least_depth_;
  std::array<FaceDepth, 8> least_;
  std::size_t count_ = 0;
  Verdict verdict_ = Unsure;
};

}  // namespace tricover::detail
