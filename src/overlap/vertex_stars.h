// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "pair/posed_pair.h"

namespace tricover::detail {

/// Points where several vertices of either polygon meet. All edges that end at such a point meet there in pairs; to
/// know them together, those pairs are enough that one edge of either polygon has with all of the other's.
class VertexStars {
 public:
  explicit VertexStars(const PosedPair& pair);

  /// Whether these edges meet in one such point only, and the pairs of others tell. Otherwise nothing is said.
  bool isKnown(std::size_t i, std::size_t j);

 private:
  enum State : char { New, Apart, Met };
  struct Star {
    State state = New;
    std::size_t edge_a = 0, edge_b = 0;  ///< those whose pairs count
  };

  const PosedPair& pair_;
  std::vector<std::uint32_t> place_a_, place_b_;  ///< by position: equal for equal vertices
  std::unordered_map<std::uint64_t, Star> stars_;
};

}  // namespace tricover::detail
