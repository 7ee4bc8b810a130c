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

 public:
  Asked(const PolygonData& polygon, const Pose& pose, const CollideOptions& options)
      : polygon_(polygon),
        pose_(pose),
        options_(options),
        discs_(polygon, pose),
        bounds_(boundsOf(polygon, pose, options.margin)) {}

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
    if (body.clear.holds(bounds_)) return false;
    if (collideClose(polygon_, pose_, body.polygon.data(), body.pose, sumWith(body))) return true;
    body.clear.learn(body.polygon.data(), body.pose, body.options.margin, box, bounds_);
    return false;
  }

  bool meets(const SceneState::BodyState& body, const Bounds& box) const {
    const auto answer = glance(body).answer;
    return answer == Glance::Near ? meetsClose(body, box) : answer == Glance::Meets;
  }

  /// Around all that is within the margin.
  const Bounds& bounds() const { return bounds_; }

 private:
  CollideOptions sumWith(const SceneState::BodyState& body) const { return withMargin(options_, body.options.margin); }

  const PolygonData& polygon_;
  const Pose& pose_;
  const CollideOptions& options_;
  const WorldDiscs discs_;
  const Bounds bounds_;
};

/// A body that collides; kNoBody if none does.
BodyHandle findMet(const SceneState& state, const Asked& asked, const BodyFilter& filter);

}  // namespace tricover::detail
