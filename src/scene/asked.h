// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

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
  /// So many vertices are asked for the box at once.
  static constexpr std::size_t kFew = 2 * kLanes + 1;

 public:
  Asked(const PolygonData& polygon, const Pose& pose, const CollideOptions& options)
      : polygon_(polygon), pose_(pose), options_(options), discs_(polygon, pose) {}

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

  /// The truth, where discs don't know it, of a body in this box.
  bool meetsClose(const SceneState::BodyState& body, const Bounds& box) const {
    if (!box.meets(bounds()) || body.clear.holds(bounds())) return false;
    if (collideClose(polygon_, pose_, body.polygon.data(), body.pose, sumWith(body))) return true;
    body.clear.learn(body.polygon.data(), body.pose, body.options.margin, box, bounds());
    return false;
  }

  bool meets(const SceneState::BodyState& body, const Bounds& box) const {
    const auto answer = glance(body).answer;
    return answer == Glance::Near ? meetsClose(body, box) : answer == Glance::Meets;
  }

  const Bounds& bounds() const {
    if (!bounds_) bounds_ = boundsOf(polygon_, pose_, options_.margin);
    return *bounds_;
  }

  /// Wider, unless few vertices tell, and sooner there: around the bounding disc. In units of U, of the centre and the
  /// reach: either side's sum and difference, and the margin's sum with a body's.
  Bounds quickBounds() const {
    if (polygon_.path.size() <= kFew) return bounds();
    const double x = discs_.center[0], y = discs_.center[1], reach = discs_.radius + options_.margin;
    const double wide = reach + 8 * kUnitRoundoff * (std::abs(x) + std::abs(y) + reach);
    const Bounds box{x - wide, y - wide, x + wide, y + wide};
    // Negated for NaN.
    return !(wide < kInfinity && std::abs(x) < kInfinity && std::abs(y) < kInfinity) ? bounds() : box;
  }

 private:
  CollideOptions sumWith(const SceneState::BodyState& body) const { return withMargin(options_, body.options.margin); }

  const PolygonData& polygon_;
  const Pose& pose_;
  const CollideOptions& options_;
  const WorldDiscs discs_;
  mutable std::optional<Bounds> bounds_;
};

/// A body that collides; kNoBody if none does.
BodyHandle findMet(const SceneState& state, const Asked& asked, const BodyFilter& filter);

}  // namespace tricover::detail
