// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "hierarchy/placement.h"
#include "hierarchy/simd.h"
#include "pair/posed_pair.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// Whether an edge of a and one of b (positions in the paths) are as near as the options ask. The first one that is
/// asked composes the relative pose.
class EdgeTest {
 public:
  EdgeTest(const Placement& pair, const CollideOptions& options_)
      : a(pair.a), b(pair.b), options(options_), pose_a_(pair.pose_a), pose_b_(pair.pose_b) {}
  EdgeTest(const PosedPair& pair, const CollideOptions& options_)
      : a(pair.a), b(pair.b), options(options_), pose_a_(pair.pose_a), pose_b_(pair.pose_b), pair_(&pair) {}
  EdgeTest(const EdgeTest&) = delete;

  const PosedPair& pair() const {
    if (pair_ == nullptr) pair_ = &composed_.emplace(a, pose_a_, b, pose_b_);
    return *pair_;
  }

  bool operator()(std::size_t i, std::size_t j) const {
    return edgesWithin(pair(), i, j, options.margin, options.tolerance, options.touching == Touching::Allowed);
  }

  /// As descents call it; the second one where b is the degenerate polygon.
  static bool meet(const void* context, std::size_t i, std::size_t j) {
    return (*static_cast<const EdgeTest*>(context))(i, j);
  }
  static bool meetDegenerate(const void* context, std::size_t i) {
    return meet(context, i, static_cast<const EdgeTest*>(context)->b.degenerate_edge);
  }

  const PolygonData &a, &b;
  const CollideOptions& options;

 private:
  const Pose &pose_a_, &pose_b_;
  mutable const PosedPair* pair_ = nullptr;
  mutable std::optional<PosedPair> composed_;
};

}  // namespace tricover::detail
