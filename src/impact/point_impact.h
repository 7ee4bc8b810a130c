// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "impact/moving_pair.h"

namespace tricover::detail {

/// A point b, a disc by the margin, and the edge of a that it comes to first.
struct PointImpact {
  double time;
  std::size_t edge;  ///< position in a's path
};

/// Whether findPointImpact() may be asked: a's frame must keep lengths but for rounding.
bool isPointCast(const MovingPair& pair);

/// The first time at which the point b is within the margin of an edge of a, or nothing: never late, and at most
/// `time_error` early, but for rounding. They are apart at time 0.
std::optional<PointImpact> findPointImpact(const MovingPair& pair, double time_error);

}  // namespace tricover::detail
