// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/conflicts.h"

namespace tricover::detail {

/// What two polygons that move make of time: how long they meet from one moment on, and when they do again.
class MovingContact {
 public:
  /// Of arguments that have been checked; `options` are for time from 0 to 1.
  MovingContact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                const ImpactOptions& options);

  struct End {
    double time;    ///< until which all steps met; by half of time_error too late at most
    bool is_known;  ///< false if the steps ended before the contact did
  };
  /// When they are apart again that met, or were about to, at `begin`; 1 if they meet until then.
  End endOfContact(double begin);

  /// The first contact from `begin` on, where they are apart unless it is 0.
  std::optional<Impact> next(double begin) const;

 private:
  bool meetAt(double time, double margin) const;
  bool meetUntil(double time, double step) const;

  const Polygon &a_, &b_;
  const Motion &motion_a_, &motion_b_;
  const double margin_, seen_;  ///< begins are told so much too early, and ends so much too late, at most
  int steps_left_ = 1 << 21;    ///< of endOfContact(), for all contacts together
  double speed_;                ///< no point of one moves faster against the other one
};

/// Leaves out the conflict that begins with the motion, unless a budget ended within it: then what follows is unknown.
inline void leaveOutInitial(std::vector<Conflict>& conflicts, double begin) {
  if (conflicts.empty() || conflicts.front().impact.time != begin || conflicts.front().budget_ended) return;
  conflicts.erase(conflicts.begin());
}

}  // namespace tricover::detail
