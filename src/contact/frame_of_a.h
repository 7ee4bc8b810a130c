// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair/posed_pair.h"

namespace tricover::detail {

/// a's own frame, to be used as a WorldFrame is, in a's lengths: no map but that of b's vertices, where a's pose keeps
/// lengths to a few of their last digits.
class FrameOfA {
 public:
  static bool fits(const PosedPair& pair) {
    return pair.scale_defect < 0x1p-46 && squarable(pair.a.extent) && squarable(pair.b.extent);
  }

  explicit FrameOfA(const PosedPair& pair)
      : pair_(pair), size_(pair.a.extent + pair.error / kMappingError), error_(kMappingError * size_) {}

  static Vec2 fromA(const Vec2& local) { return local; }
  Vec2 fromB(const Vec2& local) const {
    const ApproxPoint p = pair_.fromB(local);
    return {p.x, p.y};
  }
  Vec2 toWorld(const Vec2& p) const { return pair_.pose_a * p; }
  Vec2 directionToWorld(const Vec2& d) const { return pair_.pose_a.linear() * d; }

  static double unit() { return 1; }
  /// At least kMappingError of size(), and what a vertex is off by.
  double error() const { return error_; }
  /// At least any coordinate of a vertex.
  double size() const { return size_; }
  /// a's origin from b's.
  Vec2 originOfA() const { return pair_.a.origin - Vec2(pair_.center_x, pair_.center_y); }

 private:
  const PosedPair& pair_;
  double size_, error_;
};

}  // namespace tricover::detail
