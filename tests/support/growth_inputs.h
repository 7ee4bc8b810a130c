// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "tricover/motion.h"
#include "tricover/polygon.h"

/// Inputs whose cost once grew faster than they do, as functions of their size.
namespace tricover::growth {

/// Two polygons: a at the identity, b at motion.start or moving.
struct Input {
  Polygon a, b;
  Motion motion;
};

/// Two fans of n edges through one point each, which face each other: b's point comes past a's obliquely, beside it by
/// `gap`, while b turns by `angle`. All edges of one come about as near to those of the other. With a gap below 0, the
/// two meet.
Input passingFans(std::size_t n, double gap, double angle);

/// Two spirals of n edges wound into each other, a gap of 1 between them, with 64 edges to each turn, however large:
/// outer edges lie beside many turns. b moves by nine tenths of what it may.
Input coarseSpirals(std::size_t n);

/// Every kind by its name, for tables.
struct Kind {
  const char* name;
  Input (*make)(std::size_t n);
};
const std::vector<Kind>& allKinds();

}  // namespace tricover::growth
