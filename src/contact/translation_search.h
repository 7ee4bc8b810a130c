// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "contact/translation_space.h"
#include "tricover/penetration.h"

namespace tricover::detail {

/// What a search found, in the space's units.
struct ShortestParting {
  Vec2 limit;               ///< the end of the shortest translation: free translations come as near to it as one likes
  Vec2 parting;             ///< a free one near it
  double lower_bound;       ///< no shorter translation parts the regions by more than a slit of the search's resolution
  std::uint32_t looks = 0;  ///< cells that had to be looked at
};

/// Best first over square cells of translations, from one that is known to be free. Stops where the limit is longer
/// than lower_bound by no more than `error` of it, and after `most` translations; lower_bound is then that of the cells
/// left.
///
/// hints: null, or what a cache keeps of searches.
ShortestParting searchShortestParting(TranslationSpace& space, const Vec2& known, double error, std::size_t most,
                                      SearchHints* hints);

}  // namespace tricover::detail
