// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/find_fact.h"
#include "scene/scene_state.h"

namespace tricover::detail {

inline void checkAsked(const Pose& pose, const CollideOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  requireFiniteNotNegative(options.tolerance, "tolerance");
  requireRigid(pose, "pose");
}

/// A posed polygon that bodies are asked about: whether they collide with it.
class Asked {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  /// So many vertices cost no more than the bodies that a wider box meets.
  static constexpr std::size_t kFew = 17;

 public:
  Asked(const PolygonData& polygon, const Pose& pose, const CollideOptions& options)
      : polygon_(polygon),
        pose_(pose),
        options_(options),
        discs_(polygon, pose),
        is_close_(polygon.path.size() <= kFew),
        bounds_(is_close_ ? boundsOf(polygon, pose, options.margin)
                          : boundsOfDisc(discs_.center, discs_.radius, options.margin)) {}

  /// What discs know, and how far those inside are apart for their size: the less, the likelier the bodies meet.
  struct Glance {
    enum { Apart, Near, Meets } answer;
    double rank;
  };
  Glance glance(const SceneState::BodyState& body) const {
    WorldDiscs found;
    const WorldDiscs& discs = body.discs.of(body.polygon.data(), body.pose, found);
    const double margin = sumWith(body).margin;
    if (areApart(discs_, discs, margin)) return {Glance::Apart, 0};
    if (areWithin(discs_, discs, margin)) return {Glance::Meets, 0};
    const double within = discs_.inner_radius + discs.inner_radius;
    const double rank = squaredLength(discs.inner - discs_.inner) / (within * within);
    return {Glance::Near, within > 0 ? rank : kInfinity};
  }

  /// The truth, where discs don't know it, of a body whose box this is.
  bool meetsClose(const SceneState::BodyState& body, const Bounds& box) const {
    if (!box.meets(bounds()) || body.clear.holds(bounds_)) return false;
    if (collideClose(polygon_, pose_, body.polygon.data(), body.pose, sumWith(body))) return true;
    body.clear.learn(body.polygon.data(), body.pose, body.options.margin, box, bounds_);
    return false;
  }

  bool meets(const SceneState::BodyState& body, const Bounds& box) const {
    const auto answer = glance(body).answer;
    return answer == Glance::Near ? meetsClose(body, box) : answer == Glance::Meets;
  }

  /// Around all that is within the margin: found by the first body that is near, or in any case where vertices are few.
  const Bounds& bounds() const {
    if (!is_close_) bounds_ = boundsOf(polygon_, pose_, options_.margin);
    is_close_ = true;
    return bounds_;
  }
  /// The same for the tree: the bounding disc's, until it is found.
  const Bounds& surroundings() const { return bounds_; }

 private:
  CollideOptions sumWith(const SceneState::BodyState& body) const { return withMargin(options_, body.options.margin); }

  const PolygonData& polygon_;
  const Pose& pose_;
  const CollideOptions& options_;
  const WorldDiscs discs_;
  mutable bool is_close_;
  mutable Bounds bounds_;
};

/// A body that collides; kNoBody if none does.
BodyHandle findMet(const SceneState& state, const Asked& asked, const BodyFilter& filter);

}  // namespace tricover::detail
