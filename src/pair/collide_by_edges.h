// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "hierarchy/hierarchy.h"
#include "pair/edge_test.h"
#include "pair/outcome.h"

namespace tricover::detail {

/// The answer by the edges alone, of polygons that have been asked too seldom for a hierarchy each: O(n + m) but where
/// many edges are near each other. Leaves clearance 0. Nothing where hierarchies have been paid for, where they cost
/// less than this query alone, or coordinates may overflow.
std::optional<Outcome> collideByEdges(const EdgeTest& test);

/// Whether both polygons have the hierarchies that are asked, a point's being none, so that there is no need for the
/// above.
inline bool haveHierarchies(const PolygonData& a, const PolygonData& b) {
  return topIfBuilt(a) != nullptr && (b.isPoint() || topIfBuilt(b) != nullptr);
}

}  // namespace tricover::detail
