// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/simd.h"
#include "pair/posed_pair.h"
#include "tricover/collide_options.h"

namespace tricover::detail {

/// Whether an edge of a and one of b (positions in the paths) are as near as the options ask.
struct EdgeTest {
  EdgeTest(const PosedPair& pair_, const CollideOptions& options_)
      : pair(pair_), a(pair.a), b(pair.b), options(options_) {}
  EdgeTest(const EdgeTest&) = delete;

  bool operator()(EdgePosition i, EdgePosition j) const {
    return edgesWithin(pair, i, j, options.margin, options.tolerance, options.touching == Touching::Allowed);
  }

  /// As descents call it; the second one where b is the degenerate polygon.
  static bool meet(const void* context, EdgePosition i, EdgePosition j) {
    return (*static_cast<const EdgeTest*>(context))(i, j);
  }
  static bool meetDegenerate(const void* context, EdgePosition i) {
    return meet(context, i, static_cast<const EdgeTest*>(context)->b.degenerate_edge);
  }

  const PosedPair& pair;
  const PolygonData &a, &b;
  const CollideOptions& options;
};

}  // namespace tricover::detail
