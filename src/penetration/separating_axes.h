// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "convex/convex_outline.h"
#include "convex/posed_ring.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// One of two polygons by its outline, in the world less a's translation.
struct AxisSide {
  AxisSide(const PolygonData& polygon_, const Pose& pose, Double2 shift)
      : polygon(polygon_), outline(convexOutlineOf(polygon)), ring(outline.ring(), pose, shift) {}

  /// Outwards from an edge, a unit vector.
  Vec2 normalOf(EdgePosition edge) const {
    const Double2 normal = ring.normal(edge);
    return Vec2(normal[0], normal[1]).normalized();
  }

  /// An edge's climb along a normal of the other outline, in the world, is off by this at most.
  double climbError(Double2 n) const;

  const PolygonData& polygon;
  const ConvexOutline& outline;
  const PosedRing ring;  ///< counter-clockwise in its own frame
};

/// Corners of an outline, in the frame of another one: of few four all around it, of many one at a time.
class OtherCorners {
 public:
  OtherCorners(const PosedRing& own, const PosedRing& other, std::uint32_t corner) : own_(own), other_(other) {
    put(corner);
    for (std::uint32_t k = 0; k < 2 && areFew(); ++k) {
      const Double2 p = inOwnFrame(2 * k * other.ring.size() / 4), q = inOwnFrame((2 * k + 1) * other.ring.size() / 4);
      x_[k] = Double2{p[0], q[0]};
      y_[k] = Double2{p[1], q[1]};
    }
  }
  /// A corner that is deep behind a face is so behind the next one.
  void put(std::uint32_t corner) {
    if (!areFew()) one_ = inOwnFrame(corner);
  }
  /// The largest area |way, corner - start|.
  double largestArea(Double2 start, Double2 way) const {
    if (!areFew()) return cross(way, one_ - start);
    const auto areas = [&](int k) { return way[0] * (y_[k] - start[1]) - way[1] * (x_[k] - start[0]); };
    const Double2 both = larger(areas(0), areas(1));
    return std::max(both[0], both[1]);
  }

 private:
  bool areFew() const { return other_.ring.size() <= 8; }
  Double2 inOwnFrame(std::uint32_t corner) const { return own_.inOwnFrame(other_.corner(corner)); }

  const PosedRing &own_, &other_;
  Double2 x_[2]{}, y_[2]{}, one_{};
};

/// A face of either outline, and the corner of the other one that is deepest behind it.
struct FaceDepth {
  bool of_a;
  bool certain;  ///< no other corner may be as deep
  EdgePosition edge, deepest;
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
  double leastDepth() const { return best_.depth; }
  /// How far a pair is apart at least.
  double gap() const { return gap_; }

  const AxisSide& side(bool of_a) const { return of_a ? a_ : b_; }
  /// At least what a corner is off by here and in the other one's frame, in either coordinate.
  double error() const { return kError * size_; }
  /// At least the lengths of any corner of a's frame, one of b's and the two translations' difference together.
  double size() const { return size_; }
  /// What a depth is off by, at most.
  double depthError() const { return kDepthError * error(); }
  /// What counts as equally deep.
  double tie() const { return 4 * error(); }

 private:
  Verdict lookBehindAll();
  Verdict lookBehind(bool of_a, EdgePosition edge, std::uint32_t& at);
  std::uint32_t edgeTowardsB() const;
  double limit() const;
  double mostSquare() const;
  void add(const FaceDepth& face);
  void removeDeep();

  static constexpr double kDepthError = 12;  ///< in units of error()
  static constexpr double kError = 20 * kUnitRoundoff;

  const PosedPair& pair_;
  const double size_;
  const AxisSide a_, b_;
  const double within_;
  FaceDepth best_{true, false, 0, 0, std::numeric_limits<double>::infinity()};
  double least_left_out_ = best_.depth;
  std::array<FaceDepth, 8> least_;
  std::size_t count_ = 0;
  double gap_ = 0;
  Verdict verdict_ = Unsure;
};

/// The shortest translation of b that separates two convex sets which meet.
struct SupportGap : FaceDepth {
  Vec2 normal;  ///< unit, from a towards where b leaves
};

/// By separating axes, which are null unless both outlines have an area: the least support gap over the normals of both
/// polygons' convex outlines, O(n + m) as a rule; of those that are deeper by no more than `tie`, the one that leads
/// b's S away from a's. The gap is evaluated in double doubles from both unrounded poses, so its relative error is
/// below 1e-15 while it is above 1e-14 of the coordinates involved (world coordinates less what both translations
/// share), and below 2^-97 of them in any case.
SupportGap leastSupportGap(const PosedPair& pair, const SeparatingAxes* axes, double tie);

}  // namespace tricover::detail
