// SPDX-License-Identifier: BSD-3-Clause
// What the point, the normal, the depth and the edges of a contact promise, on exact numbers: a point is in both
// regions, always; the only part's normal and depth are those of penetration(), or part them where they only touch.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "contact_laws.h"
#include "families.h"
#include "law.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/contacts.h"

namespace tricover::laws {
namespace {

using namespace support;

// What is no law, kept from growing. Beyond the end of the shortest way into a notch or a hole they may meet again, if
// it has room only aside; and a wedged touch, as of two segments that cross, has no way out. Of several parts each
// contact knows the edges around its own: those named are then not always those that part last.
std::string wrong(Random&, Tally& tally, Case& c) {
  if (!(rounding(c) < 1e290)) return {};  // where sums of coordinates overflow
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, globally());
  const bool is_convex = isStrictlyConvex(c.a) && isStrictlyConvex(c.b), is_alone = found.size() == 1;
  for (const Contact& contact : found) {
    const bool parted = !is_alone || parts(c, contact), last = edgesPartLast(c, contact);
    const char* kind = is_convex ? "convex" : contact.depth == 0 ? "touches" : "others";
    tally.count(kind + std::string(" not parted"), !parted);
    tally.count(kind + std::string(" with edges apart"), !last);
    const std::string wrong = !isCommon(c, contact) ? "the point lies outside"
                              : is_alone            ? wrongWayApart(c, contact)
                                                    : "";
    if (!wrong.empty()) return wrong;
    if (is_convex && !parted) return "the normal doesn't part them";
    if (is_convex && !last) return "other edges part last";
  }
  return {};
}

Case anyOfFamilies(Random& random) { return families()[random.bits() % families().size()].make(random.bits()); }

/// Of those whose shares are known.
Case oneOfFamilies(Random& random) {
  return families()[random.bits() % families().size()].make(static_cast<std::uint64_t>(random.integer(0, 599)));
}

Case stars(Random& random) {
  const auto anyStar = [&] { return Polygon({star(random, random.integer(4, 12), 0.5, 2)}); };
  Case c{anyStar(), randomPose(random, 3), anyStar(), randomPose(random, 0)};
  c.pose_b.translation() = c.pose_a.translation() + Vec2(random.real(-3, 3), random.real(-3, 3));
  return c;
}

/// A ring around the origin's upper half: the origin itself, or an edge through it, and corners above, from right to
/// left.
Ring fan(Random& random, bool with_edge) {
  Ring corners;
  for (int n = random.integer(2, 5); n > 0; --n) corners.emplace_back(random.integer(-6, 6), random.integer(1, 6));
  std::sort(corners.begin(), corners.end(), [](const Vec2& p, const Vec2& q) { return p.x() * q.y() > q.x() * p.y(); });
  const auto same = [](const Vec2& p, const Vec2& q) { return p.x() * q.y() == q.x() * p.y(); };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  if (corners.size() < 2) corners.emplace_back(-7, 1);
  if (!with_edge) return corners.insert(corners.begin(), Vec2(0, 0)), corners;
  corners.insert(corners.begin(), Vec2(random.integer(1, 6), 0));
  corners.emplace_back(-random.integer(1, 6), 0);
  return corners;
}

/// One of them above a line and one below, exactly, whatever the pose that both have does to them.
std::string wrongFans(Random& random, Tally& tally) {
  const Vec2 base(random.integer(-20, 20), random.integer(-20, 20)), along(random.integer(1, 7), random.integer(-7, 7));
  const Vec2 up(-along.y(), along.x());
  const int edge = random.integer(0, 2);  // neither's, a's or b's
  Ring below = fan(random, edge == 1), above = fan(random, edge == 2);
  for (Vec2& p : below) p = base - p.x() * along - p.y() * up;
  for (Vec2& p : above) p = base + p.x() * along + p.y() * up;
  const auto anyStart = [&](Ring& ring) {
    std::rotate(ring.begin(), ring.begin() + random.integer(0, static_cast<int>(ring.size()) - 1), ring.end());
    if (random.coin()) ring = reversed(ring);
  };
  anyStart(below);
  anyStart(above);
  Pose both = randomPose(random, 9);
  if (random.oneIn(3)) both.linear().setIdentity();
  if (random.oneIn(3)) both = mirrored(both);
  const Case c{Polygon({below}), both, Polygon({above}), both};
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, globally());
  tally.count("on an edge", edge != 0);
  const std::string problem = [&]() -> std::string {
    if (found.size() != 1) return std::to_string(found.size()) + " contacts";
    const Contact& contact = found[0];
    if (contact.depth != 0) return "a depth";
    if ((contact.point - both * base).norm() > rounding(c)) return "another point";
    if (edge != 0 && (contact.normal - (both.linear() * up).normalized()).norm() > 1e-9) return "another normal";
    if (!parts(c, contact)) return "the normal doesn't part them";
    if (contact.edge_a < 0 || contact.edge_b < 0 || !edgesPartLast(c, contact)) return "other edges";
    return {};
  }();

  return problem.empty() ? problem : problem + "\n" + reproduction(c);
}

/// The way out of a sliver parts it by no more than coordinates are off by.
std::string wrongSliver(Random&, Tally&) {
  const Polygon a({{{-0x1.0f6984a2f4936p-1, 0x1.74ba6ae98bf64p-1},
                    {0x1.4621e623c1b3p-1, 0x1.d48173ac94c1ep-1},
                    {-0x1.2baf0aff58084p-1, 0x1.bc8b71309f816p-1},
                    {-0x1.b7c0d66c81568p-2, 0x1.9082f5846856cp-1},
                    {-0x1.b332d4fc371dcp-1, 0x1.354d228e1197p-3},
                    {0x1.7fc94ce18abccp-1, -0x1.e6fbbf1686ca2p-1}}});
  const Pose pose_a =
      pose(-0x1.59febec9429f2p-1, -0x1.79669d3f646b8p-1, 0, 0x1.79669d3f646b8p-1, -0x1.59febec9429f2p-1, 0);
  const Polygon b({{{0x1.cba477ea68819p-35, 0},
                    {0x1.73dbca6851b96p-35, 0x1.d524c5fa6a734p-45},
                    {0x1.1c131ce63af14p-36, 0x1.7b8b9111e9afbp-44},
                    {-0x1.1c131ce63af12p-36, 0x1.7b8b9111e9afcp-44},
                    {-0x1.73dbca6851b95p-35, 0x1.d524c5fa6a736p-45},
                    {-0x1.7bcbfbe172957p-35, 0x1.aab81e82ccbd8p-45},
                    {-0x1.8d68ee525cff6p-35, 0x1.4c96f1f8c0092p-45},
                    {-0x1.a8fdc480dc0d1p-35, 0x1.725f67dbe3f4fp-46},
                    {-0x1.cb0aef1a267e7p-35, 0x1.9a4464cda8d74p-52},
                    {-0x1.cba477ea68819p-35, 0x1.b8353570a300fp-97},
                    {-0x1.b506500aa2e6cp-35, -0x1.e38151dab1c17p-47},
                    {-0x1.73dbca6851b97p-35, -0x1.d524c5fa6a732p-45},
                    {-0x1.1c131ce63af15p-36, -0x1.7b8b9111e9afbp-44},
                    {0x1.1c131ce63af1p-36, -0x1.7b8b9111e9afcp-44},
                    {0x1.73dbca6851b95p-35, -0x1.d524c5fa6a738p-45},
                    {0x1.88db2651d8575p-35, -0x1.64ed3b6d2f39bp-45}}});
  const Pose pose_b = pose(-0x1.a96c897495633p-1, 0x1.1ce21a17b05fcp-1, -0x1.1adda9a2d5655p+0, -0x1.1ce21a17b05fcp-1,
                           -0x1.a96c897495633p-1, -0x1.30d4097a83b53p-3);
  const Case c{a, pose_a, b, pose_b};
  const std::vector<Contact> found = contacts(a, pose_a, b, pose_b, globally());

  return found.size() == 1 ? wrongWayApart(c, found[0]) : "how many there are";
}

Laws contactWaysLaws() {
  Laws laws = {{"fans", 4000, wrongFans, {{"on an edge", 0.5, 0.9}}}, {"kept_sliver", 1, wrongSliver}};
  add(laws, {family("any_families", anyOfFamilies)}, 4000, wrong, {});
  add(laws, {family("families", oneOfFamilies)}, 20000, wrong,
      {{"touches not parted", 0, 0.02},
       {"touches with edges apart", 0, 0.002},
       {"others not parted", 0, 0.04},
       {"others with edges apart", 0, 0.02}});
  add(laws, {family("stars", stars)}, 4000, wrong,
      {{"others not parted", 0, 0.001}, {"others with edges apart", 0, 0.02}});
  return laws;
}

const Register registered("contact_ways", contactWaysLaws);

}  // namespace
}  // namespace tricover::laws
