// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "exact_reference.h"
#include "family_makers.h"
#include "shapes.h"

namespace tricover::support {
namespace {

bool adjacent(const Vec2& p, const Vec2& q) {
  return std::nextafter(p.x(), q.x()) == q.x() && std::nextafter(p.y(), q.y()) == q.y();
}

Vec2 anyDirection(Random& random, double length) {
  return turnedAndMoved(random.real(0, 6.3), 0, 0).linear().col(0) * length;
}

/// Two rings on either side of a common line, whose edges on it overlap, touch at their ends, or leave a gap.
Case onCommonLine(Random& random, const Pose& common) {
  const Vec2 along(random.integer(1, 7), random.integer(-7, 7)), left(-along.y(), along.x());
  const Vec2 base(random.integer(-20, 20), random.integer(-20, 20));
  const auto at = [&](double k, double side) { return Vec2(base + k * along + side * left); };
  const int end = random.integer(2, 6), from = end + random.integer(-3, 2), to = from + random.integer(1, 4);
  Ring ring_a = {at(0, 0), at(end, 0), at(end - 1, 1), at(0, 2)};
  Ring ring_b = {at(from, 0), at(from, -1), at(to + 1, -2), at(to, 0)};
  if (random.oneIn(3)) ring_b[0] = nudged(random, ring_b[0], 1);
  if (random.oneIn(3)) ring_b[3] = nudged(random, ring_b[3], 1);
  if (random.oneIn(4)) std::swap(ring_a, ring_b);
  return {Polygon({ring_a}), common, Polygon({ring_b}), common};
}

/// b's middle of its first edge comes to lie on that of a at the end of the motion, so that there they cross.
Case approaching(Case c, const Vec2& motion) {
  const auto middle = [](const Polygon& polygon) { return Vec2(0.5 * (polygon.edgeStart(0) + polygon.edgeEnd(0))); };
  c.pose_b.translation() = c.pose_a * middle(c.a) - c.pose_b.linear() * middle(c.b) - motion;
  return c;
}

Case anyShapesTurned(Random& random, double offset) {
  return {Polygon({anyRing(random)}), randomPose(random, offset), Polygon({anyRing(random)}), randomPose(random, 0)};
}

/// Turned shapes, as their poses are after `change`, brought to their first contact.
template <typename Change>
Case turnedContact(Random& random, Change change) {
  Case c = anyShapesTurned(random, 10);
  change(c);
  const Vec2 motion = anyDirection(random, 8);
  return atFirstContact(random, approaching(c, motion), motion, random.integer(0, 1));
}

}  // namespace

Ring anyRing(Random& random) {
  switch (random.integer(0, 3)) {
    case 0:
      return star(random, random.integer(4, 9), 0.4, 2);
    case 1:
      return regular(random.integer(3, 8), random.real(0.5, 2));
    case 2:
      return comb(random.integer(2, 3), 0.5, 0.25, 1);
    default: {
      const double x = random.integer(-4, 3), y = random.integer(-4, 3);
      return rectangle(x, y, x + random.integer(1, 3), y + random.integer(1, 3));
    }
  }
}

Pose anyPose(Random& random) {
  switch (random.integer(0, 3)) {
    case 0:
      return Pose::Identity();
    case 1:
      return turnedAndMoved(0, random.integer(-8, 8), random.integer(-8, 8) / 8.0);
    case 2: {
      Pose quarter = turnedAndMoved(0, random.integer(-8, 8), random.integer(-8, 8));
      quarter.linear() << 0, -1, 1, 0;
      return quarter;
    }
    default:
      return randomPose(random, 10);
  }
}

Case atFirstContact(Random& random, Case c, const Vec2& motion, int most_ulps) {
  const Vec2 start = c.pose_b.translation();
  const auto positionAt = [&](double s) { return Vec2(start + s * motion); };
  const auto collidesAt = [&](double s) {
    c.pose_b.translation() = positionAt(s);
    return exact::collide(c.a, c.pose_a, c.b, c.pose_b);
  };
  double low = 0, high = 1;
  const bool at_low = collidesAt(low);
  if (collidesAt(high) == at_low) return c;
  while (!adjacent(positionAt(low), positionAt(high))) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (collidesAt(middle) == at_low ? low : high) = middle;
  }
  c.pose_b.translation() = nudged(random, positionAt(random.coin() ? low : high), most_ulps);
  return c;
}

Case wedgeOnEdge(Random& random, const Polygon& a, const Pose& pose_a, EdgeIndex edge, double length) {
  const Vec2 v = pose_a * a.edgeStart(edge), w = pose_a * a.edgeEnd(edge);
  const double share = random.coin() ? random.integer(0, 8) / 8.0 : random.unit();
  const Vec2 point = v + share * (w - v);
  const Vec2 outwards =
      pose_a.linear() * Vec2(a.edgeEnd(edge).y() - a.edgeStart(edge).y(), a.edgeStart(edge).x() - a.edgeEnd(edge).x());
  Pose pose_b = anyPose(random);
  pose_b.translation() = random.coin() ? nudged(random, point, 2) : point;
  const Ring apex_at_origin = wedge(random, pose_b.linear().transpose() * outwards, length);
  if (random.coin()) return {a, pose_a, Polygon({apex_at_origin}), pose_b};
  const Vec2 shift(random.integer(-3, 3), random.integer(-3, 3));
  pose_b.translation() -= pose_b.linear() * shift;
  return {a, pose_a, Polygon({shifted(apex_at_origin, shift)}), pose_b};
}

Case vertexOnEdge(Random& random) {
  const Polygon a({anyRing(random)});
  return wedgeOnEdge(random, a, anyPose(random), anyEdge(random, a), random.real(0.01, 0.1));
}

Case vertexOnVertex(Random& random) {
  const Polygon a({random.coin() ? regular(random.integer(3, 7), 1) : anyRing(random)});
  const Pose pose_a = anyPose(random);
  const Vec2 vertex = a.edgeStart(anyEdge(random, a)), outwards = pose_a.linear() * (vertex - a.coveringOrigin());
  Pose pose_b = anyPose(random);
  pose_b.translation() = nudged(random, pose_a * vertex, random.integer(0, 2));
  return {a, pose_a, Polygon({wedge(random, pose_b.linear().transpose() * outwards, 0.05)}), pose_b};
}

Case collinearOverlap(Random& random) { return onCommonLine(random, anyPose(random)); }

Case collinearFarAway(Random& random) {
  // Under one pose what is exact between them stays so, however far away it takes them.
  Pose common = anyPose(random);
  common.translation() *= std::pow(10, random.integer(12, 306));
  return onCommonLine(random, common);
}

Case gapOfUlps(Random& random) {
  const double height = random.real(0.1, 10), shift = random.integer(-4, 4);
  const double bottom = nudged(height, random.integer(-4, 4));
  const Ring lower = rectangle(-1, height - 3, 1, height);
  Ring upper = {{-0.5, bottom}, {0.75, bottom}, {random.real(-3, 3), bottom + 1}};
  if (random.coin()) upper[0].y() = bottom + 0.5;
  const Pose common = anyPose(random);
  Pose pose_b = common;
  if (random.coin()) {
    // The same gap, now between a vertex and a translation that cancel.
    for (Vec2& vertex : upper) vertex.y() -= shift;
    pose_b.translation() += common.linear() * Vec2(0, shift);
  }
  return {Polygon({lower}), common, Polygon({upper}), pose_b};
}

Case rotatedContact(Random& random) {
  return turnedContact(random, [](Case&) {});
}

Case mirroredContact(Random& random) {
  return turnedContact(random, [&](Case& c) {
    const int which = random.integer(1, 3);
    if (which != 1) c.pose_a = mirrored(c.pose_a);
    if (which != 2) c.pose_b = mirrored(c.pose_b);
  });
}

Case floatPoseContact(Random& random) {
  return turnedContact(random, [](Case& c) {
    c.pose_a = throughFloat(c.pose_a);
    c.pose_b = throughFloat(c.pose_b);
  });
}

Case distortedPoseContact(Random& random) {
  return turnedContact(random, [&](Case& c) {
    c.pose_a = distorted(random, c.pose_a);
    c.pose_b = distorted(random, c.pose_b);
  });
}

Case farFromOrigin(Random& random) {
  Case c = anyShapesTurned(random, std::pow(10, random.integer(12, 15)));
  const double size = std::pow(10, random.integer(0, 3));
  c.a = Polygon({scaled(c.a.rings()[0], size)});
  c.b = Polygon({scaled(c.b.rings()[0], size)});
  if (random.coin()) {
    // As far away in its own frame, and brought back by its pose.
    const Vec2 far = anyDirection(random, std::pow(10, random.integer(12, 15)));
    c.a = Polygon({shifted(c.a.rings()[0], far)});
    c.pose_a.translation() -= c.pose_a.linear() * far;
  }
  const Vec2 motion = anyDirection(random, 8 * size);
  return atFirstContact(random, approaching(c, motion), motion, random.integer(0, 1));
}

Case largeBesideSmall(Random& random) {
  const Polygon a({scaled(anyRing(random), 1e6)});
  Case c = wedgeOnEdge(random, a, anyPose(random), anyEdge(random, a), 1e-6);
  if (random.coin()) c.pose_b.translation() += anyDirection(random, 1e-6);
  return c;
}

Case hugeBesideTiny(Random& random) {
  const Vec2 along(random.integer(1, 7), random.integer(-7, 7)), left(-along.y(), along.x());
  // An edge of size 1e150 exactly through the origin, and a vertex of a polygon of size 1e-150 near there.
  const Ring huge = {-3 * along, 5 * along, 2 * along + 4 * left, -1 * along + 4 * left};
  Ring tiny = wedge(random, -left, random.real(0.5, 2) * 1e-150);
  const int k = random.integer(-2, 2);
  tiny[0] = random.coin() ? Vec2(k * 0x1p-498 * along) : Vec2(random.real(-1, 1) * 1e-150 * left);
  tiny[0] = nudged(random, tiny[0], random.integer(0, 1));
  Pose pose_b = Pose::Identity();
  if (random.coin()) pose_b = throughFloat(turnedAndMoved(random.real(-0.1, 0.1), 0, 0));
  return {Polygon({scaled(huge, 0x1p498)}), Pose::Identity(), Polygon({tiny}), pose_b};
}

Case slivers(Random& random) {
  const double thin = 1e-12 * random.real(0.5, 2);
  const Ring sliver_a = {{-1, 0}, {1, random.real(-1, 1) * thin}, {random.real(-0.9, 0.9), thin}};
  Ring sliver_b = {{-1, 0}, {1, random.real(-1, 1) * thin}, {random.real(-0.9, 0.9), -thin}};
  const Pose pose_a = randomPose(random, 3);
  Pose pose_b = pose_a;
  if (random.coin()) {
    // Side by side, within a few thicknesses.
    pose_b.translation() += pose_a.linear() * Vec2(random.real(-0.2, 0.2), random.real(-1, 2) * thin);
    return {Polygon({sliver_a}), pose_a, Polygon({sliver_b}), pose_b};
  }
  pose_b = turnedAndMoved(random.real(0, 6.3), 0, 0);
  pose_b.translation() = pose_a.translation() - pose_b.linear() * Vec2(-1, 0);
  return atFirstContact(random, {Polygon({sliver_a}), pose_a, Polygon({sliver_b}), pose_b},
                        -2.5 * pose_a.linear().col(0), 1);
}

Case facingWalls(Random& random) {
  const auto anyStart = [&](Ring ring) {
    std::rotate(ring.begin(), ring.begin() + random.integer(0, 3), ring.end());
    return random.coin() ? ring : reversed(ring);
  };
  // Each end of either wall is as near to the other wall, but for ulps.
  const double gap = std::ldexp(random.real(0.5, 1), random.integer(-36, -24)), tilt = random.real(-1, 1) * 2e-14;
  const double low = random.coin() ? random.integer(-1, 0) * gap : gap, shift = random.real(-9, 9);
  const Ring lower = rectangle(0, -1, 20, 0);
  const Ring upper = {{shift, low}, {shift + 20, low + tilt}, {shift + 20, 1}, {shift, 1}};
  const Pose common = random.oneIn(4) ? anyPose(random) : randomPose(random, 10);
  return {Polygon({anyStart(lower)}), common, Polygon({anyStart(upper)}), common};
}

Case interlockingCombs(Random& random) {
  const double pitch = random.real(0.8, 1.2), gap = random.coin() ? 1e-9 : random.real(0.01, 0.1);
  const double width = (pitch - gap) / 2;
  const Ring up = comb(random.integer(3, 5), pitch, width, 1);
  const Pose pose_a = anyPose(random);
  Pose turned = turnedAndMoved(0, 0, 0);
  turned.linear() << -1, 0, 0, -1;
  turned.translation() = Vec2(pitch + width + pitch / 2, random.real(1.05, 1.9));
  const Case c{Polygon({up}), pose_a, Polygon({comb(random.integer(2, 3), pitch, width, 1)}), pose_a * turned};
  const Vec2 motion = random.coin() ? Vec2(random.coin() ? pitch : -pitch, 0) : Vec2(0, -1.5);
  return atFirstContact(random, c, pose_a.linear() * motion, 1);
}

}  // namespace tricover::support
