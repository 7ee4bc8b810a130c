// SPDX-License-Identifier: BSD-3-Clause
#include "penetration/convex_penetration.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "convex/convex_outline.h"
#include "convex/convex_ring.h"
#include "numbers/double_double.h"

namespace tricover::detail {
namespace {

/// Corners in the world less a's translation, times a power of two that keeps products in range.
class Corners {
 public:
  Corners(const ConvexOutline& outline, const Pose& pose, const DoubleDouble2& shift, double scale)
      : ring(outline.points.data(), outline.corners.size(), 1),
        pose_(pose),
        shift_(shift),
        scale_(scale),
        mirrored_(pose.linear().determinant() < 0) {}

  DoubleDouble2 at(std::uint32_t k) const {
    const Double2 p = ring.vertex(k) * scale_;
    const DoubleDouble2 turned = linear({{p[0], 0}, {p[1], 0}});
    return {turned.x + shift_.x, turned.y + shift_.y};
  }
  /// Outwards from edge k, as long as that. The difference is taken where it is exact, so that a short edge's direction
  /// is as precise as a long one's.
  DoubleDouble2 normalOf(std::uint32_t k) const {
    const Double2 p = ring.vertex(k) * scale_, q = ring.vertex(ring.next(k)) * scale_;
    const DoubleDouble2 edge = linear({twoSum(q[0], -p[0]), twoSum(q[1], -p[1])});
    return mirrored_ ? DoubleDouble2{-edge.y, edge.x} : DoubleDouble2{edge.y, -edge.x};
  }

  const ConvexRing ring;  ///< counter-clockwise

 private:
  DoubleDouble2 linear(const DoubleDouble2& p) const {
    const auto& m = pose_.matrix();
    const auto row = [&](int r) { return DoubleDouble{m(r, 0), 0} * p.x + DoubleDouble{m(r, 1), 0} * p.y; };
    return {row(0), row(1)};
  }

  const Pose& pose_;
  DoubleDouble2 shift_;
  double scale_;
  bool mirrored_;
};

/// The gap behind a face of one of them. Along a convex outline heights fall and rise once each: the way to the deepest
/// corner leads from corner `at` on down.
SupportGap gapBehind(const Corners& own, const Corners& other, bool of_a, std::uint32_t face, std::uint32_t at,
                     bool certain) {
  const DoubleDouble2 normal = own.normalOf(face);
  const ConvexRing& ring = other.ring;
  const auto isDeeper = [&](std::uint32_t j, std::uint32_t i) {
    return dot(normal, other.at(j) - other.at(i)).high < 0;
  };
  std::uint32_t steps = certain ? ring.size() : 0;
  for (; steps < ring.size() && isDeeper(ring.next(at), at); ++steps) at = ring.next(at);
  for (; steps < ring.size() && isDeeper(ring.previous(at), at); ++steps) at = ring.previous(at);
  const double length = std::hypot(normal.x.high, normal.y.high);
  const double depth = std::max(0.0, dot(normal, own.at(face) - other.at(at)).high / length);
  // Of short edges among huge ones the normal may be one of the smallest doubles, and its length hardly known.
  const double larger = std::max(std::abs(normal.x.high), std::abs(normal.y.high));
  const Vec2 outwards = larger > 0 ? Vec2(normal.x.high / larger, normal.y.high / larger).normalized() : Vec2(1, 0);
  return {length > 0 ? depth : std::numeric_limits<double>::infinity(), of_a ? outwards : Vec2(-outwards), of_a, face,
          at};
}

/// Of all faces that may be the least by plain doubles, or of all if these don't tell.
std::vector<SupportGap> leastGaps(const SeparatingAxes* axes, const Corners& a, const Corners& b) {
  std::vector<SupportGap> gaps;
  if (axes != nullptr && axes->verdict() == SeparatingAxes::Meet) {
    for (const FaceDepth& f : *axes)
      gaps.push_back(gapBehind(f.of_a ? a : b, f.of_a ? b : a, f.of_a, f.edge, f.deepest, f.certain));
    return gaps;
  }
  for (const bool of_a : {true, false}) {
    const Corners &own = of_a ? a : b, &other = of_a ? b : a;
    std::uint32_t at = 0;
    for (std::uint32_t k = 0; k < own.ring.size() && own.ring.size() > 1; ++k) {
      gaps.push_back(gapBehind(own, other, of_a, k, at, false));
      at = gaps.back().corner;
    }
  }
  return gaps;
}

}  // namespace

SupportGap leastSupportGap(const PosedPair& pair, const SeparatingAxes* axes, double tie) {
  const Pose &pose_a = pair.pose_a, &pose_b = pair.pose_b;
  const Vec2 ta = pose_a.translation(), tb = pose_b.translation();
  const double largest =
      std::max({pair.a.extent, pair.b.extent, ta.lpNorm<Eigen::Infinity>(), tb.lpNorm<Eigen::Infinity>()});
  const int exponent = largest > 0 ? std::clamp(std::ilogb(largest), -1000, 1000) : 0;
  const double scale = std::ldexp(1, -exponent);
  const DoubleDouble2 shift{twoSum(tb.x() * scale, -ta.x() * scale), twoSum(tb.y() * scale, -ta.y() * scale)};
  const Corners a(convexOutlineOf(pair.a), pose_a, {}, scale), b(convexOutlineOf(pair.b), pose_b, shift, scale);
  const std::vector<SupportGap> gaps = leastGaps(axes, a, b);
  if (gaps.empty()) return {0, Vec2(1, 0), true, 0, 0};  // two points, which any translation parts
  double least = std::numeric_limits<double>::infinity();
  for (const SupportGap& gap : gaps) least = std::min(least, gap.depth);
  const Vec2 towards_b = pose_b.linear() * (pair.b.origin * scale) - pose_a.linear() * (pair.a.origin * scale) +
                         Vec2(shift.x.high, shift.y.high);
  const auto along = [&](const SupportGap& gap) { return gap.normal.dot(towards_b); };
  const SupportGap* best = nullptr;
  for (const SupportGap& gap : gaps)
    if (gap.depth <= least + tie * scale && (best == nullptr || along(gap) > along(*best))) best = &gap;
  SupportGap result = *best;
  result.depth /= scale;
  return result;
}

}  // namespace tricover::detail
