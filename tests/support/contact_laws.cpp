// SPDX-License-Identifier: BSD-3-Clause
#include "contact_laws.h"

#include <algorithm>
#include <cmath>

#include "exact_reference.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

bool within(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, double length) {
  return exact::within(exact::distanceSquared(a, pose_a, b, pose_b), mpq_class(length));
}

/// One edge, as a polygon.
Polygon edgeOf(const Polygon& polygon, std::ptrdiff_t edge) {
  return Polygon({{polygon.edgeStart(edge), polygon.edgeEnd(edge), polygon.edgeStart(edge)}});
}

/// By how much more than the depth a way must lead apart.
double beyond(const Case& c) { return 4 * rounding(c) + 1e-9 * std::min(c.a.radius(), c.b.radius()); }

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

bool isConvex(const Polygon& polygon) {
  const Ring& ring = polygon.rings()[0];
  int left = 0, right = 0, changes = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()], &r = ring[(i + 2) % ring.size()];
    const double turn = (q.x() - p.x()) * (r.y() - q.y()) - (q.y() - p.y()) * (r.x() - q.x());
    left += turn > 0;
    right += turn < 0;
    changes += (q.x() > p.x()) != (r.x() > q.x());
  }
  const auto n = static_cast<int>(ring.size());
  return polygon.rings().size() == 1 && (left == n || right == n) && changes == 2;
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
