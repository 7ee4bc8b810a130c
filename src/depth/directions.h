// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/segment.h"

namespace tricover::detail {

/// Directions, as long as some direction has a positive component along each of them.
class OneSidedDirections {
 public:
  /// Adds a direction of any length but 0.
  void add(const Vec2& direction) {
    if (is_empty_) {
      first_ = last_ = direction;
      is_empty_ = false;
      return;
    }
    const double after_first = cross(first_, direction), before_last = cross(direction, last_);
    if (after_first >= 0 && before_last >= 0 && (after_first > 0 || first_.dot(direction) > 0)) return;
    if (after_first > 0)
      last_ = direction;
    else if (before_last > 0)
      first_ = direction;
    else
      are_one_sided_ = are_one_sided_ && first_.dot(direction) > 0 && last_.dot(direction) > 0;
    // All of them are between the first and the last one, counter-clockwise, by clearly less than half a turn.
    const double sine = cross(first_, last_), cosine = first_.dot(last_);
    if (!(sine > -0x1p-40 * std::abs(cosine)) || (cosine < 0 && sine < -0x1p-20 * cosine)) are_one_sided_ = false;
  }

  bool areOneSided() const { return are_one_sided_; }

 private:
  Vec2 first_, last_;
  bool is_empty_ = true, are_one_sided_ = true;
};

}  // namespace tricover::detail
