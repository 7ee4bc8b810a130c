// SPDX-License-Identifier: BSD-3-Clause
// timeOfImpact() beside exact collisions: before it they are apart, within the time error they meet; of polygons that
// are only shifted, beside the exact times.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "exact_shifts.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"
#include "tricover/time_of_impact.h"
#include "workloads.h"

namespace tricover::laws {
namespace {

using namespace support;

/// Of positions, as a share of sizes and ways; of times, where ways are not much below the sizes.
constexpr double kRounding = 1e-12;

enum class Kind { Translation, Interpolation, Screw, ManyTurns, Spline };

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
  const Vec2 pivot = random.coin() ? Vec2::Zero() : polygon.coveringOrigin();
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
    const Pose end = random.oneIn(8) ? start : turnedAndMoved(random.real(-3, 3), 0, 0) * start;
    Pose there = end;
    there.translation() = start.translation() + motion.shift;
    return Motion::between(start, there, random.coin() ? Vec2::Zero() : polygon.coveringOrigin());
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
  if (!random.oneIn(3)) return Polygon::point(p);
  return Polygon::segment(p, p + Vec2(random.real(-60, 60), random.real(-60, 60)));
}

MovingCase flightOf(Random& random, Kind kind) {
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

bool collideAt(const MovingCase& f, double time, double margin) {
  CollideOptions options;
  options.margin = margin;
  return collide(f.a, f.motion_a.at(time), f.b, f.motion_b.at(time), options);
}

/// The lengths that rounding is relative to.
double sizeOf(const MovingCase& f) {
  const auto size = [](const Polygon& polygon, const Motion& motion) {
    const double reach = polygon.radius() + (polygon.coveringOrigin() - motion.pivot).norm();
    const double turn = std::abs(motion.angle) + std::abs(motion.angle_2) + std::abs(motion.angle_3);
    return (1 + turn) * reach + motion.shift.norm() + motion.shift_2.norm() + motion.shift_3.norm() +
           motion.start.translation().norm();
  };
  return size(f.a, f.motion_a) + size(f.b, f.motion_b);
}

/// What is wrong with the answer; empty if nothing is.
std::string wrongWith(const MovingCase& f, const std::optional<Impact>& impact, const ImpactOptions& options,
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
std::string wrongFeatures(const MovingCase& f, const Impact& impact, const ImpactOptions& options) {
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

/// Of swapped operands: the same, to the last bit.
std::string wrongSwapped(const MovingCase& f, const std::optional<Impact>& impact, const ImpactOptions& options) {
  const auto swapped = timeOfImpact(f.b, f.motion_b, f.a, f.motion_a, options);
  if (swapped.has_value() != impact.has_value()) return "swapped: another answer";
  return !impact || (impact->time == swapped->time && impact->normal == Vec2(-swapped->normal) &&
                     impact->edge_a == swapped->edge_b && impact->edge_b == swapped->edge_a)
             ? ""
             : "swapped: another impact";
}

std::string told(const MovingCase& f, const std::optional<Impact>& impact, const ImpactOptions& options) {
  return ", time " + (impact ? hex(impact->time) : "none") + ", time error " + hex(options.time_error) + ", margin " +
         hex(options.margin) + "\n" + reproduction(f);
}

void count(Tally& tally, const std::optional<Impact>& impact) {
  tally.count("at once", impact && impact->time == 0);
  tally.count("later", impact && impact->time > 0);
  tally.count("never", !impact);
}

template <Kind kind>
std::string wrongBracket(Random& random, Tally& tally) {
  const MovingCase f = flightOf(random, kind);
  ImpactOptions options;
  options.time_error = random.oneIn(8) ? 0 : std::pow(10, random.real(-9, -3));
  const bool has_disc = std::min(f.a.vertexCount(), f.b.vertexCount()) == 3;
  if (has_disc ? !random.oneIn(4) : random.oneIn(3))
    options.margin = random.oneIn(4) ? 1e-9 : random.real(0, has_disc ? 60 : 20);
  const auto impact = timeOfImpact(f.a, f.motion_a, f.b, f.motion_b, options);
  count(tally, impact);
  std::string wrong = wrongWith(f, impact, options, random);
  if (wrong.empty() && impact) wrong = wrongFeatures(f, *impact, options);
  if (wrong.empty()) wrong = wrongSwapped(f, impact, options);
  if (wrong.empty() && (impact && impact->time == 0) != collideAt(f, 0, options.margin))
    wrong = "time 0 is not collide at the start";
  return wrong.empty() ? wrong : wrong + told(f, impact, options);
}

/// Vertices and ways on a coarse grid: grazes, contacts at the very end, collinear edges, parting from touch.
MovingCase onGrid(Random& random) {
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

/// Of polygons that are only shifted.
std::string wrongShift(Random& random, Tally& tally) {
  const MovingCase f = random.oneIn(8) ? flightOf(random, Kind::Translation) : onGrid(random);
  ImpactOptions options;
  options.time_error = random.oneIn(4) ? 0 : std::pow(10, random.real(-9, -2));
  const auto impact = timeOfImpact(f.a, f.motion_a, f.b, f.motion_b, options);
  count(tally, impact);
  const auto contacts = exact::contactsOfShifts(f.a, f.motion_a, f.b, f.motion_b);
  const mpq_class truth = contacts.empty() ? 2 : contacts[0].begin;
  tally.count("at the end", truth == 1);
  const double error = options.time_error + kRounding * sizeOf(f) / (f.motion_b.shift - f.motion_a.shift).norm();
  const char* wrong = impact.has_value() == contacts.empty() ? "meet or not"
                      : !impact                              ? nullptr
                      : exact::collide(f.a, f.motion_a.start, f.b, f.motion_b.start)
                          ? (impact->time == 0 ? nullptr : "not at once")
                      : mpq_class(impact->time) > truth          ? "too late"
                      : !(impact->time >= truth.get_d() - error) ? "too early"
                                                                 : nullptr;
  return wrong == nullptr ? "" : wrong + told(f, impact, options);
}

/// What may be reported: within 1e-13 of what time_of_impact.h calls L; far from the origin, poses at a time are
/// rounded by more.
double smallOf(const MovingCase& f) {
  const double far = f.motion_a.start.translation().stableNorm() + f.motion_b.start.translation().stableNorm();
  return (f.margin < 0 ? 2 : 1) * (1e-13 * lengthOf(f) + 1e-15 * far);
}

/// No point moves faster.
double speedOf(const Polygon& p, const Motion& m) {
  const double turn = std::abs(m.angle) + std::abs(m.angle_2) + std::abs(m.angle_3);
  return m.shift.stableNorm() + 2 * m.shift_2.stableNorm() + 3 * m.shift_3.stableNorm() +
         3 * turn * (p.radius() + (p.coveringOrigin() - m.pivot).stableNorm());
}

Case at(const MovingCase& f, double time) { return {f.a, f.motion_a.at(time), f.b, f.motion_b.at(time)}; }

/// Whether they are within the margin at this time by more than rounding: `small`.
bool surelyMeet(const MovingCase& f, double time, double small) {
  const Case c = at(f, time);
  if (f.margin < 0) return collide(c.a, c.pose_a, c.b, c.pose_b, {f.margin - small, 0});
  const Reference reference(c);
  if (f.margin > 0) return static_cast<double>(reference.distance().high) <= f.margin - small;
  if (!reference.collide()) return false;
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  return p && p->lower_bound > small;
}

std::string wrongOfAny(Random& random, const MovingCase& f, const std::optional<Impact>& impact, double time_error) {
  const double margin = f.margin, small = smallOf(f);
  const Case start{f.a, f.motion_a.start, f.b, f.motion_b.start};
  const bool at_once =
      margin < 0 ? collide(start.a, start.pose_a, start.b, start.pose_b, {margin, 0}) : Reference(start).within(margin);
  if ((impact && impact->time == 0) != at_once) return "time 0 or not";
  const double until = impact ? impact->time : 1;
  for (int i = 0; i < 12 && until > 0; ++i) {
    const double time = i < 6 ? until * random.unit() : until * (1 - std::pow(10, -random.real(0, 12)));
    if (surelyMeet(f, time, small)) return "they meet before, at " + support::hex(time);
  }
  if (!impact) return surelyMeet(f, 1, small) ? "they meet at the end" : "";
  if (!(impact->time >= 0 && impact->time <= 1)) return "time out of range";
  if (!(std::abs(impact->normal.norm() - 1) < 1e-12)) return "normal isn't of unit length";
  const double way = (speedOf(f.a, f.motion_a) + speedOf(f.b, f.motion_b)) * time_error;
  const Case then = at(f, impact->time);
  if (margin < 0 && !impact->budget_ended &&
      !collide(then.a, then.pose_a, then.b, then.pose_b, {margin + way + small, 0}))
    return "they aren't as deep within the time error";
  if (margin < 0) return {};
  const auto apart = static_cast<double>(Reference(then).distance().low) - margin;
  if (apart > way + small)
    return "they don't come near within the time error: " + support::hex(apart) + " is left of at most " +
           support::hex(way + small);
  return {};
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  MovingCase f = anyFlight(random, c);
  c = {f.a, f.motion_a.start, f.b, f.motion_b.start};
  ImpactOptions options;
  options.time_error = random.oneIn(8) ? 0 : std::pow(10, random.real(-9, -3));
  if (random.oneIn(3)) f.margin = smallerRadius(c) * random.unit();
  if (random.oneIn(6)) f.margin = -smallerRadius(c) * std::pow(10, -random.real(0, 9));
  options.margin = f.margin;
  const double length = lengthOf(f), far = c.pose_a.translation().stableNorm() + c.pose_b.translation().stableNorm();
  if (!(length < 1e300 && length > 1e-300 && far < 1e300)) return {};
  const auto impact = timeOfImpact(f.a, f.motion_a, f.b, f.motion_b, options);
  count(tally, impact);
  std::string problem = wrongOfAny(random, f, impact, options.time_error);
  if (problem.empty() && random.oneIn(4) && !isOneTwice(c)) problem = wrongSwapped(f, impact, options);
  return problem.empty() ? problem : problem + told(f, impact, options);
}

/// Of a few of the smallest doubles.
std::string wrongOfTheSmallest(Random& random, Tally& tally) {
  constexpr double e = std::numeric_limits<double>::denorm_min();
  const auto polygon = [&] {
    Ring ring;
    for (int k = random.integer(3, 5); k > 0; --k)
      ring.emplace_back(e * random.integer(-2, 2), e * random.integer(-2, 2));
    return Polygon({ring});
  };
  const auto start = [&] {
    const double x = e * random.integer(-4, 4), y = e * random.integer(-4, 4);
    return turnedAndMoved(random.coin() ? random.real(0, 6) : 0, x, y);
  };
  const Polygon a = polygon(), b = polygon();
  const Pose at = start();
  Motion motion = Motion::translation(start(), {e, -2 * e});
  if (random.coin()) motion.angle = 1;
  const bool collides = collide(a, at, b, motion.start);
  tally.count("hits", collides);
  const auto impact = timeOfImpact(a, Motion::still(at), b, motion);
  return (impact && impact->time == 0) == collides ? "" : "time 0 is not collide at the start";
}

Laws impactLaws() {
  const Shares shares = {{"at once", 0, 0.5}, {"later", 0.2, 0.8}, {"never", 0.2, 0.8}};
  Laws laws = {{"translations", 6000, wrongBracket<Kind::Translation>, shares},
               {"interpolations", 6000, wrongBracket<Kind::Interpolation>, shares},
               {"screws", 6000, wrongBracket<Kind::Screw>, shares},
               {"many_turns", 6000, wrongBracket<Kind::ManyTurns>, shares},
               {"splines", 6000, wrongBracket<Kind::Spline>, shares},
               {"shifts", 4000, wrongShift, {{"later", 0.2, 0.8}, {"never", 0.2, 0.8}, {"at the end", 0.002, 1}}},
               {"smallest_doubles", 5000, wrongOfTheSmallest, {{"hits", 0.1, 0.5}}}};
  Limits limits;
  limits.most_exponent = 290;
  limits.most_vertices = 24;
  add(laws, anyPairs(limits), 300, wrong, {{"never", 0.02, 0.98}});
  return laws;
}

const Register registered("impact", impactLaws);

}  // namespace
}  // namespace tricover::laws
