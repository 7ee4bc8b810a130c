// SPDX-License-Identifier: BSD-3-Clause
// Whether bodies together cover a polygon.
#include "tricover/covers.h"

#include <cmath>
#include <string>
#include <vector>

#include "depth/excess.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "scene/scene_state.h"

namespace tricover {

bool Scene::covers(const Polygon& polygon, const Pose& pose, const CoverOptions& options,
                   const BodyFilter& filter) const {
  const detail::SceneState& state = impl_->settled();
  const detail::SlotFilter selected = state.slots(filter);
  detail::requireFiniteMargin(options.margin, "margin");
  detail::requireRigid(pose, "pose");
  std::vector<detail::PosedPair> near;
  const detail::Bounds bounds = boundsOf(detail::dataOf(polygon), pose, std::abs(options.margin));
  state.tree.visit(bounds, [&](detail::Slot slot) {
    const auto& body = state.bodies[slot];
    if (!state.passes(selected, slot)) return true;
    if (body.options.margin != 0)
      detail::refuse("body " + std::to_string(slot), "it has a margin, which covers() can't inflate exactly",
                     "leave it out by the filter, or add it without a margin");
    near.emplace_back(detail::dataOf(polygon), pose, detail::dataOf(body.polygon), body.pose);
    return true;
  });
  return detail::unionCoversBut(near, options.margin);
}

}  // namespace tricover
