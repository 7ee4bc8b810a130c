// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace tricover::detail {

/// How far a march has come: nothing happens before `time`.
struct Reached {
  double time;
  bool is_known;  ///< whether it is known what happens then, and the march ends

  bool isOpen() const { return !is_known; }
};

/// A march in time: step(time) proves until when nothing happens, if nothing does before `time`. Nothing is proven by
/// std::nullopt, which ends the march, as does a step that isn't open. Returns what `most` steps reach. `Known` is
/// Reached or a type like it.
template <typename Known, typename Step>
Known march(Known reached, int most, Step step) {
  for (int i = 0; i < most && reached.isOpen(); ++i) {
    const std::optional<Known> next = step(reached.time);
    if (!next) break;
    reached = *next;
  }
  return reached;
}

}  // namespace tricover::detail
