// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "polygon/polygon_data.h"
#include "tricover/motion.h"
#include "tricover/time_of_impact.h"

namespace tricover::detail {

/// An area of a union, and where it rests.
struct StillArea {
  const PolygonData& polygon;
  const Pose& pose;
};

/// The first time at which the union of some areas doesn't cover a moving part, inflated by a margin or allowed to
/// stick out by a negative one. Time runs from 0 to 1. The impact's normal leads back; its edges are -1.
std::optional<Impact> firstExit(const Polygon& part, const Motion& motion, const std::vector<StillArea>& areas,
                                double margin);

}  // namespace tricover::detail
