// SPDX-License-Identifier: BSD-3-Clause
#include "depth/conflicts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "depth/deep_impact.h"
#include "impact/impact_options.h"
#include "impact/vertex_paths.h"
#include "numbers/cubic.h"
#include "numbers/rigidity.h"
#include "pair/certificate.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/edge_pairs.h"
#include "pair/kernel_order.h"
#include "tricover/collide.h"

namespace tricover {
namespace detail {
namespace {

/// What the poses at two times are wrong by, and how far off rigid they may be, is far less than this share of lengths.
constexpr double kSpared = 1 + 0x1p-10;

/// No point of one moves faster against the other one. (A reach may be infinite.)
double mostSpeed(const MovingPair& pair) {
  const Rates rates = pair.ratesOf(0, 1);
  const auto about = [](double rate, const Mover& mover) { return rate > 0 ? rate * mover.reach : 0; };
  return (rates.speed + about(rates.a, pair.a) + about(rates.b, pair.b)) * kSpared * pair.length * pair.expansion;
}

/// In the kernel's order, with trees.
MovingPair preparedPair(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                        double margin) {
  MovingPair pair = inKernelOrder(
      detail::dataOf(a), motion_a, detail::dataOf(b), motion_b,
      [&](const auto&... operands) { return MovingPair(operands..., margin); }, [](MovingPair&) {});
  pair.prepare();
  return pair;
}

/// Times are not told apart any closer.
constexpr double kShortestTime = 1e-9;

/// How far off a pose is that a motion has at a time, by its translation.
double posedError(const Motion& motion) {
  const double path = motion.shift.lpNorm<1>() + motion.shift_2.lpNorm<1>() + motion.shift_3.lpNorm<1>();
  return 8 * kUnitRoundoff * (motion.start.translation().lpNorm<1>() + path);
}

/// Contacts of each edge take some steps, in each radian. Where rounding is as large as lengths, no step proves much,
/// and what passes by within the shortest time has no contact to follow.
int stepsAlongContacts(const MovingPair& pair, double speed) {
  const PolygonData &a = *pair.a.polygon, &b = *pair.b.polygon;
  const double size = a.extent + b.extent + pair.given_margin;
  if (!pair.isInRange() || kShortestTime * speed > size) return 1 << 5;
  const double edges = static_cast<double>(a.path.size() + b.path.size());
  const double radians = std::min(pair.a.rotation.size() + pair.b.rotation.size(), 8.0);
  return static_cast<int>(std::min((0x1p7 + 16 * edges) * (1 + radians), 0x1p21));
}

}  // namespace

MovingContact::MovingContact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                             const ImpactOptions& options)
    : a_(a),
      b_(b),
      motion_a_(motion_a),
      motion_b_(motion_b),
      pair_(preparedPair(a, motion_a, b, motion_b, std::max(options.margin, 0.0))),
      margin_(options.margin),
      seen_(0.5 * std::max(options.time_error, kShortestTime)),
      // Bodies that touch by their motions are to touch by the rounded poses that are tested, too.
      precision_(
          std::max(8 * pair_.error * pair_.length * pair_.expansion, posedError(motion_a) + posedError(motion_b))),
      touch_margin_(margin_ + (margin_ < 0 ? kDeepEnough + 1 : 1) * precision_),
      speed_(mostSpeed(pair_)),
      steps_left_(margin_ < 0 ? 1 << 14 : stepsAlongContacts(pair_, speed_)) {
  for (auto& [time, depth] : depths_) time = -1;
  if (!std::isfinite(touch_margin_)) touch_margin_ = margin_;
  if (!std::isfinite(precision_)) precision_ = 0;
}

const Depth& MovingContact::depthAt(double time) const {
  if (depths_[0].first != time) std::swap(depths_[0], depths_[1]);
  if (depths_[0].first != time) depths_[0] = {time, depth(a_, motion_a_.at(time), b_, motion_b_.at(time))};
  return depths_[0].second;
}

bool MovingContact::touchAt(double time) const {
  if (margin_ < 0) return depthAt(time).upper_bound > 0 && depthAt(time).upper_bound >= -touch_margin_;
  return collide(a_, motion_a_.at(time), b_, motion_b_.at(time), {touch_margin_, 0});
}

/// The pair as it is asked, at a time.
struct MovingContact::Posed {
  Posed(const MovingPair& moving, double time)
      : pose_a(moving.a.motion->at(time)),
        pose_b(moving.b.motion->at(time)),
        pair(*moving.a.polygon, pose_a, *moving.b.polygon, pose_b) {}
  /// Two edges within the margin; one of them, or both, kNoEdge where there are none.
  Outcome edgesWithin(double margin) const { return collideByHierarchy(pair, {margin}, 0, Wanted::Edges); }

  const Pose pose_a, pose_b;
  const PosedPair pair;
};

/// Whether they certainly touch throughout: by how deep they are in each other, or within the margin, at the first
/// time, as no two points approach or separate by more than `travel`; or by features.
bool MovingContact::meetUntil(double time, double next) const {
  const double travel = speed_ * (next - time) * kSpared;
  if (margin_ < 0) {
    const Depth first = depthAt(time);
    if (first.depth == std::numeric_limits<double>::infinity() || first.depth >= travel - margin_) return true;
    return staysDeep(time, next, time) || staysDeep(time, next, next);
  }
  const Posed posed(pair_, time);
  if (travel <= touch_margin_ && posed.edgesWithin(touch_margin_ - travel).collides) return true;
  const Outcome found = findCertificate(posed.pair.a, posed.pose_a, posed.pair.b, posed.pose_b,
                                        defectOf(posed.pose_a, posed.pose_b), {0, 0}, {2 * travel, true});
  if (found.collides && found.clearance + margin_ > travel) return true;
  return pair_.isInRange() && (featuresStay(time, next) || staysContained(time, next, travel));
}

/// Whether one holds the other, and goes on to: by the edges that come near, none of which meet.
bool MovingContact::staysContained(double time, double next, double travel) const {
  const Posed posed(pair_, time);
  const Outcome held = posed.edgesWithin(0);
  if (!held.collides || (held.edge_a != kNoEdge && held.edge_b != kNoEdge)) return false;
  const TimeInterval interval(pair_, time, next);
  bool meet = false;
  forEachPair(posed.pair, travel, [&](double, EdgePosition edge_a, EdgePosition edge_b) {
    meet = restOfEdges(interval, edge_a, edge_b).low <= 1;
    return meet ? -1 : travel;
  });
  return !meet;
}

/// Whether two edges that touch at either time stay crossed, or have an end that stays so near to the other edge: its
/// distance from that is largest at one of both times, but for how far its path bends.
bool MovingContact::featuresStay(double time, double next) const {
  const TimeInterval interval(pair_, time, next);
  for (const double at : {time, next}) {
    const Outcome touch = Posed(pair_, at).edgesWithin(touch_margin_);
    if (touch.edge_a == kNoEdge || touch.edge_b == kNoEdge) continue;
    if (endStaysBeside(interval, touch.edge_a, touch.edge_b) || edgesStayCrossed(interval, touch.edge_a, touch.edge_b))
      return true;
  }
  return false;
}

/// The end is the first of the times begin + seen_, begin + 2 seen_ ... at which they are apart, whatever was proven of
/// those before it: what a certificate proves depends on what was asked of the polygons before.
Reached MovingContact::endOfContact(double begin) {
  if (steps_left_-- <= 0) return {begin, false};
  const auto timeAfter = [&](double steps) { return std::min(1.0, begin + steps * seen_); };
  // An impact is told up to so much too early.
  double done = begin > 0 || !touchAt(0) ? 1 : 0, steps = 1;
  if (done > 0 && !touchAt(timeAfter(done))) return {timeAfter(done), true};
  if (meetUntil(timeAfter(done), 1)) return {1, true};
  return march(Reached{timeAfter(done), timeAfter(done) == 1}, steps_left_, [&](double time) -> std::optional<Reached> {
    --steps_left_;
    // A step that proves nothing is no longer than what is seen.
    while (steps > 1 && !meetUntil(time, timeAfter(done + steps))) steps *= 0.5;
    done += steps;
    steps *= 4;
    const bool meet = touchAt(timeAfter(done));
    return Reached{timeAfter(done), !meet || timeAfter(done) == 1};
  });
}

std::optional<Impact> MovingContact::next(double begin) const {
  if (begin >= 1) return std::nullopt;
  const ImpactOptions options = optionsWithin({margin_, seen_}, 1 - begin);
  auto impact = timeOfImpact(a_, motion_a_.part(begin, 1), b_, motion_b_.part(begin, 1), options);
  if (impact) impact->time = timeWithin(begin, 1 - begin, impact->time);
  return impact;
}

void addConflicts(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b, double begin,
                  double end, const ImpactOptions& clocks_options, bool& leaves_out, std::vector<Conflict>& all) {
  const double length = end - begin;
  const ImpactOptions options = optionsWithin(clocks_options, length);
  MovingContact contact(a, motion_a, b, motion_b, options);
  const auto add = [&](Impact impact, const Reached& last) {
    impact.time = timeWithin(begin, length, impact.time);
    if (all.empty() || impact.time > all.back().end) all.push_back({impact, end});
    const bool ends_before = last.is_known && last.time < 1;
    all.back().end = ends_before ? std::min(end, begin + length * last.time) : end;
    all.back().budget_ended |= !last.is_known;
    all.back().meets_at_end = !ends_before && contact.touchAt(1);
  };
  double time = 0;
  leaves_out = leaves_out && contact.touchAt(0);
  if (leaves_out) {
    const auto last = contact.endOfContact(0);
    time = last.time;
    leaves_out = time == 1;
    // Whether the first contact lasts is unknown. What touches within rounding alone may have no impact at all.
    if (!last.is_known) {
      std::optional<Impact> impact = timeOfImpact(a, motion_a, b, motion_b, options);
      if (!impact) return;
      impact->time = time;
      impact->budget_ended = true;
      return add(*impact, last);
    }
  }
  while (const auto impact = contact.next(time)) {
    const auto last = impact->budget_ended ? Reached{1, false} : contact.endOfContact(impact->time);
    add(*impact, last);
    time = last.is_known ? last.time : 1;
  }
}

}  // namespace detail

std::vector<Conflict> conflicts(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                                const ImpactOptions& options) {
  detail::checkOptions(options);
  detail::checkMotions(motion_a, motion_b);
  bool leaves_out = options.ignore_initial;
  std::vector<Conflict> all;
  detail::addConflicts(a, motion_a, b, motion_b, 0, 1, options, leaves_out, all);
  return all;
}

}  // namespace tricover
