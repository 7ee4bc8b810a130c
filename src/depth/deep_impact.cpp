// SPDX-License-Identifier: BSD-3-Clause
// With a negative margin: the first time at which a point of one region is as deep in the other one as is allowed.
//
// A piece of b is apart from a once it has been translated by no more than that: then none of its points is as deep. So
// the ordinary time of impact of a translated piece proves an interval of time. At its end the piece touches a. The
// normal there says what the next translation has to keep farther away from. The first piece is all of b, whose proof
// is one of a, too. Where no translation keeps a piece away from all touches, it is cut: the first point that is so
// deep is on an edge, and each piece of an outline has translations of its own. A short one's depth says how long it
// certainly isn't as deep.
#include "depth/deep_impact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "impact/impact_options.h"
#include "numbers/best_first.h"
#include "tricover/contacts.h"

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A time of impact, or a depth, costs some microseconds.
constexpr int kMostSteps = 1 << 12;
/// The touches that a translation keeps away from, the last ones. More than three seldom matter.
constexpr std::size_t kMostTouches = 6;
/// Touches at one time, after which translations are given up there.
constexpr int kMostAtOnce = 8;

/// A piece touches the other region here if it is translated by no more than `depth` along the normal.
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
  Room best{Vec2::Zero(), -kInfinity};
  const auto offer = [&](const Vec2& shift) {
    double left = kInfinity;
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

/// A part of an outline, or all of b.
struct OutlinePart {
  bool operator<(const OutlinePart& other) const { return least > other.least; }

  double least;  ///< the time until which none of its points is as deep as is allowed
  bool of_a;
  std::vector<Vec2> chain;  ///< a polyline in its body's frame; empty for all of b
  std::vector<Touch> touches = {};
  int at_once = 0;  ///< impacts at that time
};

/// There and back.
Polygon polygonOf(const std::vector<Vec2>& chain) {
  Ring ring(chain.begin(), chain.end());
  for (std::size_t i = chain.size() - 2; i > 0; --i) ring.push_back(chain[i]);
  if (ring.size() < 3) ring.push_back(ring.back());
  return Polygon(ring.data(), ring.size());
}

class DeepImpact {
 public:
  explicit DeepImpact(const DeepQuestion& question) : of_(question), near_(kDeepEnough * question.precision) {}

  std::optional<Impact> find() {
    if (of_.depth(0).upper_bound >= of_.allowed) return impactAt(0);
    if (of_.asks_a && of_.asks_b)
      pieces_.push({0, false, {}});
    else
      addOutlines(0);
    const bool has_ended = !pieces_.run(
        0, [&] { return ++steps_ > kMostSteps; }, [&](OutlinePart&& piece) { expand(std::move(piece)); });
    const double time = pieces_.lower();
    if (!(time <= 1)) return std::nullopt;
    Impact impact = impactAt(time);
    impact.budget_ended = has_ended;
    return impact;
  }

 private:
  void expand(OutlinePart&& piece) {
    if (leaves(piece)) return;
    const double time = piece.least;
    const Measured deep = measure(piece);
    // Later than at the start an impact is as early as ordinary ones are.
    if (time > 0 && deep.most >= of_.allowed - near_) {
      pieces_.upper = std::min(pieces_.upper, time);
      return;
    }
    if (time >= 1) return;
    // Another way out may be the shortest one by now.
    const auto isKnownWay = [&](const Touch& touch) { return touch.normal.dot(deep.touch.normal) > 0.875; };
    if (std::none_of(piece.touches.begin(), piece.touches.end(), isKnownWay)) {
      piece.touches = {deep.touch};
      if (leaves(piece)) return;
    }
    if (deep.most < of_.allowed - near_ && cut(piece, of_.allowed - deep.most)) return;
    const double proven = std::max(of_.allowed - deep.most, of_.precision) / of_.speed;
    piece.least = std::min(time + proven, 1.0);
    piece.touches.clear();
    piece.at_once = 0;
    pieces_.push(std::move(piece));
  }

  /// Goes on with the translation that leaves the most room, if that is any.
  bool leaves(OutlinePart& piece) {
    const Room room = widestRoom(piece.touches, of_.allowed);
    return room.left > near_ && piece.at_once < kMostAtOnce && advance(piece, room.shift);
  }

  struct Measured {
    double most;
    Touch touch;
  };
  Measured measure(const OutlinePart& piece) const {
    if (piece.chain.empty()) {
      const Depth depth = of_.depth(piece.least);
      return {depth.upper_bound, {depth.normal, depth.depth}};
    }
    const DeepestPoint deepest = of_.deepest(polygonOf(piece.chain), piece.of_a, piece.least);
    return {deepest.upper_bound, {deepest.way, deepest.distance}};
  }

  /// Goes on to the next contact of a translated piece. False if nothing is known of it.
  bool advance(OutlinePart& piece, const Vec2& shift) {
    const double last = piece.least;
    const bool is_all = piece.chain.empty();
    const Polygon moved = is_all ? of_.b : polygonOf(piece.chain);
    const Polygon& other = is_all ? of_.a : piece.of_a ? of_.borders_b : of_.borders_a;
    Motion motion = (piece.of_a ? of_.motion_a : of_.motion_b).part(last, 1);
    motion.start.translation() += shift;
    // 0 / 0, of what is at rest and so small that its precision is 0, is no number, and 1 is left.
    const double time_error = std::min(1.0, 0.125 * of_.precision / of_.speed);
    const std::optional<Impact> touch =
        timeOfImpact(other, (piece.of_a ? of_.motion_b : of_.motion_a).part(last, 1), moved, motion, {0, time_error});
    if (touch && touch->budget_ended) return false;
    if (of_.is_free && !of_.is_free(moved, motion.start)) return false;
    if (!touch) return true;
    if (touch->time == 0) {
      touchAtOnce(piece, shift, moved, motion.start, *touch);
      pieces_.push(std::move(piece));
      return true;
    }
    piece.least = std::min(timeWithin(last, 1 - last, touch->time), 1.0);
    if (piece.least > last) {
      piece.at_once = 0;
      piece.touches.clear();
    }
    ++piece.at_once;
    addTouches(piece, shift, *touch, piece.least);
    pieces_.push(std::move(piece));
    return true;
  }

  /// A translated piece, which is at `pose`, touches the other region already, or overlaps it.
  void touchAtOnce(OutlinePart& piece, const Vec2& shift, const Polygon& moved, const Pose& pose,
                   const Impact& touch) const {
    ++piece.at_once;
    if (piece.chain.empty()) {
      const Touch deepest = piece.touches.empty() ? measure(piece).touch : Touch{};
      if (isKnown(deepest.depth)) return addTouch(piece, deepest);
      for (const Contact& c :
           contacts(of_.a, of_.motion_a.at(piece.least), moved, pose, {0, kMostTouches, ContactDetail::LocalDepth}))
        addTouch(piece, {c.normal, c.normal.dot(shift) + c.depth});
      return;
    }
    const Vec2 in_frame = pose.linear().inverse() * shift;
    const DeepestPoint deepest = of_.deepest(moved.translated(in_frame), piece.of_a, piece.least);
    if (isKnown(deepest.distance)) return addTouch(piece, {deepest.way, deepest.way.dot(shift) + deepest.distance});
    addTouches(piece, shift, touch, piece.least);
  }

  /// A translated piece touches the other region for the first time.
  void addTouches(OutlinePart& piece, const Vec2& shift, const Impact& touch, double time) const {
    if (piece.chain.empty()) return addTouch(piece, {touch.normal, touch.normal.dot(shift)});
    for (const Vec2& normal : of_.away(touch, piece.of_a, time)) addTouch(piece, {normal, normal.dot(shift)});
  }

  /// Whether the direction of so short a way is.
  bool isKnown(double distance) const { return distance > near_; }

  static void addTouch(OutlinePart& piece, const Touch& touch) {
    if (piece.touches.size() == kMostTouches) piece.touches.erase(piece.touches.begin());
    piece.touches.push_back(touch);
  }

  /// False where shorter pieces would tell little more: they are no longer than what their depth is below the allowed.
  bool cut(const OutlinePart& piece, double left) {
    if (piece.chain.empty()) {
      addOutlines(piece.least);
      return true;
    }
    const std::size_t count = piece.chain.size(), middle = count / 2;
    OutlinePart first{piece.least, piece.of_a, {}}, second = first;
    if (count > 2) {
      first.chain.assign(piece.chain.begin(), piece.chain.begin() + static_cast<std::ptrdiff_t>(middle) + 1);
      second.chain.assign(piece.chain.begin() + static_cast<std::ptrdiff_t>(middle), piece.chain.end());
    } else {
      const Vec2 &v = piece.chain[0], &w = piece.chain[1], at = 0.5 * v + 0.5 * w;
      if (!((w - v).stableNorm() > std::max(0.25 * left, 4 * of_.precision))) return false;
      first.chain = {v, at};
      second.chain = {at, w};
    }
    pieces_.push(std::move(first));
    pieces_.push(std::move(second));
    return true;
  }

  void addOutlines(double time) {
    if (of_.asks_a) addOutline(of_.a, true, time);
    if (of_.asks_b) addOutline(of_.b, false, time);
  }

  void addOutline(const Polygon& polygon, bool of_a, double time) {
    for (const Ring& ring : polygon.rings()) {
      OutlinePart piece{time, of_a, ring};
      piece.chain.push_back(ring.front());
      pieces_.push(std::move(piece));
    }
  }

  Impact impactAt(double time) const {
    const Depth depth = of_.depth(time);
    return {time, depth.is_point_of_a ? depth.point_a : depth.point_b, depth.normal, depth.edge_a, depth.edge_b};
  }

  const DeepQuestion& of_;
  const double near_;  ///< what times of impact may take for a touch
  BestFirst<OutlinePart> pieces_{kInfinity};
  int steps_ = 0;
};

}  // namespace

std::optional<Impact> findDeepImpact(const DeepQuestion& question) { return DeepImpact(question).find(); }

}  // namespace tricover::detail
