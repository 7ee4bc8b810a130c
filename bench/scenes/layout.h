// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "placed.h"

namespace tricover::bench {

/// Parts of a dozen kinds, each of `least` to `most` vertices but at least its kind's 5 to 8, laid by bottom-left fill
/// into a strip about as long as it is high: the largest first, each of some turns as far left as it goes, then as low.
/// No two of them collide. Equal arguments give equal layouts wherever <cmath> agrees.
Placement makeLayout(std::size_t parts, int least, int most, std::uint64_t seed);

enum class Placing {
  Free,       ///< Close to the part's own place, and free.
  Local,      ///< Around its own place, by a tenth of its size and a few degrees.
  LocalWide,  ///< By half of its size.
  Uniform     ///< Anywhere in the layout, turned anyhow.
};

/// A part that was taken out of a layout.
struct Lifted {
  std::size_t index;
  Placed part;
  Placement others;
};
Lifted lifted(const Placement& layout, std::size_t index);

/// Eight from all over it, one at a time.
std::vector<Lifted> liftedParts(const Placement& layout);

/// Poses for it; that many in the studies.
constexpr std::size_t kPlacings = 125;
std::vector<Pose> placings(const Lifted& lifted, Placing placing, std::size_t count, std::uint64_t seed);

/// Writes layout.svg: a part among the others, placed anew. Colours are the scene's answers.
void drawLayout(const std::string& directory);

}  // namespace tricover::bench
