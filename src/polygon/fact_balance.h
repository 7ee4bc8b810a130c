// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "tricover/pair_cache.h"

namespace tricover::detail {

/// FactBalance counts in quarters of what a query costs that does without the cache.
constexpr int kQuery = 4;
/// The most that facts may have saved in advance; whoever has that counts as new again.
constexpr int kMostSaved = FactBalance().saved;
/// So many queries do without facts when these have cost more than they saved for the first, second, third time in a
/// row, and from then on.
constexpr std::uint8_t kRests[] = {3, 15, 63, 255}, kMostFailed = 3;

/// Counts what facts have saved or cost; false if they are to rest, because they have cost more lately.
inline bool isWorthIt(FactBalance& balance, int saved) {
  const int sum = std::min(balance.saved + saved, kMostSaved);
  balance.saved = static_cast<std::int8_t>(std::max(sum, 0));
  if (sum == kMostSaved) balance.failed = 0;
  if (sum >= 0) return true;
  balance.resting = kRests[balance.failed];
  balance.failed = std::min<std::uint8_t>(balance.failed + 1, kMostFailed);
  return false;
}

}  // namespace tricover::detail
