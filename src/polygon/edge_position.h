// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace tricover::detail {

/// An edge of a polygon: where it begins in PolygonData::path.
using EdgePosition = std::uint32_t;

inline constexpr EdgePosition kNoEdge = ~EdgePosition{0};

}  // namespace tricover::detail
