// SPDX-License-Identifier: BSD-3-Clause
// With a negative margin: the first time at which two regions are deeper in each other than the overlap that is
// allowed.
//
// Where b is apart from a once all of its points have been moved by no more than that, they are not as deep. So the
// ordinary time of impact of a b that has been translated by so much proves an interval of time. At its end the
// translated b touches a. The normal there says what the next translation has to keep farther away from. Where no
// translation keeps away from all touches, b is shrunk instead, as in a corridor of its own width; or else the depth
// says how long the regions certainly are not as deep as is allowed.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "impact/conflicts.h"
#include "impact/options.h"
#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

/// An ordinary time of impact, or a step of time, costs some microseconds.
constexpr int kMostSteps = 1 << 12;
/// The touches that a translation keeps away from, the last ones. More than three seldom matter.
constexpr std::size_t kMostTouches = 6;
/// Touches at one time, after which translations are given up there.
constexpr int kMostAtOnce = 8;

/// b touches a here if it is translated by no more than `depth` along the normal.
struct Touch {
  Vec2 normal;
  double depth;
};

struct Room {
  Vec2 shift;
  double left;  ///< by how much the shift is farther along each normal than that touch's depth, at least
};

/// The translation, no longer than `most`, that leaves the most room. It is along a normal, or as far as it may be and
/// equally far from two touches.
Room widestRoom(std::vector<Touch> all, double most) {
  for (Touch& touch : all) touch.depth /= most;
  Room best{Vec2::Zero(), -std::numeric_limits<double>::infinity()};
  const auto offer = [&](const Vec2& shift) {
    double left = std::numeric_limits<double>::infinity();
    for (const Touch& touch : all) left = std::min(left, touch.normal.dot(shift) - touch.depth);
    if (shift.squaredNorm() <= 1 + 0x1p-40 && left > best.left) best = {shift, left};
  };
  offer(Vec2::Zero());
  for (std::size_t i = 0; i < all.size(); ++i) {
    offer(all[i].normal);
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 u = all[i].normal - all[j].normal;
      const double c = all[i].depth - all[j].depth, square = u.squaredNorm();
      const Vec2 middle = u * (c / square), aside = Vec2(-u.y(), u.x()).normalized();
      const double reach = std::sqrt(std::max(1 - middle.squaredNorm(), 0.0));
      for (const double side : {-reach, reach}) offer(middle + side * aside);
    }
  }
  return {best.shift * most, best.left * most};
}

}  // namespace

/// The search for a first contact that is deeper than the margin allows.
class DeepImpact {
 public:
  DeepImpact(const MovingContact& pair, double allowed) : pair_(pair), allowed_(allowed) {}

  std::optional<Impact> find() {
    touchAll(overlapNow());
    for (int step = 0; step < kMostSteps; ++step) {
      const Room room = widestRoom(touches_, allowed_);
      if (room.left > pair_.precision_ && at_once_ < kMostAtOnce) {
        if (!advance(room.shift)) return ended();
        continue;
      }
      const Depth& overlap = overlapNow();
      const double depth = overlap.upper_bound;
      // After a proven interval an impact is as early as ordinary ones are.
      if (depth >= allowed_ - (time_ > 0 ? 2 * pair_.precision_ : 0)) return impactHere(overlap);
      if (time_ >= 1) return std::nullopt;
      const double last = time_;
      if (!advanceShrunk()) return ended();
      const double proven = last + std::max(allowed_ - depth, pair_.precision_) / pair_.speed_;
      time_ = std::min(std::max(time_, proven), 1.0);
      touchAll(overlapNow());
    }
    Impact impact = impactHere(overlapNow());
    impact.budget_ended = true;
    return impact;
  }

 private:
  const Depth& overlapNow() const { return pair_.depthAt(time_); }

  void touchAll(const Depth& overlap) {
    touches_.clear();
    at_once_ = 0;
    if (overlap.depth > 0) touches_.push_back({overlap.normal, overlap.depth});
  }

  /// Goes on to the next contact of `b`, translated. False if there is none, or if it is not known.
  bool advance(const Polygon& b, const Vec2& shift) {
    Motion motion_b = pair_.motion_b_.part(time_, 1);
    motion_b.start.translation() += shift;
    const double time_error = std::min(pair_.precision_ / pair_.speed_, 1.0);
    touch_ = timeOfImpact(pair_.a_, pair_.motion_a_.part(time_, 1), b, motion_b, {0, time_error});
    if (!touch_) return false;
    ++at_once_;
    const double last = time_;
    time_ = std::min(timeWithin(last, 1 - last, touch_->time), 1.0);
    if (time_ > last) {
      at_once_ = 0;
      touches_.clear();
    }
    return !touch_->budget_ended;
  }

  bool advance(const Vec2& shift) {
    if (!advance(pair_.b_, shift)) return false;
    if (touches_.size() == kMostTouches) touches_.erase(touches_.begin());
    touches_.push_back({touch_->normal, touch_->normal.dot(shift)});
    return true;
  }

  /// With a convex b smaller about its S: no point is moved by more than is allowed.
  bool advanceShrunk() {
    if (cornersOf(pair_.b_.data()) == nullptr) return true;
    const double factor = 1 - (1 - 0x1p-20) * (allowed_ / pair_.b_.radius());
    if (!(factor >= 0.5 && factor < 1)) return true;
    const Vec2 origin = pair_.b_.origin();
    return advance(pair_.b_.translated(-origin).scaled(factor).translated(origin), Vec2::Zero());
  }

  /// The search ended in a proof that there is no impact, or at a budget.
  std::optional<Impact> ended() const {
    if (!touch_) return std::nullopt;
    Impact impact = *touch_;
    impact.time = time_;
    return impact;
  }

  Impact impactHere(const Depth& overlap) const {
    Impact impact = touch_.value_or(Impact{0, Vec2::Zero(), Vec2::UnitX(), -1, -1});
    if (overlap.depth > 0)
      impact = {0, overlap.is_point_of_a ? overlap.point_a : overlap.point_b, overlap.normal, overlap.edge_a, overlap.edge_b};
    impact.time = time_;
    return impact;
  }

  const MovingContact& pair_;
  const double allowed_;
  double time_ = 0;  ///< until then they are not as deep as is allowed
  std::vector<Touch> touches_;
  int at_once_ = 0;
  std::optional<Impact> touch_;  ///< of the last interval's end
};

std::optional<Impact> MovingContact::deepImpact() const { return DeepImpact(*this, -margin_).find(); }

}  // namespace tricover::detail
