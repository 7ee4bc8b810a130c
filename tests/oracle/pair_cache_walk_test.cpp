// SPDX-License-Identifier: BSD-3-Clause
// The law of the pair cache: along any walk, whatever the cache saw, its answer is the cold one (and the exact one).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "exact_reference.h"
#include "family_makers.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "strategies.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

constexpr int kWalks = 60;
constexpr int kSteps = 150;

struct Walker {
  Case c;
  double size;    ///< the unit that lengths of the motion are measured in
  double margin;  ///< of the current step
};

/// How one kind of walk takes its next step.
struct Kind {
  const char* name;
  void (*step)(Random& random, Walker& walker, int i);
};

/// Slowly across a, into and out of its hole, and past it.
void slow(Random& random, Walker& w, int i) {
  const double t = i * 0.02 + random.unit() * 1e-3;
  w.c.pose_b.translation() = w.c.pose_a.translation() + 3.2 * w.size * Vec2(std::cos(t), std::sin(2.3 * t));
  turn(w.c.pose_b, 0.003);
}

/// Along the contact, by steps from an ulp to a thousandth, never far from touching.
void sliding(Random& random, Walker& w, int) {
  const double length = w.size * std::pow(10, random.integer(-16, -3));
  w.c.pose_b.translation() += length * direction(random.real(0, 6.3));
  if (random.oneIn(12)) w.c = atFirstContact(random, w.c, 4 * w.size * direction(random.real(0, 6.3)), 1);
}

/// On the spot, by angles from 1e-12 to a tenth; now and then from another spot.
void rotating(Random& random, Walker& w, int i) {
  if (i % 40 == 0) w.c.pose_b.translation() = w.c.pose_a.translation() + 2 * w.size * direction(random.real(0, 6.3));
  turn(random.coin() ? w.c.pose_a : w.c.pose_b, random.real(-1, 1) * std::pow(10, random.integer(-12, -1)));
}

void jumping(Random& random, Walker& w, int) {
  w.c.pose_b = randomPose(random, 3.5 * w.size);
  w.c.pose_b.translation() += w.c.pose_a.translation();
  if (random.oneIn(4)) w.c.pose_b = mirrored(w.c.pose_b);
  if (random.oneIn(4)) w.c.pose_b = distorted(random, w.c.pose_b);
}

/// Hardly moving, but for what R misses of a rotation by: near the limit of what is rigid.
void distorting(Random& random, Walker& w, int i) {
  if (i % 30 == 0) w.c = atFirstContact(random, w.c, 4 * w.size * direction(random.real(0, 6.3)), 1);
  const double angle = std::atan2(w.c.pose_b.linear()(1, 0), w.c.pose_b.linear()(0, 0));
  w.c.pose_b.linear() = distorted(random, pose(angle, 0, 0)).linear();
}

/// Both carried by a frame that turns, so that their relative pose only changes by rounding, and a little by b's own.
void carried(Random& random, Walker& w, int) {
  const Pose frame = randomPose(random, w.size);
  w.c.pose_b.translation() += w.size * random.real(-0.05, 0.05) * direction(random.real(0, 6.3));
  w.c.pose_a = frame * w.c.pose_a;
  w.c.pose_b = frame * w.c.pose_b;
}

/// Both carried on, and one of them mirrored now and then: where both have moved, only the relative pose tells.
void flipping(Random& random, Walker& w, int i) {
  if (i % 20 == 0) w.c.pose_b.translation() = w.c.pose_a.translation() + 2 * w.size * direction(random.real(0, 6.3));
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

constexpr Kind kKinds[] = {
    {"slow", slow},       {"sliding", sliding},       {"rotating", rotating}, {"jumping", jumping},
    {"carried", carried}, {"distorting", distorting}, {"flipping", flipping}, {"changing_margin", changingMargin}};

std::vector<Ring> walkerRings(Random& random, bool with_hole) {
  if (!with_hole) return {anyRing(random)};
  return {star(random, 9, 3, 4), regular(random.integer(3, 8), 2.2)};
}

Walker walker(Random& random) {
  const double sizes[] = {1, 1, 1, 1e-150, 1e150, 1e300, 1e-300}, size = sizes[random.integer(0, 6)];
  const auto polygon = [&](bool with_hole) {
    std::vector<Ring> rings = walkerRings(random, with_hole);
    for (Ring& ring : rings) ring = scaled(std::move(ring), size);
    return Polygon(rings);
  };
  Pose pose_a = anyPose(random);
  pose_a.translation() *= size * (random.oneIn(4) ? 1e12 : 1);
  Pose pose_b = pose_a;
  if (!pose_a.matrix().allFinite() || pose_a.translation().norm() > 1e305) pose_a = pose_b = Pose::Identity();
  pose_b.translation() += Vec2(1.5 * size, 0);
  return {{polygon(random.coin()), pose_a, polygon(random.oneIn(4)), pose_b}, size, 0};
}

struct Tally {
  int steps = 0, hits = 0, disagreements = 0;
};

/// `shared` are caches that other walks use as well.
void check(const Walker& w, StrategyCaches& own, StrategyCaches& shared, bool swapped, Tally& tally) {
  const Case& c = w.c;
  const bool truth = w.margin == 0 ? exact::collide(c.a, c.pose_a, c.b, c.pose_b)
                                   : exact::within(exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b), w.margin);
  ++tally.steps;
  tally.hits += truth;
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const CollideOptions options{w.margin};
    const auto ask = [&](StrategyCaches& cache) {
      return swapped ? collide(strategy, c.b, c.pose_b, c.a, c.pose_a, cache, options)
                     : collide(strategy, c.a, c.pose_a, c.b, c.pose_b, cache, options);
    };
    const bool cold = collide(strategy, c.a, c.pose_a, c.b, c.pose_b, options), cached = ask(own);
    const bool again = ask(own), mixed = ask(shared);
    if (cold == truth && cached == truth && again == truth && mixed == truth) continue;
    if (++tally.disagreements <= 2) {
      ADD_FAILURE() << "step " << tally.steps << ", cold " << cold << ", cached " << cached << ", cached again "
                    << again << ", shared by pairs " << mixed << ", truth " << truth << ", margin " << hex(w.margin)
                    << ", " << nameOf(strategy) << "\n"
                    << reproduction(c);
    }
  }
}

class PairCacheWalk : public testing::TestWithParam<Kind> {};

TEST_P(PairCacheWalk, EveryCachedAnswerIsTheColdOne) {
  Tally tally;
  StrategyCaches shared;
  for (int walk = 0; walk < scaledCount(kWalks); walk += 2) {
    // Two walks in turns, so that the shared caches change pairs at every step.
    Random random(static_cast<std::uint64_t>(walk));
    Walker walkers[] = {walker(random), walker(random)};
    StrategyCaches caches[2];
    for (int i = 0; i < kSteps; ++i) {
      for (int k = 0; k < 2; ++k) {
        GetParam().step(random, walkers[k], i);
        check(walkers[k], caches[k], shared, random.oneIn(3), tally);
      }
    }
  }
  std::printf("%-16s %6d steps %6d hits %4d disagreements\n", GetParam().name, tally.steps, tally.hits,
              tally.disagreements);
  EXPECT_EQ(tally.disagreements, 0);
  EXPECT_GE(tally.hits, 0.15 * tally.steps);
  EXPECT_LE(tally.hits, 0.85 * tally.steps);
}

std::string kindName(const testing::TestParamInfo<Kind>& kind) { return kind.param.name; }

INSTANTIATE_TEST_SUITE_P(Kinds, PairCacheWalk, testing::ValuesIn(kKinds), kindName);

}  // namespace
}  // namespace tricover::support
