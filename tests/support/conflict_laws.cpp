// SPDX-License-Identifier: BSD-3-Clause
#include "conflict_laws.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact_reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/conflicts.h"

namespace tricover::support {
namespace {

/// Of times: what 1e-13 of lengths may move them by, where bodies don't touch in passing.
constexpr double kRounding = 1e-8;
constexpr int kSamples = 300;  // in a unit of time

Pose poseAt(const Motion& m, long double t) {
  using Real = long double;
  const auto cubic = [t](Real first, Real second, Real third) { return ((third * t + second) * t + first) * t; };
  const Real angle = cubic(m.angle, m.angle_2, m.angle_3), c = std::cos(angle), s = std::sin(angle);
  const auto start = [&](int row, int column) { return static_cast<Real>(m.start.matrix()(row, column)); };
  Pose pose = Pose::Identity();
  for (int column = 0; column < 2; ++column) {
    pose.linear()(0, column) = static_cast<double>(c * start(0, column) - s * start(1, column));
    pose.linear()(1, column) = static_cast<double>(s * start(0, column) + c * start(1, column));
  }
  const Real arm[2] = {start(0, 0) * m.pivot.x() + start(0, 1) * m.pivot.y(),
                       start(1, 0) * m.pivot.x() + start(1, 1) * m.pivot.y()};
  const Real turned[2] = {c * arm[0] - s * arm[1], s * arm[0] + c * arm[1]};
  for (int i = 0; i < 2; ++i)
    pose.translation()[i] =
        static_cast<double>(start(i, 2) + arm[i] - turned[i] + cubic(m.shift[i], m.shift_2[i], m.shift_3[i]));
  return pose;
}

Pose poseAt(const Trajectory& way, double time) {
  if (time <= way.begin()) return way.legs().front().motion.start;
  for (const Leg& leg : way.legs())
    if (time <= leg.end)
      return poseAt(leg.motion,
                    (static_cast<long double>(time) - leg.begin) / (static_cast<long double>(leg.end) - leg.begin));
  return poseAt(way.legs().back().motion, 1);
}

struct Span {
  double begin, end;
};

/// All that last for a sample or more, and those that hold one of these times as well; likewise of what is between
/// them.
template <typename MeetAt>
std::vector<Span> truthOf(const MeetAt& meet, double begin, double end, std::vector<double> samples) {
  const auto change = [&](double before, double after, bool to) {
    while (after - before > kRounding / 64) {
      const double middle = before + (after - before) / 2;
      (meet(middle) == to ? after : before) = middle;
    }
    return after;
  };
  const int count = static_cast<int>(kSamples * (end - begin));
  for (int i = 0; i <= count; ++i) samples.push_back(i == count ? end : begin + (end - begin) * i / count);
  std::sort(samples.begin(), samples.end());
  std::vector<Span> spans;
  bool met = false;
  double last = begin;
  for (const double time : samples) {
    const bool now = meet(time);
    if (now && !met) spans.push_back({time == begin ? begin : change(last, time, true), end});
    if (!now && met) spans.back().end = change(last, time, false);
    met = now;
    last = time;
  }
  return spans;
}

/// Whether the two come that near at some time.
template <typename MeetAt>
bool comeNear(const MeetAt& near, double from, double until) {
  for (int i = 0; i <= 64; ++i)
    if (near(from + (until - from) * i / 64)) return true;
  return false;
}

std::string at(const char* what, double time) { return std::string(what) + " at " + hex(time); }

/// Of the spans themselves.
template <typename MeetAt, typename NearAt>
std::string wrongSpans(const std::vector<Conflict>& found, const std::vector<Span>& truth, double begin, double end,
                       double error, const MeetAt& meet, const NearAt& near, ConflictCounts& counts) {
  // None is missed, and each is told no later than it begins and no sooner than it ends.
  for (const Span& span : truth) {
    const auto told =
        std::find_if(found.begin(), found.end(), [&](const Conflict& c) { return c.end >= span.end - kRounding; });
    if (told == found.end() || told->impact.time > span.begin + kRounding) return at("missed", span.begin);
  }
  // Before and after those that hold a sample there may be shorter ones.
  const auto is_short = [&](double from, double until) {
    return until - from <= error + kRounding || (until - from < 1.0 / kSamples && comeNear(near, from, until));
  };
  std::size_t next = 0;
  for (const Conflict& c : found) {
    if (!(begin <= c.impact.time && c.impact.time <= c.end && c.end <= end)) return at("no span", c.impact.time);
    const std::size_t first = next;
    while (next < truth.size() && truth[next].begin <= c.end + kRounding) ++next;
    if (first == next) {
      ++counts.unseen;  // too short for a sample
      if (c.end - c.impact.time > 2 * error + 1.0 / kSamples + kRounding) return at("nothing", c.impact.time);
      if (!comeNear(near, c.impact.time, std::min(c.end, c.impact.time + error))) return at("far", c.impact.time);
      continue;
    }
    // Of those within it the first begins, and the last ends, when it does; what parts them for longer is seen.
    if (!is_short(c.impact.time, truth[first].begin)) return at("too early", c.impact.time);
    if (!is_short(truth[next - 1].end, c.end)) return at("too late", c.end);
    for (std::size_t k = first + 1; k < next; ++k)
      if (truth[k].begin - truth[k - 1].end > error + kRounding) return at("apart", truth[k - 1].end);
    if (c.end < end && meet(c.end)) return at("no end", c.end);
  }
  return {};
}

}  // namespace

bool meetExactly(const Case& c, double margin) {
  if (margin == 0) return exact::collide(c.a, c.pose_a, c.b, c.pose_b);
  return exact::within(exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b), margin);
}

std::string wrongConflicts(const Flight& f, double error, Meet meet, ConflictCounts& counts) {
  const auto meetWithin = [&](double time, double margin) {
    return meet({f.a, poseAt(f.way_a, time), f.b, poseAt(f.way_b, time)}, margin);
  };
  const auto meetAt = [&](double time) { return meetWithin(time, f.margin); };
  // What they move by in so short a time.
  const auto nearAt = [&](double time) { return meetWithin(time, f.margin + 1000 * error + 1e-9); };
  const double begin = std::min(f.way_a.begin(), f.way_b.begin()), end = std::max(f.way_a.end(), f.way_b.end());
  ImpactOptions options{f.margin, error};
  const std::vector<Conflict> found = conflicts(f.a, f.way_a, f.b, f.way_b, options);
  // What is told says where to look more closely.
  std::vector<double> places;
  for (const Conflict& c : found)
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
      places.push_back(c.impact.time + share * (c.end - c.impact.time));
  const std::string wrong =
      wrongSpans(found, truthOf(meetAt, begin, end, places), begin, end, error, meetAt, nearAt, counts);
  if (!wrong.empty()) return wrong;

  options.ignore_initial = true;
  const std::vector<Conflict> later = conflicts(f.a, f.way_a, f.b, f.way_b, options);
  const bool at_begin = !found.empty() && found.front().impact.time == begin;
  if (at_begin != meetAt(begin)) return "at the begin or not";
  if (later.size() + at_begin != found.size()) return "more than the initial one is ignored";
  const auto impact = timeOfImpact(f.a, f.way_a, f.b, f.way_b, options);
  if (impact.has_value() == later.empty()) return "time of impact or not";
  if (impact && std::abs(impact->time - later.front().impact.time) > error + kRounding) return "time of impact";
  ++counts.cases;
  counts.spans += static_cast<int>(found.size());
  ++(found.empty() ? counts.none : found.size() == 1 ? counts.one : counts.more);
  counts.at_begin += at_begin;
  counts.until_end += !found.empty() && found.back().end == end;
  return {};
}

Trajectory anyPlan(Random& random) {
  std::vector<Leg> legs;
  double time = random.real(-0.5, 0.5);
  const auto anywhere = [&] { return Vec2(random.real(-3, 3), random.real(-3, 3)); };
  Vec2 at = anywhere();
  double heading = random.real(-3, 3);
  for (int i = random.integer(1, 4); i > 0; --i) {
    const double begin = time;
    time += random.real(0.1, 0.5);
    Motion leg = Motion::still(turnedAndMoved(heading, at.x(), at.y()));
    if (!random.oneIn(3)) {
      leg.shift = 2 * anywhere() - at;
      leg.angle = random.real(-2, 2);
      at += leg.shift, heading += leg.angle;
    }
    legs.push_back({begin, time, leg});
  }
  return Trajectory(legs);
}

}  // namespace tricover::support
