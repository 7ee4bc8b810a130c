// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "penetration/translation_space.h"

namespace tricover::detail {

/// The result of a search, in the space's units.
struct ShortestParting {
  Vec2 limit;          ///< the end of the shortest translation: free translations come as near to it as one likes
  Vec2 parting;        ///< a free one near it
  double lower_bound;  ///< no shorter translation parts the regions by more than a slit of the search's resolution
  TranslationSpace::NearestSegment nearest = {};  ///< to the limit; of a search alone
};

/// Searches best first over square cells of translations, from `known`, which is free. `last` (or null) is a
/// translation that may be free and shorter. After `most` translations the search ends, and lower_bound is that of the
/// cells left.
ShortestParting searchShortestParting(TranslationSpace& space, const Vec2& known, const Vec2* last, std::size_t most);

}  // namespace tricover::detail
