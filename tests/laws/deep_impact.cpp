// SPDX-License-Identifier: BSD-3-Clause
// Impacts and conflicts with a negative margin of convex polygons that are only shifted: their times are roots of
// linear functions.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "families.h"
#include "law.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/conflicts.h"
#include "tricover/time_of_impact.h"

namespace tricover::laws {
namespace {

using namespace support;

using Real = long double;

struct Interval {
  Real begin, end;
};
struct Spot {
  Real x, y;
};
using Outline = std::vector<Spot>;

Outline outlineOf(const Ring& ring) {
  Outline result;
  for (const Vec2& p : ring) result.push_back({p.x(), p.y()});
  return result;
}

/// What is at least `deep` inside of a convex ring that runs counter-clockwise.
Outline inner(const Outline& ring, Real deep) {
  Outline left = ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Spot &v = ring[i], &w = ring[(i + 1) % ring.size()];
    const Real x = v.y - w.y, y = w.x - v.x, length = std::hypot(x, y);
    if (length == 0) continue;
    const auto height = [&](const Spot& p) { return (x * (p.x - v.x) + y * (p.y - v.y)) / length - deep; };
    Outline cut;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const Spot &p = left[k], &q = left[(k + 1) % left.size()];
      const Real at_p = height(p), at_q = height(q);
      if (at_p >= 0) cut.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
        const Real share = at_p / (at_p - at_q);
        cut.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
      }
    }
    left = cut;
  }
  return left;
}

/// The time in which b, translated by `from` and t times `way`, meets a; empty if begin >= end.
Interval meeting(const Outline& a, const Outline& b, const Vec2& from, const Vec2& way) {
  Interval time{0, 1};
  if (a.size() < 3 || b.size() < 3) return {0, -1};
  const auto cut = [&](const Outline& own, const Outline& other, Real sign) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Spot &v = own[i], &w = own[(i + 1) % own.size()];
      const Real x = w.y - v.y, y = v.x - w.x, length = std::hypot(x, y);
      if (length == 0) continue;
      Real least = std::numeric_limits<Real>::infinity();
      for (const Spot& p : other) least = std::min(least, (x * (p.x - v.x) + y * (p.y - v.y)) / length);
      // Outwards from this face the other polygon is lowest at `least`, and moves by sign * n . (from + t way).
      const Real at_start = -(least + sign * (x * from.x() + y * from.y()) / length);
      const Real rate = -sign * (x * way.x() + y * way.y()) / length;
      if (rate == 0) {
        if (at_start <= 0) time.end = -1;
      } else if (rate > 0) {
        time.begin = std::max(time.begin, -at_start / rate);
      } else {
        time.end = std::min(time.end, -at_start / rate);
      }
    }
  };
  cut(a, b, 1);
  cut(b, a, -1);
  return time;
}

/// The times in which either has a point `deep` inside of the other one, in order.
std::vector<Interval> deepIntervals(const Ring& a, const Ring& b, const Vec2& from, const Vec2& way, Real deep) {
  const Outline p = outlineOf(a), q = outlineOf(b);
  std::vector<Interval> all;
  for (const Interval& time : {meeting(inner(p, deep), q, from, way), meeting(p, inner(q, deep), from, way)})
    if (time.begin < time.end) all.push_back(time);
  if (all.size() == 2 && all[1].begin < all[0].begin) std::swap(all[0], all[1]);
  if (all.size() == 2 && all[1].begin <= all[0].end) {
    all[0].end = std::max(all[0].end, all[1].end);
    all.pop_back();
  }
  return all;
}

/// Whether rounding may change how many there are.
bool isDelicate(const std::vector<Interval>& surely, const std::vector<Interval>& maybe) {
  if (surely.size() != maybe.size()) return true;
  for (const Interval& time : maybe)
    if (time.end - time.begin < 1e-9) return true;
  return maybe.size() == 2 && maybe[1].begin - maybe[0].end < 1e-2;
}

/// Of those that are told, the k-th one is from and until when it is, but for the error.
std::string wrongSpan(const Conflict& found, const Interval& surely, const Interval& maybe, double error,
                      double slack) {
  if (found.budget_ended) return "a budget ended";
  if (found.impact.time > static_cast<double>(surely.begin) + slack) return "too late";
  if (found.impact.time < static_cast<double>(maybe.begin) - error - slack) return "too early";
  if (found.end < static_cast<double>(surely.end) - slack) return "ends too early";
  return found.end <= std::min(1.0, static_cast<double>(maybe.end) + std::max(error, 1e-9) + slack) ? ""
                                                                                                    : "ends too late";
}

std::string wrongWith(Random& random, Tally& tally, const MovingCase& c, const Ring& a, const Ring& b) {
  const Vec2 from = c.motion_b.start.translation(), way = c.motion_b.shift;
  const Real allowed = -c.margin;
  const double slack = 1e-11 / way.norm(), error = std::pow(10, -random.integer(2, 12));
  const auto deep = deepIntervals(a, b, from, way, allowed), surely = deepIntervals(a, b, from, way, allowed + 1e-11L),
             maybe = deepIntervals(a, b, from, way, allowed - 1e-11L);
  const bool is_delicate = isDelicate(surely, maybe) || deep.size() != maybe.size();
  tally.count("left out", is_delicate);
  if (is_delicate) return {};
  const ImpactOptions options{c.margin, error};
  const auto impact = random.coin() ? timeOfImpact(c.a, c.motion_a, c.b, c.motion_b, options)
                                    : timeOfImpact(c.b, c.motion_b, c.a, c.motion_a, options);
  const auto found = conflicts(c.a, c.motion_a, c.b, c.motion_b, options);
  const Interval touch = meeting(outlineOf(a), outlineOf(b), from, way);
  const bool touches = touch.begin < touch.end;
  tally.count("apart", deep.empty() && !touches);
  tally.count("overlaps that are allowed", deep.empty() && touches);
  tally.count("at once", !deep.empty() && deep[0].begin == 0);
  tally.count("later", !deep.empty() && deep[0].begin != 0);
  if (impact.has_value() == deep.empty()) return "whether there is an impact";
  if (found.size() != deep.size()) return "how many conflicts";
  std::string wrong;
  if (impact)
    wrong = wrongSpan({*impact, static_cast<double>(surely[0].end), impact->budget_ended}, surely[0], maybe[0], error,
                      slack);
  for (std::size_t k = 0; k < deep.size() && wrong.empty(); ++k)
    wrong = wrongSpan(found[k], surely[k], maybe[k], error, slack);
  return wrong;
}

std::string wrong(Random& random, Tally& tally) {
  const Ring a = anyConvex(random, 1, 16), b = anyConvex(random, random.coin() ? 1 : 0.3, 16);
  const Vec2 through(random.real(-2, 2), random.real(-2, 2)), way(random.real(-6, 6), random.real(-6, 6));
  // Half of them start in each other.
  const Vec2 from = through - random.real(0, random.coin() ? 1.2 : 0.2) * way;
  const double allowed = random.coin() ? std::pow(10, random.real(-9, -1)) : random.real(0.01, 0.5);
  const MovingCase c{Polygon(a), Motion::still(Pose::Identity()), Polygon(b),
                     Motion::translation(tricover::poseAt(from.x(), from.y()), way), -allowed};
  const std::string problem = wrongWith(random, tally, c, a, b);
  return problem.empty() ? problem : problem + "\n" + reproduction(c);
}

Laws deepImpactLaws() {
  return {{"convex_shifts",
           4000,
           wrong,
           {{"apart", 0.05, 0.9},
            {"overlaps that are allowed", 0.05, 0.9},
            {"at once", 0.05, 0.9},
            {"later", 0.05, 0.9},
            {"left out", 0, 0.05}}}};
}

const Register registered("deep_impact", deepImpactLaws);

}  // namespace
}  // namespace tricover::laws
