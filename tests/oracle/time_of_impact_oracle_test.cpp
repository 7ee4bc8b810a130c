// SPDX-License-Identifier: BSD-3-Clause
// Times of impact against exact collide() at many poses on the way, and for translations against the exact first
// contact of vertices and edges.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "exact_shifts.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/segment.h"
#include "tricover/time_of_impact.h"
#include "workloads.h"

namespace tricover::support {
namespace {

/// Of positions, as a share of sizes and ways; of times, where ways are not much below the sizes.
constexpr double kRounding = 1e-12;

enum class Kind { Translation, Interpolation, Screw, ManyTurns, Spline };

struct Flight {
  Polygon a;
  Motion motion_a;
  Polygon b;
  Motion motion_b;
};

/// About 50 units in radius.
Polygon anyPolygon(Random& random) {
  const auto& kinds = workloads::allKinds();
  // Few vertices and convex: these go another way.
  if (random.oneIn(3))
    return workloads::makePolygon(random.coin() ? workloads::Kind::Convex : workloads::Kind::Slim,
                                  static_cast<std::size_t>(2 * random.integer(4, 8)), random.bits());
  // So do others of few vertices.
  if (random.oneIn(3))
    return workloads::makePolygon(
        kinds[static_cast<std::size_t>(random.integer(0, static_cast<int>(kinds.size()) - 1))],
        static_cast<std::size_t>(2 * random.integer(4, 8)), random.bits());
  const int choice = random.integer(0, static_cast<int>(kinds.size()) + 2);
  if (choice < static_cast<int>(kinds.size()))
    return workloads::makePolygon(kinds[static_cast<std::size_t>(choice)],
                                  static_cast<std::size_t>(2 * random.integer(5, 24)), random.bits());
  if (choice == static_cast<int>(kinds.size()))
    return Polygon({scaled(star(random, random.integer(3, 9), 0.1, 1), 50)});
  if (choice == static_cast<int>(kinds.size()) + 1) return Polygon({shifted(comb(4, 20, 8, 40), {-34, -20})});
  return Polygon({scaled(regular(24, 1), 90), scaled(regular(24, 1), 70)});  // a ring
}

/// From `start`, on the whole by `way`, any way round.
Motion anySpline(Random& random, const Pose& start, const Vec2& way, const Polygon& polygon) {
  const Vec2 pivot = random.coin() ? Vec2::Zero() : polygon.origin();
  const auto velocity = [&] {
    return random.oneIn(4) ? Vec2(Vec2::Zero()) : Vec2(way + Vec2(random.real(-300, 300), random.real(-300, 300)));
  };
  const auto rate = [&] { return random.oneIn(4) ? 0 : random.real(-12, 12); };
  Motion motion;
  if (random.coin()) {
    const Vec2 from = start * pivot;
    const double turn = random.oneIn(4) ? 0 : random.real(-6, 6);
    motion = Motion::spline({from, 0, velocity(), rate()}, {from + way, turn, velocity(), rate()}, pivot);
  } else {
    std::array<Vec2, 4> positions;
    std::array<double, 4> angles;
    for (std::size_t k = 0; k < 4; ++k) {
      positions[k] = start * pivot + 1.5 * way * random.unit() + velocity();
      angles[k] = 2 * rate();
    }
    motion = Motion::spline(positions, angles, pivot);
  }
  if (random.coin()) motion.start.linear() = start.linear();
  return motion;
}

/// Ways, mostly towards the middle, and turns of a size that lets about half of the pairs meet.
Motion anyMotion(Random& random, Kind kind, const Pose& start, const Polygon& polygon) {
  const Vec2 aside(random.real(-80, 80), random.real(-80, 80));
  Motion motion = Motion::translation(start, aside - random.real(0, 1.5) * start.translation());
  if (kind == Kind::Translation) return motion;
  if (kind == Kind::Interpolation) {
    const Pose end = random.oneIn(8) ? start : pose(random.real(-3, 3), 0, 0) * start;
    Pose there = end;
    there.translation() = start.translation() + motion.shift;
    return Motion::between(start, there, random.coin() ? Vec2::Zero() : polygon.origin());
  }
  if (kind == Kind::Spline) return anySpline(random, start, motion.shift, polygon);
  if (random.coin()) motion.pivot = Vec2(random.real(-100, 100), random.real(-100, 100));
  motion.angle = random.real(-6, 6) * (kind == Kind::ManyTurns ? 10 : 1);
  if (random.coin()) motion.shift = Vec2::Zero();
  return motion;
}

/// A point or a segment, with its frame's origin on it or not.
Polygon anyDegenerate(Random& random) {
  const Vec2 p = random.coin() ? Vec2(Vec2::Zero()) : Vec2(random.real(-40, 40), random.real(-40, 40));
  if (!random.oneIn(3)) return point(p);
  return segment(p, p + Vec2(random.real(-60, 60), random.real(-60, 60)));
}

Flight anyFlight(Random& random, Kind kind) {
  Polygon a = anyPolygon(random), b = anyPolygon(random);
  if (random.oneIn(3)) b = anyDegenerate(random);
  if (random.oneIn(6)) a = anyDegenerate(random);
  Pose start_a = randomPose(random, 20), start_b = randomPose(random, 200);
  if (random.oneIn(5)) start_a = mirrored(start_a);
  if (random.oneIn(5)) start_b = distorted(random, start_b);
  const Motion motion_b = anyMotion(random, kind, start_b, b);
  const Motion motion_a = random.coin() ? Motion::still(start_a) : anyMotion(random, kind, start_a, a);
  return {a, motion_a, b, motion_b};
}

bool collideAt(const Flight& f, double time, double margin) {
  CollideOptions options;
  options.margin = margin;
  return collide(f.a, f.motion_a.at(time), f.b, f.motion_b.at(time), options);
}

/// The lengths that rounding is relative to.
double sizeOf(const Flight& f) {
  const auto size = [](const Polygon& polygon, const Motion& motion) {
    const double reach = polygon.radius() + (polygon.origin() - motion.pivot).norm();
    const double turn = std::abs(motion.angle) + std::abs(motion.angle_2) + std::abs(motion.angle_3);
    return (1 + turn) * reach + motion.shift.norm() + motion.shift_2.norm() + motion.shift_3.norm() +
           motion.start.translation().norm();
  };
  return size(f.a, f.motion_a) + size(f.b, f.motion_b);
}

/// What is wrong with the answer; empty if nothing is.
std::string wrongWith(const Flight& f, const std::optional<Impact>& impact, const ImpactOptions& options,
                      Random& random) {
  const double before = impact ? impact->time - kRounding : 1, margin = options.margin;
  constexpr int kSamples = 400;
  for (int i = 0; i <= kSamples; ++i) {
    const double time = i == 0 ? 0 : (i - random.unit()) / kSamples;
    if (time < before && collideAt(f, time, margin)) return "collides before, at " + std::to_string(time);
  }
  if (!impact) return collideAt(f, 1, margin) ? "collides at the end" : "";
  for (double ahead = 1e-12; ahead < 1e-2; ahead *= 4)
    if (impact->time - ahead > 0 && collideAt(f, impact->time - ahead, margin)) return "collides just before";
  if (impact->time < 0 || impact->time > 1) return "time out of range";
  for (int i = 0; i <= 50; ++i)
    if (collideAt(f, impact->time + i * 0.02 * options.time_error, margin + kRounding * sizeOf(f))) return "";
  return "no collision within the time error";
}

/// Point and normal say how the edges come together: moved against each other by what is left of the gap, and a hair
/// more, they touch.
std::string wrongFeatures(const Flight& f, const Impact& impact, const ImpactOptions& options) {
  if (!(std::abs(impact.normal.norm() - 1) < 1e-12)) return "normal isn't of unit length";
  const double near = 3 * sizeOf(f) * (options.time_error + 1e-7) + options.margin;
  const auto offEdge = [&](const Polygon& polygon, const Pose& at, EdgeIndex edge) {
    if (edge < 0) return 0.0;
    return exact::distanceBelow(
        exact::distanceSquared(impact.point, at * polygon.edgeStart(edge), at * polygon.edgeEnd(edge)));
  };
  if (offEdge(f.a, f.motion_a.at(impact.time), impact.edge_a) > near) return "point isn't near a's edge";
  if (offEdge(f.b, f.motion_b.at(impact.time), impact.edge_b) > near) return "point isn't near b's edge";
  if (impact.time > 0 && (impact.edge_a < 0 || impact.edge_b < 0)) return "no edges";
  return "";
}

class TimeOfImpactOracle : public testing::TestWithParam<Kind> {};

TEST_P(TimeOfImpactOracle, BracketsTheFirstCollision) {
  const int cases = scaledCount(6000);
  int overlaps = 0, impacts = 0, failures = 0;
  for (int i = 0; i < cases && failures < 5; ++i) {
    Random random(static_cast<std::uint64_t>(i) * 4 + static_cast<std::uint64_t>(GetParam()));
    const Flight f = anyFlight(random, GetParam());
    ImpactOptions options;
    options.time_error = random.oneIn(8) ? 0 : std::pow(10, random.real(-9, -3));
    const bool has_disc = std::min(f.a.vertexCount(), f.b.vertexCount()) == 3;
    if (has_disc ? !random.oneIn(4) : random.oneIn(3))
      options.margin = random.oneIn(4) ? 1e-9 : random.real(0, has_disc ? 60 : 20);
    const auto impact = timeOfImpact(f.a, f.motion_a, f.b, f.motion_b, options);
    const auto swapped = timeOfImpact(f.b, f.motion_b, f.a, f.motion_a, options);
    overlaps += impact && impact->time == 0;
    impacts += impact && impact->time > 0;
    std::string wrong = wrongWith(f, impact, options, random);
    if (wrong.empty() && impact) wrong = wrongFeatures(f, *impact, options);
    if (impact.has_value() != swapped.has_value())
      wrong += ", swapped: another answer";
    else if (impact && (impact->time != swapped->time || impact->normal != Vec2(-swapped->normal) ||
                        impact->edge_a != swapped->edge_b || impact->edge_b != swapped->edge_a))
      wrong += ", swapped: another impact";
    if ((impact && impact->time == 0) != collideAt(f, 0, options.margin))
      wrong += ", time 0 is not collide at the start";
    if (wrong.empty()) continue;
    ++failures;
    ADD_FAILURE() << "case " << i << ": " << wrong << ", time " << (impact ? impact->time : -1) << ", time error "
                  << options.time_error << ", margin " << options.margin;
  }
  std::printf("%d cases, %d overlap at the start, %d impacts later\n", cases, overlaps, impacts);
  if (cases < 100) return;
  EXPECT_GT(impacts, cases / 5);
  EXPECT_GT(cases - impacts - overlaps, cases / 5);
  EXPECT_LT(overlaps, cases / 2);
}

std::string kindName(const testing::TestParamInfo<Kind>& kind) {
  constexpr const char* kNames[] = {"Translation", "Interpolation", "Screw", "ManyTurns", "Spline"};
  return kNames[static_cast<int>(kind.param)];
}

INSTANTIATE_TEST_SUITE_P(Motions, TimeOfImpactOracle,
                         testing::Values(Kind::Translation, Kind::Interpolation, Kind::Screw, Kind::ManyTurns,
                                         Kind::Spline),
                         kindName);

/// The first contact of polygons that are only shifted.
std::optional<mpq_class> firstContact(const Flight& f) {
  const auto contacts = exact::contactsOfShifts(f.a, f.motion_a, f.b, f.motion_b);
  return contacts.empty() ? std::nullopt : std::optional<mpq_class>(contacts[0].begin);
}

/// Vertices and ways on a coarse grid: grazes, contacts at the very end, collinear edges, parting from touch.
Flight onGrid(Random& random) {
  const auto coordinate = [&](int low, int high) { return 0.25 * random.integer(4 * low, 4 * high); };
  const auto polygon = [&] {
    if (random.coin()) {
      const double x = random.integer(1, 3), y = random.integer(1, 3);
      return Polygon({rectangle(-x, -y, x, y)});
    }
    Ring ring = star(random, random.integer(3, 8), 1, 4);
    for (Vec2& v : ring) v = v.array().round();
    return Polygon({ring});
  };
  Polygon a = polygon(), b = polygon();
  Pose start = Pose::Identity();
  if (random.coin()) start.linear() << 0, -1, 1, 0;
  start.translation() = Vec2(coordinate(-10, 10), coordinate(-10, 10));
  Vec2 shift = Vec2(coordinate(-4, 4), coordinate(-4, 4)) - 0.25 * random.integer(0, 8) * start.translation();
  if (random.oneIn(3)) shift[random.integer(0, 1)] = 0;
  Vec2 other = Vec2::Zero();
  if (random.coin()) other = Vec2(coordinate(-3, 3), coordinate(-3, 3));
  return {a, Motion::translation(Pose::Identity(), other), b, Motion::translation(start, shift)};
}

TEST(TimeOfImpactExact, TranslationsMeetWhenTheyExactlyDo) {
  const int cases = scaledCount(4000);
  int impacts = 0, misses = 0, overlaps = 0, at_end = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 99);
    const Flight f = i % 8 == 0 ? anyFlight(random, Kind::Translation) : onGrid(random);
    ImpactOptions options;
    options.time_error = random.oneIn(4) ? 0 : std::pow(10, random.real(-9, -2));
    const auto impact = timeOfImpact(f.a, f.motion_a, f.b, f.motion_b, options);
    if (exact::collide(f.a, f.motion_a.start, f.b, f.motion_b.start)) {
      ++overlaps;
      ASSERT_TRUE(impact && impact->time == 0) << "case " << i;
      continue;
    }
    const auto truth = firstContact(f);
    ASSERT_EQ(impact.has_value(), truth.has_value()) << "case " << i;
    ++(truth ? impacts : misses);
    if (!truth) continue;
    at_end += *truth == 1;
    ASSERT_TRUE(mpq_class(impact->time) <= *truth) << "case " << i << ": " << impact->time << " " << truth->get_d();
    const double way = (f.motion_b.shift - f.motion_a.shift).norm();
    ASSERT_GE(impact->time, truth->get_d() - options.time_error - kRounding * sizeOf(f) / way)
        << "case " << i << " time error " << options.time_error;
  }
  std::printf("%d cases, %d overlap at the start, %d meet later, %d of them at time 1\n", cases, overlaps, impacts,
              at_end);
  if (cases < 400) return;
  EXPECT_GT(impacts, cases / 5);
  EXPECT_GT(misses, cases / 5);
  EXPECT_GT(at_end, cases / 500);
}

}  // namespace
}  // namespace tricover::support
