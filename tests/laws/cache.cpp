// SPDX-License-Identifier: BSD-3-Clause
// Walks of two pairs in turns: with caches of their own, and with one that both use, all answers are the cold ones bit
// for bit, and collide() is exact.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "family_makers.h"
#include "law.h"
#include "pairs.h"
#include "polygon/cache_access.h"
#include "queries.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "strategies.h"
#include "tricover/penetration.h"

namespace tricover::laws {
namespace {

using namespace support;

struct Walker {
  Case c;
  double size;    ///< the unit that lengths of the motion are measured in
  double margin;  ///< of the current step
  Vec2 along = Vec2::Zero();
};

/// How one kind of walk takes its next step.
struct Kind {
  const char* name;
  void (*step)(Random& random, Walker& walker, int i);
};

/// b to so many sizes from a.
void leap(Random& random, Walker& w, double sizes) {
  w.c.pose_b.translation() = w.c.pose_a.translation() + sizes * w.size * direction(random.real(0, 6.3));
}

/// Slowly across a, into and out of its hole, and past it.
void slow(Random& random, Walker& w, int i) {
  const double t = i * 0.02 + random.unit() * 1e-3;
  w.c.pose_b.translation() = w.c.pose_a.translation() + 4 * w.size * Vec2(std::cos(t), std::sin(2.3 * t));
  turn(w.c.pose_b, 0.003);
}

/// By steps from an ulp to a tenth, both polygons.
void creeping(Random& random, Walker& w, int i) {
  if (i % 50 == 0) leap(random, w, random.real(2, 4.5));
  Pose& moving = random.oneIn(3) ? w.c.pose_a : w.c.pose_b;
  moving.translation() += w.size * std::pow(10, random.integer(-16, -1)) * direction(random.real(0, 6.3));
  if (random.coin()) turn(moving, random.real(-1, 1) * std::pow(10, random.integer(-12, -1)));
}

/// Along the contact, by steps from an ulp to a thousandth, never far from touching.
void sliding(Random& random, Walker& w, int) {
  const double length = w.size * std::pow(10, random.integer(-16, -3));
  w.c.pose_b.translation() += length * direction(random.real(0, 6.3));
  if (random.oneIn(12)) w.c = atFirstContact(random, w.c, 4 * w.size * direction(random.real(0, 6.3)), 1);
}

/// As a body that rests on another: out of it until they only just overlap, then along the way across.
void resting(Random& random, Walker& w, int i) {
  if (i % 60 == 0) {
    leap(random, w, random.real(0.1, 4));
    w.along = direction(random.real(0, 6.3));
    if (const auto deep = penetration(w.c.a, w.c.pose_a, w.c.b, w.c.pose_b); deep && deep->optimal) {
      w.c.pose_b.translation() += 0.97 * deep->translation;
      w.along = Vec2(-deep->normal.y(), deep->normal.x());
    }
  }
  w.c.pose_b.translation() += 0.004 * w.size * w.along;
  if (random.oneIn(4)) turn(random.coin() ? w.c.pose_a : w.c.pose_b, 0.001);
}

/// On the spot, by angles from 1e-12 to a tenth; now and then from another spot.
void rotating(Random& random, Walker& w, int i) {
  if (i % 40 == 0) leap(random, w, random.real(1.5, 3));
  turn(random.coin() ? w.c.pose_a : w.c.pose_b, random.real(-1, 1) * std::pow(10, random.integer(-12, -1)));
}

void jumping(Random& random, Walker& w, int) {
  w.c.pose_b = randomPose(random, 3.5 * w.size);
  w.c.pose_b.translation() += w.c.pose_a.translation();
  if (random.oneIn(4)) w.c.pose_b = mirrored(w.c.pose_b);
  if (random.oneIn(4)) w.c.pose_b = distorted(random, w.c.pose_b);
}

/// Through an outline between two queries: nothing is near before and after, and yet they overlap now.
void hopping(Random& random, Walker& w, int) { leap(random, w, random.real(0, 5)); }

/// Hardly moving, but for what R misses of a rotation by: near the limit of what is rigid.
void distorting(Random& random, Walker& w, int i) {
  if (i % 30 == 0) w.c = atFirstContact(random, w.c, 4 * w.size * direction(random.real(0, 6.3)), 1);
  const double angle = std::atan2(w.c.pose_b.linear()(1, 0), w.c.pose_b.linear()(0, 0));
  w.c.pose_b.linear() = distorted(random, turnedAndMoved(angle, 0, 0)).linear();
}

/// Both carried by a frame that turns, so that their relative pose only changes by rounding, and a little by b's own.
void carried(Random& random, Walker& w, int i) {
  if (i % 60 == 0) leap(random, w, random.real(1, 5));
  const Pose frame = randomPose(random, w.size);
  w.c.pose_b.translation() += w.size * random.real(-0.05, 0.05) * direction(random.real(0, 6.3));
  w.c.pose_a = frame * w.c.pose_a;
  w.c.pose_b = frame * w.c.pose_b;
}

/// Both carried on, and one of them mirrored now and then: where both have moved, only the relative pose tells.
void flipping(Random& random, Walker& w, int i) {
  if (i % 20 == 0) leap(random, w, random.real(1, 4));
  const Vec2 shift = 0.3 * w.size * direction(random.real(0, 6.3));
  w.c.pose_a.translation() += shift;
  w.c.pose_b.translation() += shift;
  if (!random.oneIn(4)) return;
  Pose& flipped = random.coin() ? w.c.pose_a : w.c.pose_b;
  flipped.linear().col(random.integer(0, 1)) *= -1;
}

/// The question itself changes from step to step, while b drifts.
void changingMargin(Random& random, Walker& w, int i) {
  w.c.pose_b.translation() = w.c.pose_a.translation() + (0.4 + 0.035 * i) * w.size * direction(0.01 * i);
  w.margin = random.coin() ? 0 : w.size * random.real(0, 4);
}

/// By an ulp or a jump.
void stepping(Random& random, Walker& w, int) { step(random, w.c); }

constexpr Kind kKinds[] = {{"slow", slow},
                           {"creeping", creeping},
                           {"sliding", sliding},
                           {"resting", resting},
                           {"rotating", rotating},
                           {"jumping", jumping},
                           {"hopping", hopping},
                           {"carried", carried},
                           {"distorting", distorting},
                           {"flipping", flipping},
                           {"changing_margin", changingMargin},
                           {"stepping", stepping}};

/// Convex, with a hole, of up to 40 vertices, or any.
std::vector<Ring> walkerRings(Random& random) {
  switch (random.integer(0, 3)) {
    case 0:
      return {eitherWay(random, anyConvex(random, 2))};
    case 1:
      return {star(random, 9, 3, 4), regular(random.integer(3, 8), 2.2)};
    case 2:
      return {star(random, random.integer(12, 40), 1, 2)};
    default:
      return {anyRing(random)};
  }
}

Walker walker(Random& random, bool is_of_any_shape) {
  if (is_of_any_shape) {
    const Case c = anyCase(random);
    return {c, smallerRadius(c), 0};
  }
  const double sizes[] = {1, 1, 1, 1e-150, 1e150, 1e300, 1e-300}, size = sizes[random.integer(0, 6)];
  const auto polygon = [&](double part) {
    std::vector<Ring> rings = walkerRings(random);
    for (Ring& ring : rings) ring = scaled(std::move(ring), part * size);
    return Polygon(rings);
  };
  Pose pose_a = anyPose(random);
  pose_a.translation() *= size * (random.oneIn(4) ? 1e12 : 1);
  Pose pose_b = random.coin() ? pose_a : randomPose(random, 0);
  if (!pose_a.matrix().allFinite() || pose_a.translation().norm() > 1e305) pose_a = pose_b = Pose::Identity();
  pose_b.translation() = pose_a.translation() + Vec2(1.5 * size, 0);
  const Polygon a = polygon(1);
  return {{a, pose_a, random.oneIn(8) ? a : polygon(random.coin() ? 0.5 : 1), pose_b}, size, 0};
}

/// Of collide() by both strategies, without a cache and with these.
std::string wrongCollide(const Walker& w, StrategyCaches& own, StrategyCaches& shared, bool swapped, bool truth) {
  const Case& c = w.c;
  const CollideOptions options{w.margin};
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const auto ask = [&](StrategyCaches& cache) {
      return swapped ? collide(strategy, c.b, c.pose_b, c.a, c.pose_a, cache, options)
                     : collide(strategy, c.a, c.pose_a, c.b, c.pose_b, cache, options);
    };
    const std::string name = nameOf(strategy);
    if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, options) != truth) return name + " cold";
    if (ask(own) != truth) return name + " cached";
    if (ask(own) != truth) return name + " again";
    if (ask(shared) != truth) return name + " with a cache that pairs share";
  }
  return {};
}

/// Distances, of which walks see most, or any other query that takes a cache.
const Query& anyQuery(Random& random) {
  static const std::vector<const Query*> cached = [] {
    std::vector<const Query*> result;
    for (const Query& query : queries())
      if (query.alike != nullptr) result.push_back(&query);
    return result;
  }();
  return *cached[random.coin() ? 1 : static_cast<std::size_t>(random.integer(0, static_cast<int>(cached.size()) - 1))];
}

std::string wrongStep(Random& random, const Walker& w, StrategyCaches& own, StrategyCaches& shared, Tally& tally) {
  const Reference reference(w.c);
  const bool truth = w.margin == 0 ? reference.collide() : reference.within(w.margin);
  const detail::PairCacheContents& kept = detail::contentsOf(own.of_pair);
  const std::uint32_t uses = kept.collision.uses;
  std::string wrong = wrongCollide(w, own, shared, random.oneIn(3), truth);
  tally.count("hits", truth);
  tally.count("by certificates", kept.collision.uses > uses);
  const Query& query = anyQuery(random);
  for (PairCache* cache : {&own.of_pair, &shared.of_pair}) {
    const double margin = random.oneIn(4) ? w.size * random.real(0, 2) : w.margin;
    if (wrong.empty()) wrong = wrongWithCache(w.c, query, {margin, random.oneIn(3), cache});
  }
  tally.count("with hints", kept.distance.kind != 0 && !kept.distance.back_off.isOn());
  return wrong;
}

std::string wrongWalks(Random& random, Tally& tally, const Kind& kind) {
  const bool is_of_any_shape = kind.step == stepping;
  Walker walkers[] = {walker(random, is_of_any_shape), walker(random, is_of_any_shape)};
  if (is_of_any_shape && random.oneIn(3)) walkers[1].c.a = walkers[0].c.a;
  StrategyCaches caches[2], shared;
  for (int i = 0; i < (is_of_any_shape ? 80 : 300); ++i)
    for (int k = 0; k < 2; ++k) {
      Walker& w = walkers[k];
      kind.step(random, w, i);
      const std::string wrong = wrongStep(random, w, caches[k], shared, tally);
      if (!wrong.empty())
        return "step " + std::to_string(i) + ": " + wrong + ", margin " + hex(w.margin) + "\n" + reproduction(w.c);
    }
  return {};
}

/// Of so many corners that most searches are long enough for a cache.
Polygon longOutline(Random& random, int least_corners) {
  std::vector<Ring> rings = {star(random, random.integer(least_corners, least_corners == 12 ? 40 : 56), 0.4, 1)};
  if (random.oneIn(3)) rings.push_back(scaled(star(random, random.integer(4, 9), 0.5, 1), 0.3));
  if (random.oneIn(4)) std::reverse(rings[0].begin(), rings[0].end());
  return Polygon(rings);
}

/// How a body goes on from pose to pose.
void slideOrTurn(Random& random, int manner, double length, const Vec2& along, Case& c) {
  if (manner != 1) c.pose_b.translation() += length * along;
  if (manner == 1 || manner == 2) turn(c.pose_b, 0.3 * length);
  if (manner == 3) turn(c.pose_a, 0.1 * length);
  if (random.oneIn(12)) c.pose_b.translation() -= 5 * length * along;
  if (random.oneIn(30)) c.pose_b.translation() = c.pose_a.translation() + 0.3 * direction(random.real(0, 6.3));
}

/// Of penetrations: with a cache that lasts, with copies of it, old ones, too, and with copies about other polygons.
std::string wrongPenetrations(Random& random, Tally& tally, PairCache& cache, int least_corners) {
  const Polygon first = longOutline(random, least_corners);
  const Pose pose_a = randomPose(random, 3);
  Case c{first, pose_a, longOutline(random, least_corners), randomPose(random, 0)};
  if (random.oneIn(4)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(6)) c.pose_a = mirrored(c.pose_a);
  if (random.oneIn(6)) c.pose_b = throughFloat(c.pose_b);
  if (random.oneIn(8)) c.pose_a.translation() += Vec2(1e6, -1e6);
  const Vec2 along = direction(random.real(0, 6.3));
  const bool is_kept = least_corners == 12;  // as it was drawn then
  const double apart = !is_kept && random.oneIn(6) ? random.real(1, 2) : random.real(0.1, 0.8);
  c.pose_b.translation() = c.pose_a.translation() + apart * direction(random.real(0, 6.3));
  const double margin = random.oneIn(6) ? 0.05 : 0;
  const int manner = random.integer(0, 5);
  const double length = std::exp2(random.real(-12, -4));
  const Query& query = *std::find_if(queries().begin(), queries().end(),
                                     [](const Query& q) { return std::string(q.name) == "penetration"; });
  Random of_other(7);
  const Polygon other({star(of_other, 20, 0.4, 1)});
  PairCache old = cache;
  for (int i = 0; i < 24; ++i) {
    const Case asked = random.oneIn(4) ? Case{c.b, c.pose_b, c.a, c.pose_a} : c;
    PairCache copies[] = {cache, cache, old};
    if (i == 10) old = cache;
    std::string wrong = wrongWithCache(asked, query, {margin, false, &cache});
    if (i % 6 == 0) {
      tally.count("hits", penetration(c.a, c.pose_a, c.b, c.pose_b).has_value());
      if (wrong.empty()) wrong = wrongWithCache({other, c.pose_a, c.b, c.pose_b}, query, {margin, false, &copies[0]});
      if (wrong.empty()) wrong = wrongWithCache({c.a, c.pose_a, other, c.pose_b}, query, {margin, false, &copies[1]});
      if (wrong.empty()) wrong = wrongWithCache(asked, query, {margin, false, &copies[2]});
    }
    if (!wrong.empty()) return wrong + "\n" + reproduction(asked);
    slideOrTurn(random, manner, length, along, c);
  }
  return {};
}

std::string wrongTwoPenetrations(Random& random, Tally& tally) {
  PairCache cache;
  const std::string wrong = wrongPenetrations(random, tally, cache, 20);
  return wrong.empty() ? wrongPenetrations(random, tally, cache, 20) : wrong;
}

/// What is nearest in one square was found in another.
std::string wrongKeptPenetrations(Random&, Tally& tally) {
  std::string wrong;
  for (const std::uint64_t seed : {1593, 230}) {
    Random random(seed);
    PairCache cache;
    if (wrong.empty()) wrong = wrongPenetrations(random, tally, cache, 12);
  }
  return wrong;
}

Laws cacheLaws() {
  Laws laws = {{"penetrations", 150, wrongTwoPenetrations, {{"hits", 0.5, 0.98}}},
               {"kept_penetrations", 1, wrongKeptPenetrations, {}}};
  for (const Kind& kind : kKinds) {
    const bool jumps = kind.step == jumping || kind.step == hopping;
    laws.push_back(
        {kind.name,
         kind.step == stepping ? 60 : 30,
         [&kind](Random& random, Tally& tally) { return wrongWalks(random, tally, kind); },
         {{"hits", 0.15, 0.85}, {"by certificates", jumps ? 0 : 0.02, 1}, {"with hints", jumps ? 0 : 0.1, 1}}});
  }
  return laws;
}

const Register registered("cache", cacheLaws);

}  // namespace
}  // namespace tricover::laws
