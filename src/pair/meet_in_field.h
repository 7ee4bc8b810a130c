// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/influence_field.h"
#include "hierarchy/simd.h"
#include "pair/edge_test.h"

namespace tricover::detail {

/// Whether b, which is small beside a and has few edges, meets a: by a's edges in the cells that b's box comes near.
/// `limit` is that of gaps that matter, in a's units. Unknown of other bodies.
Meeting meetInField(const InfluenceField& field, const UnitMap& at, double limit, const EdgeTest& test);

}  // namespace tricover::detail
