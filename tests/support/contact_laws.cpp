// SPDX-License-Identifier: BSD-3-Clause
#include "contact_laws.h"

#include <algorithm>
#include <cmath>

#include "exact_penetration.h"
#include "exact_reference.h"
#include "reference.h"
#include "reproduction.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/ray.h"

namespace tricover::support {
namespace {

bool within(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, double length) {
  return exact::within(exact::distanceSquared(a, pose_a, b, pose_b), mpq_class(length));
}

/// One edge, as a polygon.
Polygon edgeOf(const Polygon& polygon, std::ptrdiff_t edge) {
  return Polygon({{polygon.edgeStart(edge), polygon.edgeEnd(edge), polygon.edgeStart(edge)}});
}

bool hasLength(const Polygon& polygon, EdgeIndex edge) { return polygon.edgeStart(edge) != polygon.edgeEnd(edge); }

/// The ring that an edge is of.
bool isRingAPoint(const Polygon& polygon, EdgeIndex edge) {
  for (const Ring& ring : polygon.rings()) {
    if (edge < static_cast<EdgeIndex>(ring.size()))
      return std::all_of(ring.begin(), ring.end(), [&](const Vec2& p) { return p == ring.front(); });
    edge -= static_cast<EdgeIndex>(ring.size());
  }
  return false;
}

/// By how much more than the depth a way must lead apart.
double beyond(const Case& c) { return 4 * rounding(c) + 1e-9 * std::min(c.a.radius(), c.b.radius()); }

/// Whether a point is within a length of both regions, but for rounding.
bool isNear(const Case& c, const Vec2& p, double length) {
  const Polygon point({Ring(3, p)});
  const Case with_a{c.a, c.pose_a, point, Pose::Identity()}, with_b{c.b, c.pose_b, point, Pose::Identity()};
  const double error = length + rounding(c);
  return Reference(with_a).within(error) && Reference(with_b).within(error);
}

std::string wrongPoints(Random& random, const Case& c, const Contact& contact) {
  const ContactPoint &first = contact.points[0], &second = contact.points[1];
  if (contact.count == 1)
    return first.point == contact.point && first.depth == contact.depth && second.point == first.point ? ""
                                                                                                       : "one point";
  if (contact.count != 2) return "how many points";
  if (!(contact.depth >= first.depth && first.depth >= second.depth && second.depth >= 0)) return "a point's depth";
  if (!(first.point.allFinite() && second.point.allFinite())) return "a point";
  if (!random.oneIn(4)) return "";
  const double depth = contact.depth * (1 + 1e-9);
  return isNear(c, first.point, depth) && isNear(c, second.point, depth) ? "" : "an end that is far";
}

/// Whether a convex polygon is nowhere wider than so much, or hardly so.
bool isThin(const Polygon& polygon, double width) {
  long double area = 0;
  const Vec2 s = polygon.edgeStart(0);
  for (EdgeIndex i = 0; i < polygon.edgeCount(); ++i) {
    const Vec2 v = polygon.edgeStart(i) - s, w = polygon.edgeEnd(i) - s;
    area += static_cast<long double>(v.x()) * w.y() - static_cast<long double>(v.y()) * w.x();
  }
  return std::abs(area) < 8.0L * width * polygon.radius();
}

}  // namespace

double rounding(const Case& c) {
  const auto size = [](const Polygon& polygon, const Pose& pose) {
    double most = 0;
    for (const Ring& ring : polygon.rings())
      for (const Vec2& p : ring) most = std::max(most, p.lpNorm<1>());
    return most + pose.translation().lpNorm<1>();
  };
  return 128 * 0x1p-53 * (size(c.a, c.pose_a) + size(c.b, c.pose_b)) + 0x1p-1048;
}

Pose moved(const Pose& pose, const Vec2& way) {
  Pose result = pose;
  result.translation() += way;
  return result;
}

std::string wrongContacts(Random& random, const Case& c, const std::vector<Contact>& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Contact& contact = found[i];
    if (!(std::abs(contact.normal.norm() - 1) <= 1e-12)) return "a normal that isn't unit";
    if (!(contact.depth >= 0 && std::isfinite(contact.depth))) return "a depth";
    if (i > 0 && contact.depth > found[i - 1].depth) return "the order";
    if (!contact.point.allFinite() || (random.oneIn(4) && !isNear(c, contact.point, 0))) return "a point outside";
    const std::string wrong = wrongPoints(random, c, contact);
    if (!wrong.empty()) return wrong;
  }
  return {};
}

std::string wrongEdges(const Case& c, const std::vector<Contact>& found, bool crossed) {
  const auto isEdge = [](const Polygon& polygon, EdgeIndex edge) {
    return edge >= 0 && edge < polygon.edgeCount() && (hasLength(polygon, edge) || isRingAPoint(polygon, edge));
  };
  for (const Contact& contact : found) {
    const bool of_a = isEdge(c.a, contact.edge_a), of_b = isEdge(c.b, contact.edge_b);
    if (!of_a && !(contact.edge_a == -1 && of_b)) return "edge_a";
    if (!of_b && !(contact.edge_b == -1 && of_a)) return "edge_b";
    if (!crossed && of_a && of_b) return "an edge of what holds the other";
    if (crossed && found.size() == 1 && !(of_a && of_b)) return "no edge, where edges cross";
  }
  return {};
}

std::string wrongConvexContact(const Case& c, const Contact& contact) {
  const long double depth = contact.depth, error = rounding(c);
  const Reference::Bounds truth = convexDepth(c);
  if (!(depth <= truth.low + error && depth >= truth.high - error)) {
    const double exactly = exact::distanceBelow(exact::convexPenetrationSquared(c.a, c.pose_a, c.b, c.pose_b));
    const bool is_thin = isThin(c.a, rounding(c)) || isThin(c.b, rounding(c));
    if (contact.depth == 0 && is_thin) return "";
    if (!(std::abs(depth - exactly) <= error)) return "depth " + hex(contact.depth) + ", which is " + hex(exactly);
  }
  Case moved = c;
  moved.pose_b.translation() += (contact.depth * (1 + 1e-9) + 4 * rounding(c)) * contact.normal;
  return Reference(moved).collide() ? "the way doesn't part them" : "";
}

std::string wrongContactsWithMargin(const Case& c, double margin) {
  if (!std::isfinite(margin)) return "";
  const Reference reference(c);
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, globally(margin));
  const std::string with = " with the margin " + hex(margin);
  if (found.empty() == reference.within(margin)) return "contacts, or none," + with;
  const double error = rounding(c) + 1e-12 * margin;
  for (const Contact& contact : found) {
    if (!(std::abs(contact.normal.norm() - 1) <= 1e-12)) return "a normal that isn't unit" + with;
    if (contact.depth < margin - error && reference.within(margin - contact.depth - error))
      return "shallower than what is left" + with;
  }
  if (found.empty() || reference.collide()) return "";
  if (found.size() != 1) return "how many there are" + with;
  if (!(found[0].depth <= margin && reference.within(margin - found[0].depth + error)))
    return "deeper than what is left" + with;
  // Of what is clearly apart.
  const DistanceResult nearest = distance(c.a, c.pose_a, c.b, c.pose_b);
  const double apart = nearest.distance;
  const bool is_normal = ((nearest.point_b - nearest.point_a) / apart - found[0].normal).norm() <= 1e-5;
  return apart < 1e6 * error || is_normal ? "" : "the normal" + with;
}

std::string wrongLocalDepths(const Case& c, const std::vector<Contact>& found) {
  for (const Contact& contact : found) {
    if (!(contact.depth > 1e3 * rounding(c) && contact.depth < 1e100)) continue;
    // From a point to either side: as far as both regions hold the way.
    const auto widthAt = [&](const Vec2& from) {
      double length = 0;
      for (const double sign : {1.0, -1.0}) {
        const Vec2 to = from + 2 * sign * contact.depth * contact.normal;
        double share = 1;
        for (const auto& [polygon, pose] : {std::pair(&c.a, &c.pose_a), std::pair(&c.b, &c.pose_b)}) {
          const std::vector<RayInterval> held = castRayAll(*polygon, *pose, from, to);
          share = std::min(share, held.empty() || held[0].begin.fraction > 0 ? 0 : held[0].end.fraction);
        }
        length += share * 2 * contact.depth;
      }
      return length;
    };
    // A way along a border has no width: it ends just beside.
    const Vec2 aside = 64 * rounding(c) * Vec2(-contact.normal.y(), contact.normal.x());
    const double length =
        std::min({widthAt(contact.point), widthAt(contact.point + aside), widthAt(contact.point - aside)});
    if (length > contact.depth * (1 + 1e-9) + 16 * rounding(c)) return "a local depth below the component's width";
  }
  return {};
}

int pushesUntilFree(Case c, int most) {
  for (int count = 0; count <= most; ++count) {
    ContactOptions options;
    options.detail = ContactDetail::LocalDepth;
    options.touching = Touching::Allowed;
    const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, options);
    if (found.empty() || found[0].depth <= 16 * rounding(c)) return count;
    c.pose_b.translation() += (found[0].depth * (1 + 1e-9) + 16 * rounding(c)) * found[0].normal;
  }
  return most + 1;
}

bool isCommon(const Case& c, const Contact& contact) {
  const Polygon point({Ring(3, contact.point)});
  return within(point, Pose::Identity(), c.a, c.pose_a, rounding(c)) &&
         within(point, Pose::Identity(), c.b, c.pose_b, rounding(c));
}

bool parts(const Case& c, const Contact& contact) {
  // Farther on they may meet again, within what rounding costs where that isn't much less than they are large.
  for (const double share : {1.0, 0.5, 0.25}) {
    const double way = contact.depth * (1 + 1e-9) + share * beyond(c);
    if (!exact::collide(c.a, c.pose_a, c.b, moved(c.pose_b, way * contact.normal))) return true;
  }
  return false;
}

bool edgesPartLast(const Case& c, const Contact& contact) {
  const Polygon of_a = contact.edge_a < 0 ? c.a : edgeOf(c.a, contact.edge_a);
  const Polygon of_b = contact.edge_b < 0 ? c.b : edgeOf(c.b, contact.edge_b);
  return within(of_a, c.pose_a, of_b, moved(c.pose_b, contact.depth * contact.normal), 4 * rounding(c));
}

std::string wrongWayApart(const Case& c, const Contact& contact) {
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  if (!p) return "no penetration";
  const double shifts = c.pose_a.translation().lpNorm<1>() + c.pose_b.translation().lpNorm<1>();
  const double precision =
      1e-12 * std::min(c.a.radius(), c.b.radius()) + 1e-13 * (c.a.radius() + c.b.radius() + shifts) + rounding(c);
  // Where the shortest way is longer than that, none can.
  if (contact.depth == 0)
    return p->depth > std::min(precision, beyond(c)) || parts(c, contact) ? ""
                                                                          : "the normal of a touch doesn't part them";
  if (!p->optimal) return "";
  if (!(std::abs(p->depth - contact.depth) <= precision)) return "another depth than the penetration's";
  // Of a short way the direction is known as well as its ends are.
  const double between = (c.pose_b.translation() - c.pose_a.translation()).norm();
  const double turn = 1e-15 * (c.a.radius() + c.b.radius() + between) / contact.depth;
  return (p->normal - contact.normal).norm() <= 1e-6 + turn || parts(c, contact)
             ? ""
             : "another normal than the penetration's";
}

bool same(const std::vector<Contact>& p, const std::vector<Contact>& q) {
  return std::equal(p.begin(), p.end(), q.begin(), q.end(), [](const Contact& s, const Contact& t) {
    return s.point == t.point && s.normal == t.normal && s.depth == t.depth && s.edge_a == t.edge_a &&
           s.edge_b == t.edge_b && s.count == t.count && s.points[0].point == t.points[0].point &&
           s.points[0].depth == t.points[0].depth && s.points[1].point == t.points[1].point &&
           s.points[1].depth == t.points[1].depth;
  });
}

}  // namespace tricover::support
