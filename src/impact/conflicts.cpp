// SPDX-License-Identifier: BSD-3-Clause
#include "impact/conflicts.h"

#include <algorithm>
#include <cmath>

#include "impact/cubic.h"
#include "impact/options.h"
#include "numbers/rigidity.h"
#include "pair/certificate.h"
#include "pair/kernel_order.h"
#include "tricover/collide.h"

namespace tricover {
namespace detail {
namespace {

/// What the poses at two times are wrong by, and how far off rigid they may be, is far less than this share of lengths.
constexpr double kSpared = 1 + 0x1p-10;

/// How fast a point of a polygon moves at the most, from time 0 to 1.
double speedOf(const PolygonData& polygon, const Motion& motion) {
  const Cubic<Vec2> path = pathOf(motion);
  const Cubic<double> rotation = rotationOf(motion);
  const Vec2 arm = polygon.origin - motion.pivot;
  const double reach = std::hypot(arm.x(), arm.y()) + polygon.radius;
  return (path.mostRate(0, 1) + rotation.mostRate(0, 1) * reach) * kSpared;
}

}  // namespace

MovingContact::MovingContact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                             const ImpactOptions& options)
    : a_(a),
      b_(b),
      motion_a_(motion_a),
      motion_b_(motion_b),
      margin_(options.margin),
      seen_(0.5 * std::max(options.time_error, 1e-9)),
      speed_(speedOf(a.data(), motion_a) + speedOf(b.data(), motion_b)) {}

bool MovingContact::meetAt(double time, double margin) const {
  return collide(a_, motion_a_.at(time), b_, motion_b_.at(time), {margin, 0});
}

/// Whether they certainly meet for all of a step, by how deep they are in each other, or within the margin, at its
/// begin: no two points approach or separate by more than `travel`.
bool MovingContact::meetUntil(double time, double step) const {
  const double travel = speed_ * step * kSpared;
  if (travel <= margin_) return meetAt(time, margin_ - travel);
  const Pose pose_a = motion_a_.at(time), pose_b = motion_b_.at(time);
  const Outcome found = inKernelOrder(
      a_.data(), pose_a, b_.data(), pose_b,
      [&](const auto&... operands) {
        return findCertificate(operands..., {0, 0}, {2 * travel, true});
      },
      [](const Outcome&) {});
  return found.collides && found.clearance + margin_ > travel;
}

MovingContact::End MovingContact::endOfContact(double begin) {
  if (steps_left_-- <= 0) return {begin, false};
  // An impact is told up to so much too early.
  double time = begin, step = seen_;
  if (begin > 0 || !meetAt(0, margin_)) {
    time = std::min(1.0, begin + step);
    if (!meetAt(time, margin_)) return {time, true};
  }
  while (time < 1) {
    if (step > seen_ && !meetUntil(time, step)) {
      step = std::max(0.5 * step, seen_);
      continue;
    }
    if (steps_left_-- <= 0) return {time, false};
    // A step that proves nothing is no longer than what is seen.
    const double next = std::min(1.0, time + step);
    if (!meetAt(next, margin_)) return {next, true};
    time = next;
    step *= 4;
  }
  return {1, true};
}

std::optional<Impact> MovingContact::next(double begin) const {
  if (begin >= 1) return std::nullopt;
  const ImpactOptions options = optionsWithin({margin_, seen_}, 1 - begin);
  auto impact = timeOfImpact(a_, motion_a_.part(begin, 1), b_, motion_b_.part(begin, 1), options);
  if (impact) impact->time = timeWithin(begin, 1 - begin, impact->time);
  return impact;
}

}  // namespace detail

std::vector<Conflict> conflicts(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                                const ImpactOptions& options) {
  detail::checkOptions(options);
  detail::checkMotions(motion_a, motion_b);
  detail::MovingContact contact(a, motion_a, b, motion_b, options);
  std::vector<Conflict> found;
  double time = 0;
  while (auto impact = contact.next(time)) {
    const auto end = impact->budget_ended ? detail::MovingContact::End{1, false} : contact.endOfContact(impact->time);
    time = end.is_known ? end.time : 1;
    if (found.empty() || impact->time > found.back().end) found.push_back({*impact, time});
    found.back().end = time;
    found.back().budget_ended = !end.is_known;
  }
  if (options.ignore_initial) detail::leaveOutInitial(found, 0);
  return found;
}

}  // namespace tricover
