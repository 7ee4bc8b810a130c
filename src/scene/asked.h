// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/find_fact.h"
#include "pair/interiors.h"
#include "scene/scene_state.h"

namespace tricover::detail {

/// Returns defectOf() the pose.
inline double checkAsked(const Pose& pose, const CollideOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  requireFiniteNotNegative(options.tolerance, "tolerance");
  requireTouching(options.touching);
  return requireRigid(pose, "pose");
}

/// A posed polygon that bodies are asked about: whether they collide with it.
class Asked {
  /// So many vertices cost no more than the bodies that a wider box meets.
  static constexpr std::size_t kFew = 17;
  /// And the box of many is that of their disc until so many bodies have been met.
  static constexpr int kSparse = 2;

 public:
  /// `defect` is checkAsked()'s.
  Asked(const SceneState& state, const PolygonData& polygon, const Pose& pose, double defect,
        const CollideOptions& options)
      : state_(state),
        polygon_(polygon),
        pose_(pose),
        options_(options),
        discs_(polygon, pose, defect),
        has_few_(polygon.path.size() <= kFew),
        has_own_box_(has_few_),
        bounds_(has_few_ ? boundsOf(polygon, pose, options.margin)
                         : boundsOfDisc(discs_.center, discs_.radius, options.margin)) {}

  /// Whether a body is near whose box the tree shows. Where bodies are many, the polygon's own box leaves more of them
  /// out than its disc's.
  bool isNear(const SceneState::BodyState& body, const Bounds& box) const {
    if (!has_few_ && (has_own_box_ || ++shown_ > kSparse) && !box.meets(bounds())) return false;
    return !body.clear.holds(bounds_);
  }

  /// Whether inner discs meet.
  bool meetsInside(const SceneState::BodyState& body) const {
    WorldDiscs found;
    const WorldDiscs& discs = body.discs.of(body.polygon.data(), body.pose, found);
    const double margin = marginSum(options_.margin, body.options.margin);
    if (!isWithin(discs.inner - discs_.inner, discs_.inner_radius + discs.inner_radius + margin)) return false;
    // Points and segments have discs without an interior.
    const bool are_open = discs_.inner_radius > 0 && discs.inner_radius > 0;
    return are_open || !asksForInteriors(sumWith(body));
  }

  /// The less, the likelier the body meets: by the area that both boxes share. (By the way between inner discs, which
  /// have told of the deepest overlaps already, parts that aren't convex need up to a third more looks.)
  double rank(const Bounds& box) const {
    const double x = std::min(box.max_x, bounds_.max_x) - std::max(box.min_x, bounds_.min_x);
    const double y = std::min(box.max_y, bounds_.max_y) - std::max(box.min_y, bounds_.min_y);
    return 1 / (x * y);
  }

  /// The truth, where discs don't know it, of a body that is near.
  bool meetsClose(Slot slot) const {
    const SceneState::BodyState& body = state_.bodies[slot];
    const PolygonData& polygon = body.polygon.data();
    // It may have been near to the disc's box alone.
    if (!has_few_ && (!state_.tree.boundsOf(slot).meets(bounds()) || body.clear.holds(bounds_))) return false;
    WorldDiscs found;
    const WorldDiscs& discs = body.discs.of(polygon, body.pose, found);
    const CollideOptions sum = sumWith(body);
    if (isBeyond(discs.center - discs_.center, discs_.radius + discs.radius + sum.margin)) return false;
    if (collideClose(discs_.of(polygon_, pose_), discs.of(polygon, body.pose), mayHold(slot, polygon, discs), sum))
      return true;
    // Of what isn't large beside the polygon nothing is learned.
    if (discs.radius > discs_.radius && body.clear.mayLearn() && sum.touching == Touching::Collides)
      body.clear.learn(polygon, body.pose, body.options.margin, state_.tree.boundsOf(slot), bounds_);
    return false;
  }

  /// The truth of any body that is near.
  bool meets(Slot slot) const { return meetsInside(state_.bodies[slot]) || meetsClose(slot); }

  /// Around all that is within the margin: found by the first body that is near, or in any case where vertices are few.
  const Bounds& bounds() const {
    if (!has_own_box_) bounds_ = boundsOf(polygon_, pose_, options_.margin);
    has_own_box_ = true;
    return bounds_;
  }
  /// The same for the tree: the bounding disc's, until it is found.
  const Bounds& surroundings() const { return bounds_; }

 private:
  /// Whether one region may lie in the other. Few edges are asked at once, and need not know.
  bool mayHold(Slot slot, const PolygonData& polygon, const WorldDiscs& discs) const {
    if ((has_few_ && polygon.path.size() <= kFew) || polygon.ringCount() + polygon_.ringCount() > 2) return true;
    return discs_.mayBeIn(state_.tree.boundsOf(slot)) || discs.mayBeIn(bounds());
  }

  CollideOptions sumWith(const SceneState::BodyState& body) const { return withBody(options_, body.options); }

  const SceneState& state_;
  const PolygonData& polygon_;
  const Pose& pose_;
  const CollideOptions& options_;
  const WorldDiscs discs_;
  const bool has_few_;
  mutable bool has_own_box_;
  mutable int shown_ = 0;
  mutable Bounds bounds_;
};

/// A body that collides; kNoSlot if none does.
Slot findMet(const SceneState& state, const Asked& asked, const SlotFilter& filter);

}  // namespace tricover::detail
