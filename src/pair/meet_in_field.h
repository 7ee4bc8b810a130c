// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/influence_field.h"
#include "hierarchy/simd.h"
#include "pair/edge_test.h"
#include "pair/outcome.h"

namespace tricover::detail {

/// What a's field tells of b, which is small beside a, after gapInField(): at the discs in b, and, of few edges, by a's
/// edges in the cells that b's box comes near. Lengths are in a's units, as meetAtOnce()'s.
Meeting meetInField(const InfluenceField& field, const UnitMap& at, double limit, Wanted wanted, const EdgeTest& test,
                    Outcome& outcome);

}  // namespace tricover::detail
