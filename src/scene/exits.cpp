// SPDX-License-Identifier: BSD-3-Clause
// When bodies together stop covering a moving polygon.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "depth/exit.h"
#include "numbers/errors.h"
#include "scene/sweep.h"

namespace tricover {
namespace detail {
namespace {

std::optional<Impact> firstExitOn(const std::vector<Leg>& legs, const Polygon& polygon, const CoverOptions& options,
                                  const SceneState& state, const BodyFilter& filter) {
  requireFiniteMargin(options.margin, "margin");
  const SlotFilter selected = state.slots(filter);
  for (const Leg& leg : legs) {
    std::vector<StillArea> areas;
    state.tree.visit(SweptLeg(polygon, leg, std::abs(options.margin)).between(0, 1), [&](Slot slot) {
      const auto& body = state.bodies[slot];
      if (!state.passes(selected, slot)) return true;
      if (body.options.margin != 0)
        refuse("body " + std::to_string(slot), "it has a margin, which firstExit() can't inflate exactly",
               "leave it out by the filter, or add it without a margin");
      areas.push_back({detail::dataOf(body.polygon), body.pose});
      return true;
    });
    std::optional<Impact> exit = firstExit(polygon, leg.motion, areas, options.margin);
    if (!exit) continue;
    exit->time = leg.begin + (leg.end - leg.begin) * exit->time;
    return exit;
  }
  return std::nullopt;
}

std::optional<Exit> exitOf(const std::optional<Impact>& found) {
  return found ? std::optional<Exit>(Exit{found->time, found->point, found->budget_ended}) : std::nullopt;
}

}  // namespace
}  // namespace detail

std::optional<Exit> Scene::firstExit(const Polygon& polygon, const Motion& motion, const CoverOptions& options,
                                     const BodyFilter& filter) const {
  checkMotion(motion);
  return detail::exitOf(detail::firstExitOn(detail::legsOf(motion), polygon, options, impl_->settled(), filter));
}

std::optional<Exit> Scene::firstExit(const Polygon& polygon, const Trajectory& trajectory, const CoverOptions& options,
                                     const BodyFilter& filter) const {
  return detail::exitOf(detail::firstExitOn(trajectory.legs(), polygon, options, impl_->settled(), filter));
}

}  // namespace tricover
