// SPDX-License-Identifier: BSD-3-Clause
// conflicts() and timeOfImpact() of bodies that start in contact, or a few roundings beside it, and of contact that
// lasts.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "exact_shifts.h"
#include "families.h"
#include "law.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/conflicts.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"

namespace tricover::laws {
namespace {

using namespace support;

std::vector<exact::TimeInterval> contactsOf(const MovingCase& c, const mpq_class& margin) {
  return exact::contactsOfShifts(c.a, c.motion_a, c.b, c.motion_b, margin);
}

/// In order, without those that touch.
std::vector<exact::TimeInterval> merged(const std::vector<exact::TimeInterval>& all) {
  std::vector<exact::TimeInterval> result;
  for (const exact::TimeInterval& interval : all) {
    if (result.empty() || interval.begin > result.back().end)
      result.push_back(interval);
    else if (interval.end > result.back().end)
      result.back().end = interval.end;
  }
  return result;
}

bool isContact(const Conflict& c, const mpq_class& time) {
  return mpq_class(c.impact.time) <= time && time <= mpq_class(c.end);
}

/// In order, between 0 and 1, and never at their budget.
std::string wrongOrder(const std::vector<Conflict>& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].budget_ended) return "a budget ended";
    if (!(0 <= found[i].impact.time && found[i].impact.time <= found[i].end && found[i].end <= 1)) return "no interval";
    if (i > 0 && !(found[i].impact.time > found[i - 1].end)) return "not in order";
  }
  return {};
}

std::string at(const char* what, const mpq_class& time) { return std::string(what) + " at " + hex(time.get_d()); }

/// What is left without the initial contact, and the first impact.
std::string wrongLater(const MovingCase& c, const ImpactOptions& options, const std::vector<Conflict>& found,
                       const std::vector<Conflict>& later, bool starts_in_contact, double seen) {
  const std::size_t left_out = starts_in_contact && !found.empty() && found[0].impact.time == 0 ? 1 : 0;
  if (later.size() + left_out != found.size()) return "more or less than the initial one is left out";
  for (std::size_t i = 0; i < later.size(); ++i)
    if (std::abs(later[i].impact.time - found[i + left_out].impact.time) > seen)
      return "others without the initial one";
  const auto impact = timeOfImpact(c.a, c.motion_a, c.b, c.motion_b, options);
  if (impact.has_value() == later.empty()) return "time of impact or not";
  if (impact && std::abs(impact->time - later[0].impact.time) > seen) return "time of impact";
  return {};
}

Case caseAt(const MovingCase& c, double time) { return {c.a, c.motion_a.at(time), c.b, c.motion_b.at(time)}; }

/// No point of one moves faster against the other one.
double speedOf(const MovingCase& c) {
  const auto speed = [](const Polygon& p, const Motion& m) {
    const double reach = p.radius() + (p.coveringOrigin() - m.pivot).stableNorm();
    return m.shift.stableNorm() + 2 * m.shift_2.stableNorm() + 3 * m.shift_3.stableNorm() +
           (std::abs(m.angle) + 2 * std::abs(m.angle_2) + 3 * std::abs(m.angle_3)) * reach;
  };
  return speed(c.a, c.motion_a) + speed(c.b, c.motion_b);
}

Polygon anyOnGrid(Random& random) {
  switch (random.integer(0, 6)) {
    case 0:
      return random.coin() ? Polygon::segment({-2, 0}, {2, 0}) : Polygon::point({0, 0});
    case 1: {
      Ring ring = star(random, random.integer(3, 8), 1, 4);
      for (Vec2& v : ring) v = v.array().round();
      return Polygon({ring});
    }
    case 2:
      return Polygon({comb(random.integer(2, 4), 2, 1, 2)});
    case 3:  // straight vertices, and a pocket
      return Polygon({{{-4, -1}, {4, -1}, {4, 0}, {2, 0}, {2, -0.5}, {1, -0.5}, {1, 0}, {0, 0}, {-3, 0}, {-4, 0}}});
    case 4:
      if (random.coin()) return Polygon({rectangle(-5, -1, -2, 0), rectangle(1, -1, 2, 0), rectangle(4, -2, 5, 3)});
      return Polygon({rectangle(-5, -1, 5, 0), rectangle(-5, 2, 5, 3)});
    case 5:  // of sides whose lengths are integers
      return Polygon({{{0, 0}, {4, 3}, {1, 7}, {-3, 4}}});
    default:
      return Polygon({rectangle(-random.integer(1, 4), -random.integer(1, 2), random.integer(1, 4), 1)});
  }
}

void count(Tally& tally, bool at_begin, const std::vector<Conflict>& found, const std::vector<Conflict>& later) {
  tally.count("at begin", at_begin);
  tally.count("later", !later.empty());
  tally.count("none", found.empty());
  tally.count("lasting",
              std::any_of(found.begin(), found.end(), [](const Conflict& f) { return f.end - f.impact.time > 0.1; }));
}

/// What is wrong with the intervals in which polygons that are only shifted meet, with what is left without the initial
/// one, and with the times of impact.
std::string wrongWithShifts(const MovingCase& c, double error, Tally& tally) {
  const mpq_class margin = c.margin, length = lengthOf(c);
  const std::vector<exact::TimeInterval> truth = contactsOf(c, margin),
                                         wide = contactsOf(c, margin + length * mpq_class("1/10000000000000"));
  ImpactOptions options;
  options.margin = c.margin;
  options.time_error = error;
  const std::vector<Conflict> found = conflicts(c.a, c.motion_a, c.b, c.motion_b, options);
  const double seen = std::max(error, 1e-9) * (1 + 1e-6);
  std::string wrong = wrongOrder(found);
  if (!wrong.empty()) return wrong;
  for (const exact::TimeInterval& interval : truth)
    if (std::none_of(found.begin(), found.end(),
                     [&](const Conflict& f) { return isContact(f, interval.begin) && isContact(f, interval.end); }))
      return at("missed", interval.begin);
  // Nothing is told for longer than the error but what comes within rounding.
  std::vector<exact::TimeInterval> may_be = wide;
  for (exact::TimeInterval& interval : may_be) interval.begin -= seen, interval.end += seen;
  may_be = merged(may_be);
  for (const Conflict& f : found)
    if (std::none_of(may_be.begin(), may_be.end(), [&](const exact::TimeInterval& interval) {
          return interval.begin <= f.impact.time && f.end <= interval.end;
        }))
      return at("apart", mpq_class(f.impact.time));
  options.ignore_initial = true;
  const std::vector<Conflict> later = conflicts(c.a, c.motion_a, c.b, c.motion_b, options);
  const bool starts_in_contact = !truth.empty() && truth[0].begin == 0;
  if (starts_in_contact || wide.empty() || wide[0].begin > 0)
    wrong = wrongLater(c, options, found, later, starts_in_contact, seen);
  if (!wrong.empty()) return wrong;
  // The separation itself is none: what is told later is another contact.
  const auto near = contactsOf(c, margin + length * mpq_class("1/1000000000000000"));
  if (!later.empty() && !near.empty() && near[0].begin == 0) {
    const auto next = std::find_if(wide.begin(), wide.end(), [](const exact::TimeInterval& i) { return i.begin > 0; });
    if (next == wide.end() || next->begin > later[0].end + seen) return at("the separation", later[0].impact.time);
  }
  count(tally, starts_in_contact, found, later);
  return {};
}

/// The same of any motions, beside exact distances at so many times: where they surely meet they are told to, and where
/// they are surely apart, for longer than the error, they are not.
std::string wrongWithSamples(const MovingCase& c, double error, int samples, Tally& tally) {
  ImpactOptions options;
  options.margin = c.margin;
  options.time_error = error;
  const std::vector<Conflict> found = conflicts(c.a, c.motion_a, c.b, c.motion_b, options);
  const double seen = std::max(error, 1e-9) * (1 + 1e-6), rounding = 1e-13 * lengthOf(c), speed = speedOf(c);
  std::string wrong = wrongOrder(found);
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) times.push_back(static_cast<double>(i) / samples);
  for (const Conflict& f : found)
    for (const double share : {0.0, 0.01, 0.5, 0.99, 1.0})
      times.push_back(f.impact.time + share * (f.end - f.impact.time));
  bool at_begin = false;
  for (std::size_t i = 0; i < times.size() && wrong.empty(); ++i) {
    const double time = times[i];
    const Case now = caseAt(c, time);
    const Reference reference(now);
    const Reference::Bounds apart = reference.distance();
    bool surely = static_cast<double>(apart.high) < c.margin - rounding;
    if (c.margin == 0 && apart.high == 0) {
      const auto deep = penetration(now.a, now.pose_a, now.b, now.pose_b);
      surely = deep && deep->lower_bound > rounding;
    }
    const bool told = std::any_of(found.begin(), found.end(),
                                  [&](const Conflict& f) { return f.impact.time <= time && time <= f.end; });
    if (surely && !told) wrong = at("they meet", mpq_class(time));
    if (told && static_cast<double>(apart.low) > c.margin + rounding + speed * seen) wrong = at("far", mpq_class(time));
    if (time == 0) at_begin = reference.within(c.margin);
  }
  if (!wrong.empty()) return wrong;
  if (at_begin != (!found.empty() && found[0].impact.time == 0)) return "at the begin or not";
  options.ignore_initial = true;
  const std::vector<Conflict> later = conflicts(c.a, c.motion_a, c.b, c.motion_b, options);
  wrong = wrongOrder(later);
  if (wrong.empty() && at_begin) wrong = wrongLater(c, options, found, later, true, seen);
  count(tally, at_begin, found, later);
  return wrong;
}

/// Polygons on a grid, of which one starts in contact with the other, or at the margin, or some roundings beside it,
/// and is shifted along an edge or anywhere, as the other one may be.
MovingCase anyShiftFromContact(Random& random) {
  MovingCase c{anyOnGrid(random), {}, anyOnGrid(random), {}};
  const auto turned = [&](Pose& pose) {
    if (random.oneIn(3)) pose.linear() << 0, -1, 1, 0;
    if (random.oneIn(4)) pose.linear() << 0.6, -0.8, 0.8, 0.6;
  };
  turned(c.motion_a.start);
  turned(c.motion_b.start);
  const auto edgeOf = [&](const Polygon& polygon, const Pose& pose, Vec2& on) {
    const EdgeIndex edge = anyEdge(random, polygon);
    const Vec2 v = pose * polygon.edgeStart(edge), w = pose * polygon.edgeEnd(edge);
    on = v + 0.25 * random.integer(0, 4) * (w - v);
    return Vec2(w - v);
  };
  Vec2 on_a, on_b;
  const Vec2 along_a = edgeOf(c.a, c.motion_a.start, on_a), along_b = edgeOf(c.b, c.motion_b.start, on_b);
  Vec2 place = on_a - on_b;
  if (random.oneIn(3)) {
    c.margin = 0.25 * random.integer(1, 8);
    if (!along_a.isZero(0)) place += c.margin * Vec2(along_a.y(), -along_a.x()) / along_a.norm();
  }
  if (random.oneIn(4)) place += 0x1p-52 * Vec2(random.integer(-4, 4), random.integer(-4, 4));
  if (random.oneIn(3)) place += 0.25 * Vec2(random.integer(-24, 24), random.integer(-24, 24));
  c.motion_b.start.translation() += place;
  switch (random.integer(0, 4)) {
    case 0:
      c.motion_b.shift = 0.25 * random.integer(-12, 12) * along_a;
      break;
    case 1:
      c.motion_b.shift = 0.25 * random.integer(-12, 12) * along_b;
      break;
    case 2:
      c.motion_b.shift[random.integer(0, 1)] = 0.5 * random.integer(-20, 20);
      break;
    case 3:
      break;
    default:
      c.motion_b.shift = 0.25 * Vec2(random.integer(-40, 40), random.integer(-40, 40));
  }
  if (random.oneIn(3)) {
    c.motion_a.shift = 0.25 * Vec2(random.integer(-20, 20), random.integer(-20, 20));
    c.motion_b.shift += c.motion_a.shift;
  }
  if (random.coin()) {
    std::swap(c.a, c.b);
    std::swap(c.motion_a, c.motion_b);
  }
  return c;
}

/// The same polygons and starts with rotations, about the contact or not, and cubics along it.
MovingCase anyMotionFromContact(Random& random) {
  MovingCase c = anyShiftFromContact(random);
  const Vec2 by = c.motion_b.shift - c.motion_a.shift;
  switch (random.integer(0, 3)) {
    case 0:  // both alike, about one place
      for (Motion* motion : {&c.motion_a, &c.motion_b}) {
        motion->pivot = motion->start.linear().inverse() * (Vec2(1, 2) - motion->start.translation());
        motion->angle = 2;
        motion->shift = Vec2(3, -1);
      }
      break;
    case 1: {  // about a vertex, which may be the contact
      const EdgeIndex edge = anyEdge(random, c.b);
      c.motion_b.pivot = c.b.edgeStart(edge);
      c.motion_b.angle = random.real(-6, 6);
      if (random.coin()) c.motion_b.shift = c.motion_a.shift;
      break;
    }
    case 2:  // to and fro along the shift
      c.motion_b.shift_2 = 0.25 * random.integer(-12, 12) * by;
      c.motion_b.shift_3 = 0.25 * random.integer(-12, 12) * by;
      break;
    default:
      c.motion_b.angle = random.real(-3, 3);
      c.motion_b.shift_2 = Vec2(random.real(-4, 4), random.real(-4, 4));
      c.motion_a.angle_2 = random.coin() ? 0 : random.real(-3, 3);
  }
  return c;
}

template <MovingCase (*make)(Random& random), bool is_shift>
std::string wrong(Random& random, Tally& tally) {
  const MovingCase c = make(random);
  const double error = std::pow(10, -random.integer(2, 12));
  const std::string problem = is_shift ? wrongWithShifts(c, error, tally) : wrongWithSamples(c, error, 60, tally);
  return problem.empty()
             ? problem
             : problem + ", time error " + hex(error) + ", margin " + hex(c.margin) + "\n" + reproduction(c);
}

Laws lastingContactLaws() {
  return {{"shifts",
           6000,
           wrong<anyShiftFromContact, true>,
           {{"at begin", 0.333, 0.95}, {"later", 0.025, 1}, {"none", 0.01, 1}, {"lasting", 0.25, 1}}},
          {"motions",
           1500,
           wrong<anyMotionFromContact, false>,
           {{"at begin", 0.333, 0.95}, {"later", 0.05, 1}, {"lasting", 0.25, 1}}}};
}

const Register registered("lasting_contact", lastingContactLaws);

}  // namespace
}  // namespace tricover::laws
