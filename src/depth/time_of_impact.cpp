// SPDX-License-Identifier: BSD-3-Clause
// timeOfImpact() of motions: by the kernel of margins from 0 on, or by depth.
#include "tricover/time_of_impact.h"

#include <optional>
#include <utility>

#include "depth/conflicts.h"
#include "impact/impact_options.h"
#include "impact/impact_solvers.h"
#include "pair/kernel_order.h"

namespace tricover {
namespace detail {
namespace {

/// With a negative margin.
[[gnu::cold, gnu::noinline]] std::optional<Impact> deepImpact(const Polygon& a, const Motion& motion_a,
                                                              const Polygon& b, const Motion& motion_b,
                                                              const ImpactOptions& options) {
  if (inOrder(detail::dataOf(a), motion_a, detail::dataOf(b), motion_b))
    return MovingContact(a, motion_a, b, motion_b, options).deepImpact();
  std::optional<Impact> impact = MovingContact(b, motion_b, a, motion_a, options).deepImpact();
  swapOperands(impact);
  return impact;
}

}  // namespace
}  // namespace detail

std::optional<Impact> timeOfImpact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                                   const ImpactOptions& options) {
  detail::checkOptions(options);
  detail::checkMotions(motion_a, motion_b);
  auto first = options.margin < 0 ? detail::deepImpact(a, motion_a, b, motion_b, options)
                                  : detail::impactOf(a, motion_a, b, motion_b, options);
  if (!options.ignore_initial || !first) return first;
  detail::MovingContact contact(a, motion_a, b, motion_b, options);
  if (!contact.touchAt(0)) return first;
  const auto end = contact.endOfContact(0);
  if (end.is_known) return contact.next(end.time);
  // Whether the first contact lasts is unknown.
  first->time = end.time;
  first->budget_ended = true;
  return first;
}

}  // namespace tricover
