// SPDX-License-Identifier: BSD-3-Clause
#include "queries.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

#include "distance_laws.h"
#include "limited_distance.h"
#include "ray_laws.h"
#include "reproduction.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/contacts.h"
#include "tricover/depth.h"
#include "tricover/least_distance.h"
#include "tricover/paper.h"
#include "tricover/penetration.h"
#include "tricover/ray.h"
#include "tricover/scene.h"
#include "tricover/signed_distance.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

/// An answer as it is told, put into the order of a and b.
class Telling {
 public:
  explicit Telling(const Question& question) : swapped_(question.swapped) {}

  Telling& meets(bool whether) { return answer_.meets = whether, *this; }
  Telling& number(double x) { return answer_.numbers.push_back(x), *this; }
  Telling& point(const Vec2& p) { return number(p.x()).number(p.y()); }
  /// From the first operand to the second.
  Telling& direction(const Vec2& d) { return point(swapped_ ? Vec2(-d) : d); }
  Telling& points(const Vec2& first, const Vec2& second) {
    return point(swapped_ ? second : first).point(swapped_ ? first : second);
  }
  Telling& edges(EdgeIndex first, EdgeIndex second) {
    return answer_.edges.emplace_back(swapped_ ? second : first, swapped_ ? first : second), *this;
  }
  Telling& impact(const Impact& impact) {
    return number(impact.time).point(impact.point).direction(impact.normal).edges(impact.edge_a, impact.edge_b);
  }
  Answer done() { return std::move(answer_); }

 private:
  bool swapped_;
  Answer answer_;
};

/// ask(a, pose_a, b, pose_b) in the question's order, with its cache behind them if it has one and `ask` takes it.
template <typename Ask>
auto asked(const Case& c, const Question& q, const Ask& ask) {
  return q.swapped ? ask(c.b, c.pose_b, c.a, c.pose_a) : ask(c.a, c.pose_a, c.b, c.pose_b);
}

Answer askCollide(const Case& c, const Question& q) {
  const CollideOptions options{q.margin, 0, q.touching};
  const bool meets = asked(c, q, [&](const auto&... pair) {
    return q.cache != nullptr ? collide(pair..., *q.cache, options) : collide(pair..., options);
  });
  return Telling(q).meets(meets).done();
}

Answer askPaper(const Case& c, const Question& q) {
  const CollideOptions options{q.margin, 0, q.touching};
  return Telling(q).meets(asked(c, q, [&](const auto&... pair) { return paper::collide(pair..., options); })).done();
}

Answer tell(const Question& q, const DistanceResult& r) {
  return Telling(q).number(r.distance).points(r.point_a, r.point_b).edges(r.edge_a, r.edge_b).done();
}

DistanceResult distanceOf(const Case& c, const Question& q, const LimitedOptions& options) {
  return asked(c, q, [&](const auto&... pair) {
    return q.cache != nullptr ? distance(pair..., *q.cache, options) : distance(pair..., options);
  });
}

Answer askDistance(const Case& c, const Question& q) {
  LimitedOptions options;
  options.margin = q.margin;
  Answer answer = tell(q, distanceOf(c, q, options));
  if (q.touching == Touching::Collides) answer.meets = answer.numbers[0] == 0;
  return answer;
}

/// The margin is the limit.
Answer askDistanceWithin(const Case& c, const Question& q) {
  LimitedOptions options;
  options.limit = q.margin;
  return tell(q, distanceOf(c, q, options));
}

/// Where several points are equally near, others may be found.
bool distancesAreAlike(const Case& c, const Question& q, const Answer& without, const Answer& with) {
  const std::vector<double>& n = with.numbers;
  if (n[0] != without.numbers[0]) return false;
  if (q.margin > 0 || std::isinf(n[0])) return true;
  return wrongPoints(c, {n[0], {n[1], n[2]}, {n[3], n[4]}, with.edges[0].first, with.edges[0].second}).empty();
}

template <ContactDetail detail>
Answer askContacts(const Case& c, const Question& q) {
  ContactOptions options;
  options.margin = q.margin;
  options.detail = detail;
  options.touching = q.touching;
  const std::vector<Contact> found = asked(c, q, [&](const auto&... pair) {
    return q.cache != nullptr ? contacts(pair..., *q.cache, options) : contacts(pair..., options);
  });
  Telling telling(q);
  telling.meets(!found.empty());
  for (const Contact& contact : found) {
    telling.point(contact.point).direction(contact.normal).number(contact.depth);
    telling.edges(contact.edge_a, contact.edge_b).number(static_cast<double>(contact.count));
    for (const ContactPoint& p : contact.points) telling.point(p.point).number(p.depth);
  }
  return telling.done();
}

/// In the order of their edges: theirs means nothing.
Answer askCrossings(const Case& c, const Question& q) {
  const CrossingOptions options{q.margin, q.touching};
  std::vector<Crossing> found = asked(c, q, [&](const auto&... pair) { return crossings(pair..., options); });
  const auto edges = [&](const Crossing& x) {
    return q.swapped ? std::pair(x.edge_b, x.edge_a) : std::pair(x.edge_a, x.edge_b);
  };
  std::sort(found.begin(), found.end(), [&](const Crossing& x, const Crossing& y) { return edges(x) < edges(y); });
  Telling telling(q);
  if (!found.empty()) telling.meets(true);
  // Edges are numbers here, as those without length are listed too.
  for (const Crossing& x : found)
    telling.point(x.point).number(static_cast<double>(edges(x).first)).number(static_cast<double>(edges(x).second));
  return telling.done();
}

Answer askPenetration(const Case& c, const Question& q) {
  const PenetrationOptions options{q.margin, q.touching};
  const auto p = asked(c, q, [&](const auto&... pair) {
    return q.cache != nullptr ? penetration(pair..., *q.cache, options) : penetration(pair..., options);
  });
  Telling telling(q);
  telling.meets(p.has_value());
  if (p)
    telling.number(p->depth)
        .number(p->lower_bound)
        .number(p->optimal)
        .direction(p->normal)
        .direction(p->translation)
        .points(p->point_a, p->point_b)
        .edges(p->edge_a, p->edge_b);
  return telling.done();
}

/// The depth is the same to the precision that penetration.h states, with room for two of them.
bool penetrationsAreAlike(const Case& c, const Question& q, const Answer& without, const Answer& with) {
  if (without.meets != with.meets) return false;
  if (!*with.meets) return true;
  const std::vector<double>&p = without.numbers, &n = with.numbers;
  const double depth = n[0], bound = n[1], between = (c.pose_a.translation() - c.pose_b.translation()).stableNorm();
  if (std::isinf(depth)) return std::isinf(p[0]);
  const double error = 4e-12 * std::min(c.a.radius(), c.b.radius()) +
                       4e-13 * (c.a.radius() + c.b.radius() + q.margin + between) +
                       1e-14 * c.pose_a.translation().stableNorm() + 0x1p-1050;
  Pose moved = c.pose_b;
  moved.translation() += Vec2(n[5], n[6]);
  if (collide(c.a, c.pose_a, c.b, moved, {q.margin})) return false;
  if (!(bound <= depth && bound <= p[0] + error && p[1] <= depth + error)) return false;
  return q.margin > 0 || (n[2] == p[2] && (n[2] == 0 || std::abs(depth - p[0]) <= error));
}

Answer askSignedDistance(const Case& c, const Question& q) {
  DistanceOptions options;
  options.margin = q.margin;
  const SignedDistance r = asked(c, q, [&](const auto&... pair) { return signedDistance(pair..., options); });
  Telling telling(q);
  if (q.touching == Touching::Collides) telling.meets(r.distance <= 0);
  telling.number(r.distance).direction(r.normal).points(r.point_a, r.point_b).edges(r.edge_a, r.edge_b);
  return telling.done();
}

Answer askDepth(const Case& c, const Question& q) {
  const Depth d = asked(c, q, [](const auto&... pair) { return depth(pair...); });
  Telling telling(q);
  telling.number(d.depth).number(d.upper_bound).direction(d.normal).points(d.point_a, d.point_b);
  if (d.depth > 0 && !std::isinf(d.depth)) telling.number(d.is_point_of_a != q.swapped);
  return telling.edges(d.edge_a, d.edge_b).done();
}

/// Of a from b and of b from a.
Answer askExcess(const Case& c, const Question&) {
  Telling telling({});
  for (const bool is_back : {false, true}) {
    const Excess e = is_back ? excess(c.b, c.pose_b, c.a, c.pose_a) : excess(c.a, c.pose_a, c.b, c.pose_b);
    telling.number(e.distance).number(e.upper_bound).point(e.point).point(e.nearest);
    telling.edges(is_back ? e.nearest_edge : e.edge, is_back ? e.edge : e.nearest_edge);
  }
  return telling.done();
}

/// b comes towards a and goes on, and turns by so much about its S.
Motion motionOf(const Case& c, double angle) {
  Motion motion = Motion::still(c.pose_b);
  const Vec2 shift = -1.5 * (c.pose_b.translation() - c.pose_a.translation());
  if (shift.allFinite()) motion.shift = shift;
  motion.angle = angle;
  motion.pivot = c.b.coveringOrigin();
  return motion;
}

template <typename Ask>
auto askedOfMotions(const Case& c, const Question& q, double angle, const Ask& ask) {
  const Motion still = Motion::still(c.pose_a), moving = motionOf(c, angle);
  const ImpactOptions options{q.margin, 1e-3};
  return q.swapped ? ask(c.b, moving, c.a, still, options) : ask(c.a, still, c.b, moving, options);
}

template <int angle>
Answer askImpact(const Case& c, const Question& q) {
  const auto impact = askedOfMotions(c, q, angle, [](const auto&... all) { return timeOfImpact(all...); });
  Telling telling(q);
  if (q.touching == Touching::Collides) telling.meets(impact && impact->time == 0);
  if (impact) telling.impact(*impact);
  return telling.done();
}

/// Infinite lengths are none that an error is small beside.
Answer askLeastDistance(const Case& c, const Question& q) {
  LeastDistanceOptions options;
  options.margin = q.margin;
  options.absolute_error = 0.01 * std::min(c.a.radius(), c.b.radius());
  Telling telling(q);
  if (!(options.absolute_error > 0 && std::isfinite(options.absolute_error))) return telling.done();
  const Motion still = Motion::still(c.pose_a), moving = motionOf(c, 1);
  const LeastDistance r =
      q.swapped ? leastDistance(c.b, moving, c.a, still, options) : leastDistance(c.a, still, c.b, moving, options);
  telling.number(r.distance).number(r.lower_bound).number(r.time).points(r.point_a, r.point_b);
  return telling.edges(r.edge_a, r.edge_b).done();
}

Answer askConflicts(const Case& c, const Question& q) {
  const auto found = askedOfMotions(c, q, 1, [](const auto&... all) { return conflicts(all...); });
  Telling telling(q);
  if (q.touching == Touching::Collides) telling.meets(!found.empty() && found.front().impact.time == 0);
  for (const Conflict& span : found) telling.impact(span.impact).number(span.end);
  return telling.done();
}

/// Of a scene whose only body is the other one.
Answer askScene(const Case& c, const Question& q) {
  return asked(c, q, [&](const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
    Scene scene;
    scene.add(b, pose_b);
    Answer answer = tell(q, scene.nearest(a, pose_a, {q.margin})->result);
    answer.meets = scene.collides(a, pose_a, {q.margin, 0, q.touching});
    return answer;
  });
}

/// Of b, from a's origin to a vertex, whichever is asked first.
Answer askRay(const Case& c, const Question&) {
  const Vec2 from = c.pose_a * c.a.coveringOrigin(), to = c.pose_b * c.b.edgeStart(0);
  Telling telling({});
  if (!from.allFinite() || !to.allFinite()) return telling.done();
  if (const auto hit = castRay(c.b, c.pose_b, from, to))
    telling.number(hit->fraction).point(hit->point).point(hit->normal).edges(-1, hit->edge);
  return telling.done();
}

bool exactlyAlike(const Case&, const Question&, const Answer& without, const Answer& with) {
  return same(without, with);
}

template <typename Equal>
bool areEqual(const Answer& p, const Answer& q, const Equal& equal) {
  return p.meets == q.meets && p.edges == q.edges &&
         std::equal(p.numbers.begin(), p.numbers.end(), q.numbers.begin(), q.numbers.end(), equal);
}

}  // namespace

bool same(const Answer& p, const Answer& q) {
  return areEqual(p, q, [](double x, double y) { return std::memcmp(&x, &y, sizeof(x)) == 0; });
}

bool sameButForZeros(const Answer& p, const Answer& q) {
  return areEqual(p, q, [](double x, double y) { return x == y || !std::isfinite(x); });
}

const std::vector<Query>& queries() {
  static const std::vector<Query> all = {
      {"collide", askCollide, exactlyAlike},
      {"paper::collide", askPaper},
      {"distance", askDistance, distancesAreAlike},
      {"distanceWithin", askDistanceWithin, distancesAreAlike},
      {"contacts' points", askContacts<ContactDetail::Points>, exactlyAlike},
      {"contacts' local depths", askContacts<ContactDetail::LocalDepth>, exactlyAlike},
      {"contacts", askContacts<ContactDetail::GlobalDepth>, exactlyAlike, false, false},
      {"crossings", askCrossings},
      {"penetration", askPenetration, penetrationsAreAlike, false, false},
      {"signedDistance", askSignedDistance},
      {"depth", askDepth},
      {"excess", askExcess},
      {"leastDistance", askLeastDistance},
      {"timeOfImpact of a slide", askImpact<0>},
      {"timeOfImpact", askImpact<1>},
      {"conflicts", askConflicts, nullptr, true},
      {"Scene", askScene},
      {"castRay", askRay},
  };
  return all;
}

std::string wrongWithCache(const Case& c, const Query& query, const Question& question) {
  const Answer without = query.ask(c, {question.margin, false, nullptr, question.touching}),
               with = query.ask(c, question);
  // Of a polygon and itself at one place the order is the caller's.
  if (question.swapped && isOneTwice(c)) return with.meets == without.meets ? "" : query.name;
  const bool alike = question.swapped && query.alike == exactlyAlike ? sameButForZeros(without, with)
                                                                     : query.alike(c, question, without, with);
  return alike ? "" : std::string(query.name) + " with a cache, margin " + hex(question.margin);
}

std::string wrongName(const Case& c, const Answer& answer) {
  const auto isNamable = [](const Polygon& polygon, EdgeIndex edge) {
    return edge < 0 || (edge < polygon.edgeCount() && namedEdge(polygon, edge) == edge);
  };
  for (const auto& [edge_a, edge_b] : answer.edges)
    if (!isNamable(c.a, edge_a) || !isNamable(c.b, edge_b))
      return "edges " + std::to_string(edge_a) + " and " + std::to_string(edge_b);
  return {};
}

}  // namespace tricover::support
