// SPDX-License-Identifier: BSD-3-Clause
// Moving polygons and the bodies of a scene.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "impact/cubic.h"
#include "impact/options.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "scene/in_parallel.h"
#include "scene/scene_state.h"

namespace tricover {

using detail::Bounds;
using detail::SceneState;
using detail::Slot;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A window is about as long as the polygon is wide, so that the boxes of a sweep are about twice that.
constexpr double kMostWindows = 64;
/// Of pairs that both move: what they save grows slower than what they cost.
constexpr double kMostPairWindows = 16;

/// A polygon on a leg of its way, enclosed window by window, in the leg's own time from 0 to 1.
class SweptLeg {
 public:
  SweptLeg(const Polygon& polygon, const Motion& motion, double margin, double begin, double length)
      : polygon_(polygon.data()),
        motion_(motion),
        margin_(margin),
        begin_(begin),
        length_of_time_(length),
        way_(detail::wayOf(motion)),
        turn_(detail::turnOf(motion)) {
    const Vec2 arm = polygon_.origin - motion.pivot;
    reach_ = (std::hypot(arm.x(), arm.y()) + polygon_.radius) * (1 + 2 * detail::kLargestDefect);
    // Sums of coordinates, because squares may leave the range of doubles.
    path_ = (way_.first.cwiseAbs() + way_.second.cwiseAbs() + way_.third.cwiseAbs()).sum();
    // timeOfImpact() may report what comes as near as 1e-13 of this, of a part of a trajectory's leg eight times that,
    // whose terms may be so large: ten times as much, for what rounds here.
    length_ = motion.start.translation().cwiseAbs().sum() + motion.pivot.cwiseAbs().sum() + path_ +
              (1 + turn_.size()) * reach_;
  }

  double begin() const { return begin_; }  ///< by the clock
  double end() const { return begin_ + length_of_time_; }
  double clockAt(double time) const { return begin_ + length_of_time_ * time; }
  double timeAt(double clock) const { return std::clamp((clock - begin_) / length_of_time_, 0.0, 1.0); }

  /// How many windows tell where it is when.
  double windows() const {
    const double wide = 2 * reach_ + margin_, way = path_ + turn_.size() * reach_;
    return way < kMostWindows * wide ? std::max(1.0, std::ceil(way / wide)) : kMostWindows;
  }

  /// A box around all that is within the margin of it at some time from `begin` to `end`.
  Bounds between(double begin, double end) const {
    const double half = 0.5 * (end - begin), middle = begin + half;
    // No point leaves its place at the middle by more, against the pivot; nor is any farther from the pivot.
    const double turned = turn_.mostRate(begin, end) * half * reach_;
    if (!(turned < reach_)) return discBetween(begin, end);
    return swept(detail::boundsOf(polygon_, motion_.at(middle), spared() + turned), way_.at(middle), begin, end);
  }

  /// The same, by the disc around the pivot: wider, and sooner there.
  Bounds discBetween(double begin, double end) const {
    const Vec2 pivot = motion_.start * motion_.pivot;
    const double r = reach_ + spared();
    return swept({pivot.x() - r, pivot.y() - r, pivot.x() + r, pivot.y() + r}, Vec2::Zero(), begin, end);
  }

 private:
  double spared() const { return margin_ + 1e-12 * length_; }

  /// What a box sweeps that is carried along the way; it is given as it is where the way has come to `now`.
  Bounds swept(const Bounds& box, const Vec2& now, double begin, double end) const {
    // A cubic leaves its chord by at most its acceleration times h^2 / 8, h the window's length.
    const double half = 0.5 * (end - begin);
    const Vec2 bend =
        0.5 * half * half * way_.accelerationAt(begin).cwiseAbs().cwiseMax(way_.accelerationAt(end).cwiseAbs());
    const Vec2 first = way_.at(begin), last = way_.at(end);
    const Vec2 low = first.cwiseMin(last) - bend - now, high = first.cwiseMax(last) + bend - now;
    const Bounds bounds{box.min_x + low.x(), box.min_y + low.y(), box.max_x + high.x(), box.max_y + high.y()};
    // Negated for NaN.
    if (!(bounds.min_x <= bounds.max_x && bounds.min_y <= bounds.max_y))
      return {-kInfinity, -kInfinity, kInfinity, kInfinity};
    return bounds;
  }

  const detail::PolygonData& polygon_;
  const Motion& motion_;
  double margin_, begin_, length_of_time_, reach_, path_, length_;
  detail::Cubic<Vec2> way_;
  detail::Cubic<double> turn_;
};

/// A polygon on all of its way, by a clock: of a motion that runs from 0 to 1.
class Sweep {
 public:
  Sweep(const Polygon& polygon, const Motion& motion, double margin) {
    legs_.emplace_back(polygon, motion, margin, 0.0, 1.0);
  }
  Sweep(const Polygon& polygon, const Trajectory& trajectory, double margin) {
    for (const Leg& leg : trajectory.legs())
      legs_.emplace_back(polygon, leg.motion, margin, leg.begin, leg.end - leg.begin);
  }

  const std::vector<SweptLeg>& legs() const { return legs_; }
  double begin() const { return legs_.front().begin(); }
  double end() const { return legs_.back().end(); }
  double windows() const {
    double sum = 0;
    for (const SweptLeg& leg : legs_) sum += leg.windows();
    return sum;
  }

  /// A box around all that is within the margin of it at some time from `begin` to `end`, by discs. It rests before its
  /// first leg and after the last.
  Bounds discBetween(double begin, double end) const {
    const auto ends_before = [](const SweptLeg& leg, double time) { return leg.end() < time; };
    auto leg = std::lower_bound(legs_.begin(), std::prev(legs_.end()), begin, ends_before);
    Bounds all = leg->discBetween(leg->timeAt(begin), leg->timeAt(end));
    for (++leg; leg != legs_.end() && leg->begin() <= end; ++leg)
      all = unite(all, leg->discBetween(leg->timeAt(begin), leg->timeAt(end)));
    return all;
  }

 private:
  std::vector<SweptLeg> legs_;
};

Motion restBeside(const Motion&, const Pose& pose) { return Motion::still(pose); }
Trajectory restBeside(const Trajectory& other, const Pose& pose) {
  return Trajectory({{other.begin(), other.end(), Motion::still(pose)}});
}

ImpactOptions withMargin(ImpactOptions options, double margin) {
  options.margin = detail::withMargin({options.margin}, margin).margin;
  return options;
}

/// Of a Motion or a Trajectory.
template <typename Way>
std::optional<BodyImpact> firstImpactOn(const Way& way, const Polygon& polygon, const ImpactOptions& options,
                                        const SceneState& state, const BodyFilter& filter) {
  const Sweep sweep(polygon, way, options.margin);
  std::optional<BodyImpact> best;
  const detail::SlotFilter slots = state.slots(filter);
  std::vector<Slot> asked, near, now;  // in any window so far, in this one, in this one for the first time
  for (const SweptLeg& leg : sweep.legs()) {
    const double windows = leg.windows();
    for (double w = 0; w < windows; ++w) {
      // What is met in no earlier window isn't hit before this one begins, nor reported much earlier.
      const double clock = leg.clockAt(w / windows);
      if (best && best->impact.time < clock - options.time_error - 0x1p-50 * std::abs(clock)) return best;
      near.clear();
      state.tree.visit(leg.between(w / windows, (w + 1) / windows), [&](Slot body, const Bounds&) {
        if (state.passes(slots, body)) near.push_back(body);
        return true;
      });
      std::sort(near.begin(), near.end());
      now.clear();
      std::set_difference(near.begin(), near.end(), asked.begin(), asked.end(), std::back_inserter(now));
      for (const Slot slot : now) {
        const auto& other = state.bodies[slot];
        const BodyHandle body = state.handleOf(slot);
        const auto impact = timeOfImpact(polygon, way, other.polygon, restBeside(way, other.pose),
                                         withMargin(options, other.options.margin));
        if (impact && (!best || std::pair(impact->time, body) < std::pair(best->impact.time, best->body)))
          best = BodyImpact{body, *impact};
      }
      const auto known = static_cast<std::ptrdiff_t>(asked.size());
      asked.insert(asked.end(), now.begin(), now.end());
      std::inplace_merge(asked.begin(), asked.begin() + known, asked.end());
    }
  }
  return best;
}

}  // namespace

std::optional<BodyImpact> Scene::firstImpact(const Polygon& polygon, const Motion& motion, const ImpactOptions& options,
                                             const BodyFilter& filter) const {
  detail::checkOptions(options);
  checkMotion(motion);
  return firstImpactOn(motion, polygon, options, impl_->settled(), filter);
}

std::optional<BodyImpact> Scene::firstImpact(const Polygon& polygon, const Trajectory& trajectory,
                                             const ImpactOptions& options, const BodyFilter& filter) const {
  detail::checkOptions(options);
  return firstImpactOn(trajectory, polygon, options, impl_->settled(), filter);
}

namespace {

/// Boxes around moving bodies: of each body one a window, and one around all of these.
class SweptBoxes {
 public:
  explicit SweptBoxes(const std::vector<Sweep>& sweeps) {
    double most = 1, begin = kInfinity, end = -kInfinity;
    std::size_t legs = 1;
    for (const Sweep& sweep : sweeps) {
      most = std::max(most, sweep.windows());
      legs = std::max(legs, sweep.legs().size());
      begin = std::min(begin, sweep.begin());
      end = std::max(end, sweep.end());
    }
    windows_ = static_cast<std::size_t>(std::min(most, kMostPairWindows * static_cast<double>(legs)));
    boxes_.reserve(windows_ * sweeps.size());
    all_.reserve(sweeps.size());
    const double count = static_cast<double>(windows_), length = end - begin;
    for (const Sweep& sweep : sweeps) {
      Bounds all{kInfinity, kInfinity, -kInfinity, -kInfinity};
      for (double w = 0; w < count; ++w) {
        const Bounds box = sweep.discBetween(begin + length * (w / count), begin + length * ((w + 1) / count));
        boxes_.push_back(box);
        all = unite(all, box);
      }
      all_.push_back(all);
    }
  }

  const Bounds& all(std::size_t i) const { return all_[i]; }

  /// Whether two of them are near each other at the same time.
  bool meetInWindow(std::size_t i, std::size_t j) const {
    const Bounds *p = &boxes_[i * windows_], *q = &boxes_[j * windows_];
    for (std::size_t w = 0; w < windows_; ++w)
      if (p[w].meets(q[w])) return true;
    return false;
  }

  /// Whether one of them comes near what rests in a box.
  bool meets(std::size_t i, const Bounds& rest) const {
    const Bounds* p = &boxes_[i * windows_];
    return std::any_of(p, p + windows_, [&](const Bounds& box) { return box.meets(rest); });
  }

 private:
  std::size_t windows_;
  std::vector<Bounds> boxes_, all_;
};

const Motion& wayOf(const BodyMotion& moving) { return moving.motion; }
const Trajectory& wayOf(const BodyTrajectory& moving) { return moving.trajectory; }

/// The pairs of bodies that may meet while some of them move, sorted.
template <typename Moving>
std::vector<BodyPair> pairsNear(const SceneState& state, const std::vector<Moving>& motions,
                                const std::vector<std::uint32_t>& motion_of, double margin) {
  std::vector<Sweep> sweeps;
  for (const Moving& moving : motions) {
    const auto& body = state.bodies[slotOf(moving.body)];
    // The query's own margin is counted once a pair: half of it for either one.
    sweeps.emplace_back(body.polygon, wayOf(moving), body.options.margin + 0.5 * margin);
  }
  const SweptBoxes boxes(sweeps);
  std::vector<BodyPair> pairs;
  const auto mayMeet = [&](Slot p, Slot q) { return state.mayMeet(state.bodies[p], state.bodies[q]); };
  const auto add = [&](Slot slot_p, Slot slot_q) {
    const BodyHandle p = state.handleOf(slot_p), q = state.handleOf(slot_q);
    pairs.push_back({std::min(p, q), std::max(p, q)});
  };
  // Bodies at rest have their own margins alone around them.
  const double rest = 0.5 * margin * (1 + 0x1p-40);
  detail::BoxTree moving;
  for (std::uint32_t i = 0; i < motions.size(); ++i) {
    const Slot body = slotOf(motions[i].body);
    const Bounds& all = boxes.all(i);
    moving.visit(all, [&](std::uint32_t j, const Bounds&) {
      const Slot other = slotOf(motions[j].body);
      if (mayMeet(body, other) && boxes.meetInWindow(i, j)) add(body, other);
      return true;
    });
    moving.insert(i, all);
    state.tree.visit(all.grown(rest), [&](Slot other, const Bounds& box) {
      const bool rests = motion_of[other] == motions.size();
      if (rests && mayMeet(body, other) && boxes.meets(i, box.grown(rest))) add(body, other);
      return true;
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// By the slots of bodies: which of the motions is theirs, or how many there are. Throws, naming them by `name`.
template <typename Moving>
std::vector<std::uint32_t> motionsOf(const SceneState& state, const std::vector<Moving>& motions, const char* name) {
  const auto at_rest = static_cast<std::uint32_t>(motions.size());
  std::vector<std::uint32_t> motion_of(state.bodies.size(), at_rest);
  for (std::uint32_t i = 0; i < motions.size(); ++i) {
    std::uint32_t& of_body = motion_of[state.slot(motions[i].body)];
    if (of_body != at_rest) detail::refuse(name + ("[" + std::to_string(i)) + "]", "its body has a motion already");
    of_body = i;
  }
  return motion_of;
}

/// Of BodyMotions or BodyTrajectories: report(pair, ask(polygon, way, polygon, way, options)) of each pair that may
/// meet, by handles. The asking is what runs in parallel.
template <typename Answer, typename Moving, typename Ask, typename Report>
void askPairs(const std::vector<Moving>& motions, const char* name, const SceneState& state,
              const ImpactOptions& options, const Parallel& parallel, const Ask& ask, const Report& report) {
  const std::vector<std::uint32_t> motion_of = motionsOf(state, motions, name);
  const std::vector<BodyPair> pairs = pairsNear(state, motions, motion_of, options.margin);
  std::vector<Answer> found(pairs.size());
  detail::inParallel(parallel, pairs.size(), [&](std::size_t i) {
    const Slot first = slotOf(pairs[i].first), second = slotOf(pairs[i].second);
    const auto &p = state.bodies[first], &q = state.bodies[second];
    const ImpactOptions both = withMargin(withMargin(options, p.options.margin), q.options.margin);
    const std::uint32_t moves_p = motion_of[first], moves_q = motion_of[second];
    if (moves_p == motions.size()) {
      const auto& way = wayOf(motions[moves_q]);
      found[i] = ask(p.polygon, restBeside(way, p.pose), q.polygon, way, both);
    } else if (moves_q == motions.size()) {
      const auto& way = wayOf(motions[moves_p]);
      found[i] = ask(p.polygon, way, q.polygon, restBeside(way, q.pose), both);
    } else {
      found[i] = ask(p.polygon, wayOf(motions[moves_p]), q.polygon, wayOf(motions[moves_q]), both);
    }
  });
  for (std::size_t i = 0; i < pairs.size(); ++i) report(pairs[i], found[i]);
}

template <typename Moving>
std::vector<PairImpact> impactsOf(const std::vector<Moving>& motions, const char* name, const SceneState& state,
                                  const ImpactOptions& options, const Parallel& parallel) {
  std::vector<PairImpact> impacts;
  askPairs<std::optional<Impact>>(
      motions, name, state, options, parallel, [](const auto&... operands) { return timeOfImpact(operands...); },
      [&](const BodyPair& pair, const std::optional<Impact>& impact) {
        if (impact) impacts.push_back({pair, *impact});
      });
  std::stable_sort(impacts.begin(), impacts.end(),
                   [](const PairImpact& p, const PairImpact& q) { return p.impact.time < q.impact.time; });
  return impacts;
}

}  // namespace

std::vector<PairImpact> Scene::impacts(const std::vector<BodyMotion>& motions, const ImpactOptions& options,
                                       const Parallel& parallel) const {
  detail::checkOptions(options);
  const SceneState& state = impl_->settled();
  for (std::size_t i = 0; i < motions.size(); ++i)
    checkMotion(motions[i].motion, ("motions[" + std::to_string(i) + "]").c_str());
  return impactsOf(motions, "motions", state, options, parallel);
}

std::vector<PairImpact> Scene::impacts(const std::vector<BodyTrajectory>& trajectories, const ImpactOptions& options,
                                       const Parallel& parallel) const {
  detail::checkOptions(options);
  const SceneState& state = impl_->settled();
  return impactsOf(trajectories, "trajectories", state, options, parallel);
}

std::vector<PairConflict> Scene::conflicts(const std::vector<BodyTrajectory>& trajectories,
                                           const ImpactOptions& options, const Parallel& parallel) const {
  detail::checkOptions(options);
  std::vector<PairConflict> all;
  askPairs<std::vector<Conflict>>(
      trajectories, "trajectories", impl_->settled(), options, parallel,
      [](const auto&... operands) { return tricover::conflicts(operands...); },
      [&](const BodyPair& pair, const std::vector<Conflict>& found) {
        for (const Conflict& conflict : found) all.push_back({pair, conflict});
      });
  std::stable_sort(all.begin(), all.end(), [](const PairConflict& p, const PairConflict& q) {
    return p.conflict.impact.time < q.conflict.impact.time;
  });
  return all;
}

}  // namespace tricover
