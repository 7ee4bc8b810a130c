// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "families.h"
#include "limited_distance.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/least_distance.h"
#include "tricover/ray.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"
#include "tricover/trajectory.h"

namespace tricover::support {

/// A scene beside loops over the functions of pairs: bodies that move by a few ulps, a little or far, come into contact
/// exactly, come and go; with margins and categories.
class SceneWalk {
 public:
  /// Its bodies are of these cases.
  SceneWalk(const std::vector<Case>& cases, std::uint64_t seed, std::size_t bodies) : random_(seed), most_(bodies) {
    for (const Case& c : cases) {
      parts_.push_back({c.a, c.pose_a});
      parts_.push_back({c.b, c.pose_b});
    }
    while (bodies_.size() < most_ * 2 / 3) add(random_.integer(1, most_ > 100 ? 300 : 9));
  }

  void frame() {
    if (random_.oneIn(8)) scene_ = Scene(scene_);
    std::vector<BodyPose> together;
    for (const Scene::Body body : bodies_)
      if (!random_.oneIn(3)) together.push_back({body, moved(body)});
    if (random_.coin()) {
      for (const BodyPose& one : together) scene_.move(one.body, one.pose);
    } else {
      if (!together.empty() && random_.coin()) together.push_back(together.front());
      scene_.move(together, random_.coin() ? backwards : Parallel());
    }
    if (random_.oneIn(6) && bodies_.size() > most_ / 3) remove();
    if (random_.oneIn(6) && bodies_.size() < most_) add(random_.oneIn(4) ? random_.integer(0, 3) : 1);
    if (random_.oneIn(4)) {
      const Scene::Body body = anyBody(random_);
      scene_.setOptions(body, anyOptions(scene_.polygon(body)));
    }
    if (more_.oneIn(4)) {
      const Scene::Body p = anyBody(more_), q = anyBody(more_);
      if (p != q) scene_.setIgnored(p, q, !scene_.isIgnored(q, p));
    }
    if (random_.oneIn(3)) return;  // nobody asks
    collisions();
    switch (random_.integer(0, 3)) {
      case 0:
        return collides();
      case 1:
        nearest();
        std::swap(random_, more_);
        leastDistance();
        return std::swap(random_, more_);
      case 2:
        for (int i = 0; i < 4; ++i) ray();
        return;
      default:
        return impacts();
    }
  }

  std::string wrong;  ///< the first thing that was; empty if there is none
  int asked = 0, hits = 0, began = 0, ended = 0;
  int free = 0, inside = 0, impacts_found = 0, rays = 0, leasts = 0;  ///< of queries

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kLargest = std::numeric_limits<double>::max();

  /// What a body may be: a case's polygon at the pose where it meets the case's other one.
  struct Part {
    Polygon polygon;
    Pose pose;
  };

  const Part& anyPart() { return parts_[index(parts_.size())]; }
  Scene::Body anyBody(Random& random) { return bodies_[index(bodies_.size(), random)]; }
  std::size_t index(std::size_t count) { return index(count, random_); }
  static std::size_t index(std::size_t count, Random& random) {
    return static_cast<std::size_t>(random.integer(0, static_cast<int>(count) - 1));
  }

  /// Of its rings.
  static double sizeOf(const Polygon& polygon) {
    return std::min((polygon.isComplement() ? polygon.complement() : polygon).radius(), 1e305);
  }
  /// A length that matters to a polygon: of its size, or far less.
  double length(const Polygon& polygon) {
    return sizeOf(polygon) * std::pow(10, random_.integer(-12, 0)) * random_.unit();
  }

  BodyOptions anyOptions(const Polygon& polygon) {
    BodyOptions options;
    if (random_.oneIn(3)) options.margin = length(polygon);
    options.category = options.margin > 0 ? 2 : 1;
    if (random_.oneIn(6)) options.mask = random_.coin() ? 1 : 2;
    return options;
  }
  void add(int count) {
    std::vector<BodyPlacement> more;
    for (int i = 0; i < count; ++i) {
      const Part& part = anyPart();
      more.push_back({part.polygon, part.pose, anyOptions(part.polygon)});
    }
    if (count == 1) return bodies_.push_back(scene_.add(more[0].polygon, more[0].pose, more[0].options));
    const std::vector<Scene::Body> added = scene_.add(more);
    bodies_.insert(bodies_.end(), added.begin(), added.end());
  }

  void remove() {
    const auto at = bodies_.begin() + static_cast<std::ptrdiff_t>(index(bodies_.size()));
    scene_.remove(*at);
    bodies_.erase(at);
  }

  /// Beyond others.
  Pose away(Pose pose) {
    const double angle = random_.real(0, 2 * M_PI), way = 3 * random_.unit() * sizeOf(anyPart().polygon);
    const Vec2 moved = pose.translation() + way * Vec2(std::cos(angle), std::sin(angle));
    if (moved.allFinite()) pose.translation() = moved;
    return pose;
  }

  /// A pose near another one.
  Pose near(const Polygon& polygon, Pose pose) {
    const int kind = random_.integer(0, 3);
    const double step = length(polygon);
    Vec2 moved = kind == 0 ? nudged(random_, pose.translation(), 2)
                           : Vec2(pose.translation() + step * Vec2(random_.real(-1, 1), random_.real(-1, 1)));
    if (kind == 1) pose.linear() = Eigen::Rotation2Dd(random_.real(-0.1, 0.1)).toRotationMatrix() * pose.linear();
    if (random_.oneIn(60)) pose = mirrored(pose);
    if (moved.allFinite()) pose.translation() = moved;
    return pose.linear().isUnitary(1e-7) ? pose : scenePose(polygon);  // rotated often, it is none any more
  }
  Pose scenePose(const Polygon& polygon) {
    for (const Part& part : parts_)
      if (part.polygon.id() == polygon.id()) return part.pose;
    return anyPart().pose;
  }

  /// Where a body moves.
  Pose moved(Scene::Body body) {
    const Polygon& polygon = scene_.polygon(body);
    if (random_.oneIn(20)) return away(anyPart().pose);
    if (random_.oneIn(8)) return scenePose(polygon);
    return near(polygon, scene_.pose(body));
  }

  /// Whatever runs the tasks, in whatever order.
  static void backwards(std::size_t count, const std::function<void(std::size_t)>& task) {
    while (count > 0) task(--count);
  }

  void expect(bool right, const std::string& what) {
    ++asked;
    if (right || !wrong.empty()) return;
    wrong = what;
    for (const Scene::Body p : bodies_) wrong += "\nbody " + std::to_string(p) + "\n" + described(p);
  }
  std::string described(Scene::Body body) const {
    const Part part{scene_.polygon(body), scene_.pose(body)};
    return "margin " + hex(scene_.options(body).margin) + "\n" +
           reproduction({part.polygon, part.pose, part.polygon, part.pose});
  }

  static double sum(double p, double q) { return std::min(p + q, kLargest); }
  double marginOf(Scene::Body body) const { return scene_.options(body).margin; }

  bool mayMeet(Scene::Body p, Scene::Body q) const {
    const BodyOptions &of_p = scene_.options(p), &of_q = scene_.options(q);
    return (of_p.category & of_q.mask) != 0 && (of_q.category & of_p.mask) != 0 && !scene_.isIgnored(p, q);
  }

  std::vector<BodyPair> pairs() const {
    std::vector<BodyPair> result;
    for (const Scene::Body p : bodies_)
      for (const Scene::Body q : bodies_)
        if (p < q && mayMeet(p, q)) result.push_back({p, q});
    std::sort(result.begin(), result.end());
    return result;
  }

  void collisions() {
    std::vector<BodyPair> now, news, gone;
    for (const BodyPair& pair : pairs()) {
      CollideOptions options;
      options.margin = sum(marginOf(pair.first), marginOf(pair.second));
      if (collide(scene_.polygon(pair.first), scene_.pose(pair.first), scene_.polygon(pair.second),
                  scene_.pose(pair.second), options))
        now.push_back(pair);
    }
    std::set_difference(now.begin(), now.end(), before_.begin(), before_.end(), std::back_inserter(news));
    std::set_difference(before_.begin(), before_.end(), now.begin(), now.end(), std::back_inserter(gone));
    expect(scene_.collisions(random_.coin() ? backwards : Parallel()) == now, "collisions");
    expect(scene_.began() == news, "began");
    expect(scene_.ended() == gone, "ended");
    before_ = now;
    hits += static_cast<int>(now.size());
    began += static_cast<int>(news.size());
    ended += static_cast<int>(gone.size());
  }

  struct Question {
    const Part& part;
    Pose start;
    BodyFilter filter;
  };
  Question anyQuestion() {
    const Part& part = anyPart();
    const Pose start = random_.coin() ? away(part.pose) : near(part.polygon, part.pose);
    BodyFilter filter;
    if (random_.oneIn(4)) filter.categories = static_cast<std::uint32_t>(random_.integer(1, 2));
    if (random_.oneIn(4)) filter.except = anyBody(random_);
    return {part, start, filter};
  }
  bool passes(const BodyFilter& filter, Scene::Body body) const {
    return (scene_.options(body).category & filter.categories) != 0 && body != filter.except;
  }

  void collides() {
    const auto [part, start, filter] = anyQuestion();
    CollideOptions options;
    if (random_.oneIn(3)) options.margin = length(part.polygon);
    Pose at = start;
    for (int step = 0; step < 6; ++step) {
      std::vector<Scene::Body> expected;
      for (const Scene::Body body : bodies_) {
        CollideOptions both = options;
        both.margin = sum(options.margin, marginOf(body));
        if (passes(filter, body) && collide(part.polygon, at, scene_.polygon(body), scene_.pose(body), both))
          expected.push_back(body);
      }
      std::sort(expected.begin(), expected.end());
      const std::vector<bool> answers = scene_.collides(part.polygon, std::vector<Pose>{at, start}, options, filter);
      const auto any = scene_.anyColliding(part.polygon, at, options, filter);
      expect(any.has_value() == !expected.empty(), "anyColliding");
      expect(!any || std::binary_search(expected.begin(), expected.end(), *any), "anyColliding, which");
      expect(scene_.colliding(part.polygon, at, options, filter) == expected, "colliding");
      expect(scene_.collides(part.polygon, at, options, filter) == !expected.empty(), "collides");
      expect(answers[0] == !expected.empty(), "collides, many poses");
      ++(expected.empty() ? free : inside);
      at = near(part.polygon, at);
      if (random_.oneIn(3)) options.margin *= random_.unit();
    }
  }

  void nearest() {
    const auto [part, at, filter] = anyQuestion();
    LimitedOptions options;
    if (random_.oneIn(3)) options.margin = length(part.polygon);
    if (random_.oneIn(3)) options.limit = length(part.polygon);
    std::vector<std::pair<double, Scene::Body>> expected, found;
    for (const Scene::Body body : bodies_) {
      if (!passes(filter, body)) continue;
      LimitedOptions both = options;
      both.margin = sum(options.margin, marginOf(body));
      const double apart = distance(part.polygon, at, scene_.polygon(body), scene_.pose(body), both).distance;
      if (apart < kInfinity) expected.push_back({apart, body});
    }
    std::sort(expected.begin(), expected.end());
    const auto check = [&](const std::optional<BodyDistance>& nearest, const std::string& what) {
      expect(nearest.has_value() == !expected.empty(), what + ": whether there is one");
      if (nearest && !expected.empty())
        expect(std::pair(nearest->result.distance, nearest->body) == expected.front(), what);
    };
    check(scene_.nearestWithin(part.polygon, at, options.limit, options, filter), "nearest");
    const auto count = index(6);
    for (const BodyDistance& near : scene_.nearestK(part.polygon, at, count, options.limit, options, filter))
      found.push_back({near.result.distance, near.body});
    if (expected.size() > count) expected.resize(count);
    expect(found == expected, "nearestK");
    if (options.limit < kInfinity || count == 0) return;
    check(scene_.nearest(part.polygon, at, options, filter), "nearest without a limit");
    check(scene_.nearest(part.polygon, std::vector<Pose>{part.pose, at}, options, filter)[1], "nearest of many poses");
  }

  /// Of a way among the bodies, beside a loop.
  void leastDistance() {
    const auto [part, start, filter] = anyQuestion();
    const Motion way = anyMotion(part.polygon, start);
    LeastDistanceOptions options;
    options.absolute_error = sizeOf(part.polygon) * 1e-3;
    if (!(options.absolute_error > 0)) return;
    std::optional<std::pair<double, Scene::Body>> expected;
    for (const Scene::Body body : bodies_) {
      if (!passes(filter, body)) continue;
      LeastDistanceOptions both = options;
      both.margin = sum(options.margin, marginOf(body));
      const LeastDistance least =
          tricover::leastDistance(part.polygon, way, scene_.polygon(body), Motion::still(scene_.pose(body)), both);
      const std::pair found(least.distance, body);
      if (!expected || found < *expected) expected = found;
    }
    const auto found = scene_.leastDistance(part.polygon, way, options, filter);
    expect(found.has_value() == expected.has_value(), "leastDistance: whether there is one");
    if (!found || !expected) return;
    expect(std::pair(found->least.distance, found->body) == *expected, "leastDistance");
    expect(found->least.lower_bound <= found->least.distance, "leastDistance: bound");
    ++leasts;
  }

  /// Margins aren't met exactly: see Scene::castRay().
  void ray() {
    const Scene::Body p = anyBody(random_), q = anyBody(random_);
    const Vec2 from = pointOf(p), to = random_.coin() ? pointOf(q) : Vec2(from + 2 * (pointOf(q) - from));
    if (!from.allFinite() || !to.allFinite()) return;
    const Scene::Body except = random_.oneIn(4) ? anyBody(random_) : kNoBody;
    std::optional<BodyRayHit> expected;
    std::vector<Scene::Body> sorted = bodies_;
    std::sort(sorted.begin(), sorted.end());
    std::multiset<std::tuple<Scene::Body, double, double>> parts, expected_parts;
    for (const Scene::Body body : sorted) {
      if (marginOf(body) > 0 || body == except) continue;
      const auto hit = castRay(scene_.polygon(body), scene_.pose(body), from, to);
      for (const RayInterval& part : castRayAll(scene_.polygon(body), scene_.pose(body), from, to))
        expected_parts.emplace(body, part.begin.fraction, part.end.fraction);
      if (hit && (!expected || hit->fraction < expected->hit.fraction)) expected = BodyRayHit{body, *hit};
    }
    double last = 0;
    for (const BodyRayInterval& part : scene_.castRayAll(from, to, {}, {1, except})) {
      expect(last <= part.interval.begin.fraction, "castRayAll: order");
      last = part.interval.begin.fraction;
      if (marginOf(part.body) <= 0) parts.emplace(part.body, part.interval.begin.fraction, part.interval.end.fraction);
    }
    expect(parts == expected_parts, "castRayAll: intervals");
    const auto hit = scene_.castRay(from, to, {}, {1, except});
    expect(hit.has_value() == expected.has_value(), "castRay: whether there is one");
    if (!hit || !expected) return;
    expect(hit->body == expected->body && hit->hit.edge == expected->hit.edge &&
               hit->hit.fraction == expected->hit.fraction && hit->hit.point == expected->hit.point &&
               hit->hit.normal == expected->hit.normal,
           "castRay from " + text(from) + " to " + text(to) + ": " + text(*hit) + ", truth " + text(*expected));
    if (hit->hit.edge >= 0) ++rays;
  }
  static std::string text(const Vec2& p) { return "(" + hex(p.x()) + ", " + hex(p.y()) + ")"; }
  static std::string text(const BodyRayHit& hit) {
    return "body " + std::to_string(hit.body) + " at " + hex(hit.hit.fraction) + ", edge " +
           std::to_string(hit.hit.edge);
  }
  Vec2 pointOf(Scene::Body body) {
    const Polygon& polygon = scene_.polygon(body);
    const Vec2 v = polygon.edgeStart(anyEdge(random_, polygon)), s = polygon.coveringOrigin();
    return scene_.pose(body) * (s + random_.integer(0, 8) / 4.0 * (v - s));
  }

  Motion anyMotion(const Polygon& polygon, const Pose& start) {
    Motion motion = Motion::still(start);
    const double way = 4 * length(polygon);
    motion.pivot = polygon.coveringOrigin();
    motion.shift = way * Vec2(random_.real(-1, 1), random_.real(-1, 1));
    if (random_.coin()) motion.angle = random_.real(-2, 2);
    if (random_.oneIn(3)) motion.shift_2 = -motion.shift;
    return motion;
  }

  /// Legs and waits by a clock, one after the other.
  Trajectory anyTrajectory(const Polygon& polygon, const Pose& start) {
    std::vector<Leg> legs;
    double time = random_.integer(-2, 2);
    Pose pose = start;
    for (int i = random_.integer(1, 4); i > 0; --i) {
      const double begin = time;
      time += random_.oneIn(3) ? 1 : random_.real(0.25, 2);
      legs.push_back({begin, time, random_.oneIn(4) ? Motion::still(pose) : anyMotion(polygon, pose)});
      pose = legs.back().motion.at(1);
    }
    return Trajectory(std::move(legs));
  }

  void impacts() {
    ImpactOptions options;
    options.time_error = 1e-3;
    options.ignore_initial = random_.oneIn(4);
    const Part& part = anyPart();
    if (random_.oneIn(3)) options.margin = length(part.polygon);
    const Pose start = near(part.polygon, part.pose);
    if (random_.coin()) {
      firstImpact(part.polygon, anyMotion(part.polygon, start), options);
      if (!random_.coin()) return;
      const auto moving = someMoving<BodyMotion>(&SceneWalk::anyMotion);
      allImpacts(moving, options);
      allConflicts(moving, options);
    } else {
      firstImpact(part.polygon, anyTrajectory(part.polygon, start), options);
      if (random_.coin()) return;
      const auto moving = someMoving<BodyTrajectory>(&SceneWalk::anyTrajectory);
      allImpacts(moving, options);
      allConflicts(moving, options);
    }
  }

  static Motion rest(const Motion&, const Pose& pose) { return Motion::still(pose); }
  static Trajectory rest(const Trajectory& other, const Pose& pose) {
    return Trajectory({{other.begin(), other.end(), Motion::still(pose)}});
  }
  static const Motion& wayOf(const BodyMotion& moving) { return moving.motion; }
  static const Trajectory& wayOf(const BodyTrajectory& moving) { return moving.trajectory; }

  /// Margins are added in the order of the scene: the query's, then the bodies'.
  template <typename Way>
  void firstImpact(const Polygon& polygon, const Way& way, const ImpactOptions& options) {
    BodyFilter filter;
    if (random_.oneIn(4)) filter.except = anyBody(random_);
    const auto impact = scene_.firstImpact(polygon, way, options, filter);
    double first = kInfinity;
    Scene::Body hit = 0;
    for (const Scene::Body body : bodies_) {
      if (!passes(filter, body)) continue;
      ImpactOptions both = options;
      both.margin = sum(options.margin, marginOf(body));
      const auto found = timeOfImpact(polygon, way, scene_.polygon(body), rest(way, scene_.pose(body)), both);
      if (!found || found->time > first || (found->time == first && body > hit)) continue;
      first = found->time;
      hit = body;
    }
    expect(impact.has_value() == (first < kInfinity), "firstImpact: whether there is one");
    if (impact) expect(impact->impact.time == first && impact->body == hit, "firstImpact");
  }

  template <typename Moving, typename AnyWay>
  std::vector<Moving> someMoving(AnyWay anyWay) {
    std::vector<Moving> motions;
    for (const Scene::Body body : bodies_)
      if (random_.oneIn(3)) motions.push_back({body, (this->*anyWay)(scene_.polygon(body), scene_.pose(body))});
    return motions;
  }

  /// ask(pair, polygon, way, polygon, way, options) of all pairs of which one moves.
  template <typename Moving, typename Ask>
  void forEachMovingPair(const std::vector<Moving>& motions, const ImpactOptions& options, const Ask& ask) {
    const auto motionOf = [&](Scene::Body body) {
      const auto at = std::find_if(motions.begin(), motions.end(), [&](const Moving& m) { return m.body == body; });
      return at != motions.end() ? &*at : nullptr;
    };
    for (const BodyPair& pair : pairs()) {
      const Moving *p = motionOf(pair.first), *q = motionOf(pair.second);
      if (p == nullptr && q == nullptr) continue;
      ImpactOptions both = options;
      both.margin = sum(sum(options.margin, marginOf(pair.first)), marginOf(pair.second));
      ask(pair, scene_.polygon(pair.first), p != nullptr ? wayOf(*p) : rest(wayOf(*q), scene_.pose(pair.first)),
          scene_.polygon(pair.second), q != nullptr ? wayOf(*q) : rest(wayOf(*p), scene_.pose(pair.second)), both);
    }
  }

  template <typename Moving>
  void allImpacts(const std::vector<Moving>& motions, const ImpactOptions& options) {
    std::vector<std::pair<double, BodyPair>> expected, found;
    forEachMovingPair(motions, options, [&](const BodyPair& pair, const auto&... operands) {
      if (const auto impact = timeOfImpact(operands...)) expected.push_back({impact->time, pair});
    });
    std::sort(expected.begin(), expected.end());
    for (const PairImpact& impact : scene_.impacts(motions, options))
      found.push_back({impact.impact.time, impact.pair});
    expect(found == expected, "impacts");
    impacts_found += static_cast<int>(found.size());
  }

  template <typename Moving>
  void allConflicts(const std::vector<Moving>& motions, const ImpactOptions& options) {
    std::vector<std::tuple<double, BodyPair, double>> expected, found;
    forEachMovingPair(motions, options, [&](const BodyPair& pair, const auto&... operands) {
      for (const Conflict& span : conflicts(operands...)) expected.emplace_back(span.impact.time, pair, span.end);
    });
    std::sort(expected.begin(), expected.end());
    for (const auto& [pair, span] : scene_.conflicts(motions, options))
      found.emplace_back(span.impact.time, pair, span.end);
    expect(found == expected, "conflicts");
  }

  Random random_, more_{1};  ///< the second for questions that leave the first one's draws as they were
  std::size_t most_;
  std::vector<Part> parts_;
  Scene scene_;
  std::vector<Scene::Body> bodies_;
  std::vector<BodyPair> before_;
};

}  // namespace tricover::support
