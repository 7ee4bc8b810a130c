// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/least_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "depth/conflicts.h"
#include "impact/impact_options.h"
#include "numbers/errors.h"
#include "tricover/distance.h"
#include "tricover/time_of_impact.h"

namespace tricover {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

/// The least distance of two bodies on their ways. `Path` is a Motion or a Trajectory.
template <typename Path>
class LeastOnWay {
 public:
  LeastOnWay(const Polygon& a, const Path& path_a, const Polygon& b, const Path& path_b, double begin, double end,
             const LeastDistanceOptions& options)
      : a_(a), b_(b), path_a_(path_a), path_b_(path_b), begin_(begin), end_(end), options_(options) {}

  /// Where an impact with a margin is, the distance is at most the margin; where there is none, it is more. The margin
  /// is by turns just below the least distance that is known, which ends the search, and in the middle between that and
  /// what is proven, which halves what is left.
  LeastDistance find() {
    for (int i = 0; i <= kSamples; ++i) look(i < kSamples ? begin_ + (end_ - begin_) * i / kSamples : end_);
    descend();
    double lower = 0;
    // The first step asks whether they meet, whatever the error. Sixty halvings are all bits of a distance.
    for (int step = 0; least_.distance - lower > (step == 0 ? 0 : options_.absolute_error); ++step) {
      if (step == kMostSteps) {
        least_.budget_ended = true;
        break;
      }
      const double before = least_.distance, half = lower + 0.5 * (std::min(before, kLargest) - lower);
      const bool is_guess = step % 2 == 1 && before - 0.5 * options_.absolute_error > half;
      const double margin = step == 0 ? 0 : is_guess ? before - 0.5 * options_.absolute_error : half;
      if (step > 0 && !(lower < margin && margin < before)) {
        if (is_guess) continue;
        break;  // they are neighbours
      }
      ImpactOptions closer{std::min(margin + options_.margin, kLargest), 0};
      const std::optional<Impact> impact = timeOfImpact(a_, path_a_, b_, path_b_, closer);
      if (!impact) {
        lower = margin;
        continue;
      }
      least_.budget_ended = impact->budget_ended;
      if (impact->budget_ended) break;
      if (look(impact->time)) descend();
      if (step == 0) least_.distance = 0;  // but for rounding
      if (!is_guess && !(least_.distance < before)) break;
    }
    least_.lower_bound = std::min(lower, least_.distance);
    return least_;
  }

 private:
  static constexpr int kSamples = 8, kMostSteps = 160;

  /// The distance at a time; the least that is known may be there.
  double distanceAt(double time) {
    const DistanceResult at = distance(a_, path_a_.at(time), b_, path_b_.at(time));
    const double left = std::max(at.distance - options_.margin, 0.0);
    if (!is_known_ || left < least_.distance)
      least_ = {left, 0, time, at.point_a, at.point_b, at.edge_a, at.edge_b, false};
    is_known_ = true;
    return left;
  }
  bool look(double time) {
    const double before = least_.distance;
    return distanceAt(time) < before;
  }

  /// From the time of the least distance that is known to where it is least nearby. Where neither side is nearer, it is
  /// likely a parabola in time between them.
  void descend() {
    double step = 0.5 * (end_ - begin_) / kSamples;
    for (; descents_left_ > 0 && least_.distance > 0 && step > 0x1p-44 * (end_ - begin_); --descents_left_) {
      const double time = least_.time, here = least_.distance;
      const double before = std::max(time - step, begin_), after = std::min(time + step, end_);
      const double left = distanceAt(before), right = distanceAt(after), bend = left - here + (right - here);
      if (least_.time != time) continue;
      if (!(before < time && time < after)) break;  // it is least at an end, or the step is rounding
      const double beside = 0.5 * step * (left - right) / bend;
      if (bend > 0 && std::abs(beside) < step) look(std::clamp(time + beside, before, after));
      if (bend <= options_.absolute_error * 0x1p-6) break;
      step *= 0.125;
    }
  }

  const Polygon &a_, &b_;
  const Path &path_a_, &path_b_;
  const double begin_, end_;
  const LeastDistanceOptions& options_;
  bool is_known_ = false;
  int descents_left_ = 24;  ///< steps of descend(): some ten lead to a minimum
  LeastDistance least_{kLargest, 0, 0, Vec2::Zero(), Vec2::Zero(), -1, -1, false};
};

}  // namespace

void detail::checkOptions(const LeastDistanceOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  if (!(options.absolute_error > 0 && std::isfinite(options.absolute_error)))
    refuse("absolute_error", "it must be finite and positive");
}

LeastDistance leastDistance(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                            const LeastDistanceOptions& options) {
  detail::checkOptions(options);
  detail::checkMotions(motion_a, motion_b);
  return LeastOnWay<Motion>(a, motion_a, b, motion_b, 0, 1, options).find();
}

LeastDistance leastDistance(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                            const Trajectory& trajectory_b, const LeastDistanceOptions& options) {
  detail::checkOptions(options);
  const detail::TimeTogether together = detail::timeTogether(trajectory_a, trajectory_b);
  if (!(together.begin <= together.end)) detail::refuse("trajectories", "the bodies are never there together");
  return LeastOnWay<Trajectory>(a, trajectory_a, b, trajectory_b, together.begin, together.end, options).find();
}

}  // namespace tricover
