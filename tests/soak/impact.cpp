// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "cases.h"
#include "contact_laws.h"
#include "least_distance_laws.h"
#include "reproduction.h"
#include "shapes.h"
#include "soak.h"
#include "tricover/collide.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"

namespace tricover::soak {
namespace {

struct Flight {
  Case start;  ///< poses at time 0
  Motion motion_a, motion_b;
  ImpactOptions options;
};

/// Through `pose` at some time, or at rest there.
Motion anyMotion(Random& random, const Polygon& polygon, const Pose& pose, double reach) {
  Motion motion = Motion::still(pose);
  if (random.oneIn(4)) return motion;
  const auto way = [&] {
    return Vec2(reach * std::pow(10, random.real(-2, 1)) * Vec2(random.real(-1, 1), random.real(-1, 1)));
  };
  motion.shift = way();
  if (random.coin()) {
    motion.angle = random.real(-1, 1) * (random.oneIn(4) ? 30 : 3);
    motion.pivot = random.coin() ? polygon.origin() : random.coin() ? Vec2(Vec2::Zero()) : way();
    if (random.oneIn(4)) motion.shift.setZero();
  }
  if (random.oneIn(4)) {
    motion.shift_2 = way();
    motion.shift_3 = way();
    motion.angle_2 = motion.angle == 0 ? 0 : random.real(-3, 3);
  }
  const double t = random.unit(), turn = t * motion.angle + t * t * motion.angle_2;
  motion.start.linear() = support::pose(-turn, 0, 0).linear() * pose.linear();
  motion.start.translation() = pose * motion.pivot - t * motion.shift - t * t * motion.shift_2 -
                               t * t * t * motion.shift_3 - motion.start.linear() * motion.pivot;
  return motion;
}

double turnOf(const Motion& m) { return std::abs(m.angle) + std::abs(m.angle_2) + std::abs(m.angle_3); }
double reachOf(const Polygon& p, const Motion& m) { return p.radius() + (p.origin() - m.pivot).stableNorm(); }

/// No point moves faster.
double speedOf(const Polygon& p, const Motion& m) {
  return m.shift.stableNorm() + 2 * m.shift_2.stableNorm() + 3 * m.shift_3.stableNorm() + 3 * turnOf(m) * reachOf(p, m);
}

/// What time_of_impact.h calls L, of one of the two.
double lengthOf(const Polygon& p, const Motion& m) {
  return m.shift.stableNorm() + m.shift_2.stableNorm() + m.shift_3.stableNorm() + m.pivot.stableNorm() +
         (1 + turnOf(m)) * reachOf(p, m);
}

Case at(const Flight& f, double time) {
  Case c = f.start;
  c.pose_a = f.motion_a.at(time);
  c.pose_b = f.motion_b.at(time);
  return c;
}

/// Whether they are within the margin at this time by more than rounding: `small`.
bool surelyMeet(const Flight& f, double time, double small) {
  const Case c = at(f, time);
  if (f.options.margin < 0) return collide(c.a, c.pose_a, c.b, c.pose_b, {f.options.margin - small, 0});
  const Reference reference(c);
  if (f.options.margin > 0) return static_cast<double>(reference.distance().high) <= f.options.margin - small;
  if (!reference.collide()) return false;
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  return p && p->lower_bound > small;
}

std::string wrongWith(Random& random, const Flight& f, const std::optional<Impact>& impact, double small) {
  const double margin = f.options.margin;
  const bool at_once = margin < 0 ? collide(f.start.a, f.start.pose_a, f.start.b, f.start.pose_b, {margin, 0})
                                  : Reference(f.start).within(margin);
  if ((impact && impact->time == 0) != at_once) return "time 0 or not";
  const double until = impact ? impact->time : 1;
  for (int i = 0; i < 12 && until > 0; ++i) {
    const double time = i < 6 ? until * random.unit() : until * (1 - std::pow(10, -random.real(0, 12)));
    if (surelyMeet(f, time, small)) return "they meet before, at " + support::hex(time);
  }
  if (!impact) return surelyMeet(f, 1, small) ? "they meet at the end" : "";
  if (!(impact->time >= 0 && impact->time <= 1)) return "time out of range";
  if (!(std::abs(impact->normal.norm() - 1) < 1e-12)) return "normal isn't of unit length";
  const double way = (speedOf(f.start.a, f.motion_a) + speedOf(f.start.b, f.motion_b)) * f.options.time_error;
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

}  // namespace

/// timeOfImpact() by its laws: before it they are apart, within the time error they meet, in both orders alike.
void soakImpact(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    Limits limits;
    limits.most_exponent = 290;
    limits.most_vertices = 24;
    const Drawn drawn = anyCase(random, limits);
    const double reach = drawn.c.a.radius() + drawn.c.b.radius();
    Flight f{drawn.c,
             anyMotion(random, drawn.c.a, drawn.c.pose_a, reach),
             anyMotion(random, drawn.c.b, drawn.c.pose_b, reach),
             {}};
    f.start.pose_a = f.motion_a.start;
    f.start.pose_b = f.motion_b.start;
    f.options.time_error = random.oneIn(8) ? 0 : std::pow(10, random.real(-9, -3));
    if (random.oneIn(3)) f.options.margin = drawn.size * random.unit();
    if (random.oneIn(6)) f.options.margin = -drawn.size * std::pow(10, -random.real(0, 9));
    const double length = std::abs(f.options.margin) +
                          (f.start.pose_a.translation() - f.start.pose_b.translation()).stableNorm() +
                          lengthOf(f.start.a, f.motion_a) + lengthOf(f.start.b, f.motion_b);
    // Beyond, whatever may come near may be reported; far from the origin, poses at a time are rounded by more.
    const double far = f.start.pose_a.translation().stableNorm() + f.start.pose_b.translation().stableNorm();
    if (!(length < 1e300 && length > 1e-300 && far < 1e300)) continue;
    double small = 1e-13 * length + 1e-15 * far;
    if (f.options.margin < 0) small *= 2;
    const auto impact = timeOfImpact(f.start.a, f.motion_a, f.start.b, f.motion_b, f.options);
    run.count(drawn.family, impact.has_value());
    std::string problem = wrongWith(random, f, impact, small);
    if (random.oneIn(4) && !support::isOneTwice(f.start)) {
      const auto swapped = timeOfImpact(f.start.b, f.motion_b, f.start.a, f.motion_a, f.options);
      if (swapped.has_value() != impact.has_value() ||
          (impact && (impact->time != swapped->time || impact->normal != -swapped->normal)))
        problem += " swapped, the result differs";
    }
    if (problem.empty() && random.oneIn(8) && drawn.size > 1e-100 && length < 1e100) {
      LeastDistanceOptions least;
      least.error = drawn.size * std::pow(10, -random.real(1, 9));
      least.margin = std::max(f.options.margin, 0.0);
      problem = support::wrongLeastDistance(f.start.a, f.motion_a, f.start.b, f.motion_b, least,
                                            leastDistance(f.start.a, f.motion_a, f.start.b, f.motion_b, least), 12);
    }
    if (problem.empty()) continue;
    run.fail(drawn.family,
             problem + ", time " + (impact ? support::hex(impact->time) : "none") + ", time error " +
                 support::hex(f.options.time_error) + ", margin " + support::hex(f.options.margin),
             support::reproduction(f.start) + support::reproduction("motion_a", f.motion_a) +
                 support::reproduction("motion_b", f.motion_b));
  }
}

}  // namespace tricover::soak
