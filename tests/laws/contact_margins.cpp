// SPDX-License-Identifier: BSD-3-Clause
// Contacts and penetrations with a margin, against exact distances, and beside polygons that are grown.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "penetration_laws.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover::laws {
namespace {

using namespace support;

std::string wrong(Random& random, Tally& tally, Case& c) {
  const double apart = distance(c.a, c.pose_a, c.b, c.pose_b).distance;
  const double size = std::min(std::max(c.a.radius(), c.b.radius()), 1e140);
  const double margin = random.oneIn(3) && apart > 0 ? apart : random.unit() * size;
  if (!(margin < 1e150)) return {};
  const bool truth = Reference(c).within(margin);
  tally.count("hits", truth);
  if (truth) tally.count("apart", apart > 0);
  std::string problem = rounding(c) < 1e285 ? wrongContactsWithMargin(c, margin) : "";
  if (problem.empty() && c.a.vertexCount() * c.b.vertexCount() < 2000)
    problem = wrongPenetration(random, c, margin, penetration(c.a, c.pose_a, c.b, c.pose_b, {margin}), 2);
  return problem.empty() ? problem : problem + ", margin " + hex(margin);
}

/// The polygon of one ring, grown by a regular polygon with its corners on a circle.
Polygon grown(const Polygon& polygon, double radius, int corners) {
  std::vector<Ring> rings = polygon.rings();
  double area = 0;
  for (std::size_t i = 0; i < polygon.vertexCount(); ++i) {
    const Vec2 p = polygon.edgeStart(static_cast<EdgeIndex>(i)), q = polygon.edgeEnd(static_cast<EdgeIndex>(i));
    area += p.x() * q.y() - p.y() * q.x();
  }
  if (area < 0) rings[0] = reversed(rings[0]);
  const Ring round = regular(corners, radius);
  for (std::size_t i = 0; i < polygon.vertexCount(); ++i) {
    const Vec2 p = polygon.edgeStart(static_cast<EdgeIndex>(i)), way = polygon.edgeEnd(static_cast<EdgeIndex>(i)) - p;
    // From the support vertex to one side of the edge round the start to that on the other, and likewise.
    Ring ring;
    const auto isBehind = [&](const Vec2& r) { return r.dot(way) < 0; };
    const auto first = std::find_if(round.begin(), round.end(), isBehind);
    std::size_t k = static_cast<std::size_t>(first - round.begin());
    while (isBehind(round[(k + round.size() - 1) % round.size()])) k = (k + round.size() - 1) % round.size();
    for (std::size_t j = 0; j < round.size(); ++j) {
      const Vec2 &r = round[(k + j) % round.size()], &next = round[(k + j + 1) % round.size()];
      const auto at = [&](const Vec2& corner, bool behind) {
        ring.push_back(behind ? Vec2(p + corner) : Vec2(p + way + corner));
      };
      at(r, isBehind(r));
      if (isBehind(r) == isBehind(next)) continue;
      // The corner that is farthest aside is one at both ends.
      const auto aside = [&](const Vec2& corner) { return std::abs(way.x() * corner.y() - way.y() * corner.x()); };
      if (aside(r) > aside(next))
        at(r, !isBehind(r));
      else
        at(next, isBehind(r));
    }
    rings.push_back(ring);
  }
  return Polygon(rings, FillRule::NonZero);
}

Case smallStars(Random& random) {
  const Polygon a({star(random, random.integer(4, 9), 0.3, 1)}), b({star(random, random.integer(3, 7), 0.2, 0.8)});
  const Pose pose_a = randomPose(random, 3);
  Pose pose_b = randomPose(random, 0);
  pose_b.translation() = pose_a.translation() + random.real(0, 1.6) * direction(random.real(0, 6.3));
  return {a, pose_a, b, pose_b};
}

/// A penetration is between that of polygons grown by less and by more.
std::string wrongBesideGrown(Random& random, Tally& tally, Case& c) {
  constexpr int kCorners = 48;
  const double margin = std::exp2(random.real(-8, 0)), beyond = margin / std::cos(M_PI / kCorners);
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b, {margin});
  const auto less = penetration(c.a, c.pose_a, grown(c.b, margin, kCorners), c.pose_b);
  const auto more = penetration(c.a, c.pose_a, grown(c.b, beyond, kCorners), c.pose_b);
  if ((less ? less->lower_bound : 0) > (p ? p->depth : 0) + 1e-9) return "less deep than grown by less";
  if ((p ? p->lower_bound : 0) > (more ? more->depth : 0) + 1e-9) return "deeper than grown by more";
  if (!p) return {};
  tally.count("hits", exact::collide(c.a, c.pose_a, c.b, c.pose_b));
  tally.count("optimal", p->optimal);
  return !p->optimal || !more || p->depth <= more->depth + 1e-9 ? "" : "deeper than grown by more, though optimal";
}

Case convexOfAnySize(Random& random) {
  const double scale = std::exp2(random.real(-300, 300));
  const Polygon a({anyConvex(random, scale)}), b({anyConvex(random, scale)});
  const Pose pose_a = randomPose(random, 3 * scale);
  Pose pose_b = randomPose(random, 0);
  pose_b.translation() = pose_a.translation() + random.real(0, 2.5) * scale * direction(random.real(0, 6.3));
  return {a, pose_a, b, pose_b};
}

/// Margins add to the depth, or take the distance.
std::string wrongConvex(Random& random, Tally& tally, Case& c) {
  const double scale = c.a.radius();
  const double margin = random.real(0, 1) * scale, apart = distance(c.a, c.pose_a, c.b, c.pose_b).distance;
  const auto bare = penetration(c.a, c.pose_a, c.b, c.pose_b), p = penetration(c.a, c.pose_a, c.b, c.pose_b, {margin});
  const auto found = contacts(c.a, c.pose_a, c.b, c.pose_b, globally(margin));
  tally.count("hits", p.has_value());
  if (p.has_value() != (bare || apart <= margin)) return "whether there is one";
  if (found.size() != (p ? 1u : 0u)) return "contacts";
  if (!p) return {};
  const double truth = bare ? bare->depth + margin : margin - apart;
  if (!(std::abs(p->depth - truth) <= 1e-14 * scale)) return "depth";
  if (!(std::abs(found[0].depth - truth) <= 1e-13 * scale)) return "a contact's depth";
  if (p->depth > 1e-6 * scale && !((p->normal - found[0].normal).norm() <= 1e-6)) return "normal";
  return p->optimal ? "" : "it isn't optimal";
}

Laws contactMarginsLaws() {
  Laws laws;
  add(laws, families(), 24, wrong, {{"hits", 0.02, 1}, {"apart", 0, 1}});
  add(laws, {family("stars", smallStars)}, 60, wrongBesideGrown, {{"hits", 0.1, 0.98}, {"optimal", 0.5, 1}});
  add(laws, {family("convex", convexOfAnySize)}, 2000, wrongConvex);
  return laws;
}

const Register registered("contact_margins", contactMarginsLaws);

}  // namespace
}  // namespace tricover::laws
