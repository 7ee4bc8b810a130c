// SPDX-License-Identifier: BSD-3-Clause
// Penetrations and contacts of what is tiny beside, or thin, that the soak has found: how far apart things are is a few
// roundings there.
#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>
#include <vector>

#include "contact_laws.h"
#include "families.h"
#include "shapes.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

const Pose kIdentity = Pose::Identity();

/// Of coordinates, x and y in turns.
Ring ring(std::initializer_list<double> coordinates) {
  Ring result;
  for (const double* x = coordinates.begin(); x != coordinates.end(); x += 2) result.emplace_back(x[0], x[1]);
  return result;
}

/// Found by the soak: a free wedge beside edges that only a few of the search's resolutions are between.
TEST(Penetration, OfATinyMapBesideAnApex) {
  const Polygon map(
      {{{0, 0}, {0x1.97e200a0fd0c1p-37, 0}, {0, 0x1.97e200a0fd0c1p-37}},
       {{0x1.07ff30666268ep-36, 0}, {0x1.07ff30666268ep-35, 0}, {0x1.07ff30666268ep-36, 0x1.07ff30666268ep-36}},
       {{0, 0x1.07ff30666268ep-36}, {0x1.2e7c4bb9a6918p-37, 0x1.07ff30666268ep-36}, {0, 0x1.9f3d564335b1ap-36}},
       ring({0x1.07ff30666268ep-36, 0x1.07ff30666268ep-36, 0x1.256e9563a4affp-36, 0x1.07ff30666268ep-36,
             0x1.256e9563a4affp-36, 0x1.256e9563a4affp-36, 0x1.07ff30666268ep-36, 0x1.256e9563a4affp-36})});
  const Polygon spikes(
      {{{-1, -1}, {1, -1}, {0.5, -0.5}, {0.75, -0.75}, {-1, -0.75}, {0, 0.75}, {-0.5, -0.75}, {0.75, 0}}},
      FillRule::NonZero);
  const Pose pose_a =
      pose(-0x1.cb3c66b32a3c4p-1, 0x1.c4c0cd38c1a47p-2, 0, -0x1.c4c0cd38c1a47p-2, -0x1.cb3c66b32a3c4p-1, 0);
  const Pose pose_b = pose(0x1.fff975a2438c4p-1, -0x1.a2976f1cee4d5p-15, 0x1.39f18f0c270c7p-15, -0x1.a2976f1cee4d5p-15,
                           0x1.0003452ede39ep+0, -0x1.8004e7c655cafp-1);
  const auto p = penetration(map, pose_a, spikes, pose_b);
  ASSERT_TRUE(p);
  const double precision = 1e-13 * (map.radius() + spikes.radius() + pose_b.translation().norm());
  // The wedge's tip is 1.1322e-11 away, and where it is wider than twice the precision 1.15e-11.
  EXPECT_GE(p->depth, 1.1322e-11 - precision);
  EXPECT_LE(p->lower_bound, 1.15e-11);
}

/// Found by the soak: two convolution segments end a little more than rounding before they cross, since each stands for
/// several.
TEST(Penetration, OfATinyMapInTheCornerOfAComb) {
  const double w = 0x1.85fd44e2c82dfp+3, s = 0x1.a1df23a4951f8p-29;
  const Polygon comb({ring({0,     -4 * w, 7 * w, -4 * w, 7 * w, 4 * w, 6 * w, 4 * w, 6 * w, 0,     5 * w,
                            0,     5 * w,  4 * w, 4 * w,  4 * w, 4 * w, 0,     3 * w, 0,     3 * w, 4 * w,
                            2 * w, 4 * w,  2 * w, 0,      w,     0,     w,     4 * w, 0,     4 * w})});
  const Polygon map({rectangle(0, 0, s, s),
                     {{s, 0}, {2 * s, 0}, {s, s}},
                     {{0, s}, {s, s}, {0, 2 * s}},
                     rectangle(s, s, 0x1.32c86f9ec609ap-28, 0x1.32c86f9ec609ap-28)},
                    FillRule::NonZero);
  const Pose pose_b = pose(0x1.0003452ede39ep+0, -0x1.a2976f1cee4d5p-15, -0x1.a1df0208eba0ap-29, 0x1.a2976f1cee4d5p-15,
                           -0x1.0003452ede39ep+0, 0x1.e77c961be2b14p+5);
  const auto p = penetration(comb, mirrored(turnedAndMoved(1.5707963267948966, 0, 0)), map, pose_b);
  ASSERT_TRUE(p);
  // The comb's corner is at (0, 5w), and beside it, to the right and upwards, nothing.
  Vec2 least(1, 1);
  for (const Ring& ring : map.rings())
    for (const Vec2& v : ring) least = least.cwiseMin(pose_b * v - Vec2(0, 5 * w));
  EXPECT_NEAR(p->depth, least.norm(), 1e-12);
}

/// Found by the soak: beside the edge that the outlines take there is another one, turned by 4e-8, past which a little
/// less is enough.
TEST(Contacts, OfOnePartAreNoDeeperThanThePenetration) {
  const Polygon sliver(
      {ring({0x1.6ba48fdf6b5fp+4, -0x1.d168bf7fdce36p-17, -0x1.4612fa5ade32fp+3, -0x1.d3bf2465c2c58p-15,
             -0x1.99e90f1ddd425p+0, 0x1.007c7fbcb3ffep-14, -0x1.7238cb6a2063ap+0, 0x1.0303796f245b6p-14,
             -0x1.5ce91dec1d5eap+0, 0x1.02b31f6ef35aep-14, 0x1.fb5342d49b8e7p+3, 0x1.7d58fb695cdb2p-15})});
  const Polygon chamfered(
      {ring({0x1.756b1af046affp-9, -0x1.756b1af046affp-10, -0x1.756b1af046affp-10, 0x1.756b1af046affp-9,
             -0x1.756b1af046affp-9, 0x1.756b1af046affp-10, -0x1.181054343503fp-9, 0x1.756b1af046affp-10,
             -0x1.d2c5e1ac585bfp-10, 0x1.756b1af046affp-11, -0x1.756b1af046affp-10, 0, 0, -0x1.756b1af046affp-12,
             0x1.756b1af046affp-10, -0x1.756b1af046affp-11})});
  const Pose pose_a =
      pose(-0x1.737f6b2a7749bp-1, -0x1.605364a7a1cfbp-1, 0, -0x1.605364a7a1cfbp-1, 0x1.737f6b2a7749bp-1, 0);
  const Pose pose_b = turnedAndMoved(0, 0x1.f9f0952156e9fp-1, 0x1.dfdab4cb8f031p-1);
  const std::vector<Contact> found = contacts(sliver, pose_a, chamfered, pose_b, globally());
  const auto p = penetration(sliver, pose_a, chamfered, pose_b);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_TRUE(p && p->optimal);
  EXPECT_LE(found[0].depth, p->depth + 4e-13);  // what coordinates are rounded by
}

/// Found by the soak, and made smaller: pairs whose only contact has to lead apart.
TEST(Contacts, OfWhatIsTinyLeadApart) {
  const double u = 0x1.37185caf4f803p-26, v = 0x1.5acb5a0dbb496p-26, s = 0x1.d6bb93461bb2p-44;
  const Vec2 end(-0x1.8b8d1646d49a6p-1, 0x1.72f75b7176313p-1);
  const std::pair<const char*, Case> cases[] = {
      {"the edges around the part tell almost the right normal, along which a neighbour stays in the way",
       {Polygon({{{0.875, 0}, {0.875, 0.5}, {0.75, 0.5}}}),
        pose(0x1.00029df066cbdp+0, 0x1.3bc53357f7a73p-15, 0, 0x1.3bc53357f7a73p-15, 0x1.fff9ac88285ebp-1, 0),
        Polygon({{{u, 0}, {0x1.84b336d9daf45p-26, 0}, {u, 0x1.366b68aa2dd0cp-28}}, {{u, u}, {v, v}, {u, v}}}),
        pose(1, 0, 0x1.c0070ab802535p-1, 0, 1, 0x1.000126dabb8b6p-1)}},
      {"deeper than coordinates are off by, less deep than a search resolves",
       {Polygon({{{0, -1e6}, {1.25e6, 0}, {1e6, 1e6}, {1e6, 0}, {0, 0}}}), turnedAndMoved(0, 4, -0.5),
        Polygon({{{2, 3}, {0x1.fffff5c6f677cp+0, 0x1.80000706da7c8p+1}, {0x1.fffff1d94be9ep+0, 0x1.80000496a3316p+1}}}),
        pose(0x1.8eb96f646ec99p-1, -0x1.413096c471d19p-1, 0x1.e8488a61ee586p+19, 0x1.413096c471d19p-1,
             0x1.8eb96f646ec99p-1, -0x1.05d1af76c6p+2)}},
      {"a chip that only touches but for rounding, and is too thin for a direction to free it by a little",
       {Polygon({ring({-0x1.30371f4eeed47p-38, -0x1.610853a466b12p-58, 0x1.2449d131bef79p-38, -0x1.95be03af9d22bp-58,
                       0x1.2853c8fbeffcdp-38, 0x1.5118d6fa50476p-58})}),
        pose(0x1.1a6264p-54, -1, -0x1.22bcf4569873p+0, 1, 0x1.1a6264p-54, -0x1.f5c839ac5d59cp+2),
        Polygon({{end, {0x1.d418841e94568p-3, 0x1.443f22bb700b3p+0}, end}}, FillRule::NonZero),
        pose(0x1.ad4093ba14676p-1, 0x1.170ff7ef619abp-1, -0x1.d41b078650b82p+0, -0x1.17108b0efac9fp-1,
             0x1.ad3f0556d93c1p-1, -0x1.195efa6a52cb6p+3)}},
      {"the step that asks whether they part would take the triangle past itself",
       {Polygon({{{0, 0}, {s / 2, 0}, {s, 0}, {s / 2, s / 2}, {0, s}, {0, s / 2}}}),
        pose(-1, 0x1.1a62633145c07p-53, 0, 0x1.1a62633145c07p-53, 1, 0),
        Polygon({{{0.75, -0.75}, {-1, 0.5}, {0, 0}, {-0.5, 0.25}, {0, -0.25}}}),
        pose(-0x1.5944a2p-5, -0x1.ff8b88p-1, 0, 0x1.ff8b88p-1, -0x1.5944a2p-5, 0)}}};
  for (const auto& [what, c] : cases) {
    const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, globally());
    ASSERT_EQ(found.size(), 1u) << what;
    EXPECT_EQ(wrongWayApart(c, found[0]), "") << what;
  }
}

/// A flat triangle's two sides are one to doubles: its ends are no place of the overlap.
TEST(Contacts, OfAFlatTriangleAreOnIt) {
  const Polygon chamfered(
      {ring({0x1.09dd85bd74452p-2, 0x1.5abfd7e0fdb3cp-2, -0x1.a7b672365790ap-2, 0x1.aad7450822e8ap-4,
             -0x1.a7b672365790ap-2, 0x1.aad7450822e89p-4, -0x1.bbf688929315ap-3, -0x1.785b18270fc3p-2,
             0x1.a8218fd8e4c9fp-3, -0x1.7e07f1bb028d4p-2})});
  const Polygon flat({ring({0x1.35a322f14d91cp-3, -0x1.1204a8027541p+0, -0x1.588cfa8dc056p+0, 0x1.4b1b850d1bedcp-1,
                            -0x1.6898c8514a5bdp-1, -0x1.6d58fb42a45a8p-4})});
  const Case c{chamfered, kIdentity, flat,
               pose(0x1.1a62633145c07p-54, -1, -0x1.eabe8895eb10cp-2, 1, 0x1.1a62633145c07p-54, 0x1.829aa9c3f185p-1)};
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, globally());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(isCommon(c, found[0]));
}

/// Found by the soak: rings of a size of some resolutions of the search, beside a line. A clearance gave the limit,
/// which was 34 roundings short of the line.
TEST(Penetration, OfTinyRingsBesideALongLineEndsOnIt) {
  const Polygon line(
      {ring({-0x1.fd24ff7976c34p36, -0x1.10733d8bfea8fp38, -0x1.fd24ff7976c34p35, -0x1.10733d8bfea8fp37,
             -0x1.7ddbbf9b19127p36, -0x1.98acdc51fdfd7p37, -0x1.fd24ff7976c34p35, -0x1.10733d8bfea8fp37, 0, 0})});
  const Polygon rings(
      {ring({-0x1.5609e9536c2f5p-2, -0x1.ceb803743d7f2p-2, -0x1.65399c0b1fd2fp-1, 0x1.e9635cc197db1p-1,
             -0x1.ca0cff2b2404ep-3, 0x1.370a90c08d96dp0}),
       ring({0x1.267ba9defb6fp-1, -0x1.48e27e8668038p-1, -0x1.ba116cdc7108cp-1, -0x1.e6dc22786d852p-4,
             -0x1.93ee7fe71cebp-4, -0x1.95e98ea5c0559p0, 0x1.251e633626073p-2, -0x1.27eff87bb5cp0, 0x1.6262aa486c606p-2,
             -0x1.96ecdbf4cc208p-4, 0x1.7143e2b7eb097p-1, -0x1.8550c81603e15p-2}),
       ring({0x1.a3d5ffde56761p-8, -0x1.67ddaee7e494dp-1, -0x1.1ff769cb7dc9fp0, -0x1.e110b2e438cd5p-2,
             -0x1.6c464f42f79d8p-1, 0x1.b54f6ac9938ddp-1, -0x1.d116ba3ac9dc8p-4, 0x1.ae980fdd025f9p-1})},
      FillRule::NonZero);
  const Pose pose_line =
      pose(-0x1.ed011330fb733p-1, -0x1.14997505987c8p-2, 0, 0x1.1487555176532p-2, -0x1.ecf0f27970c3fp-1, 0);
  const Pose pose_rings = pose(-0x1.f22597e2a5b88p-1, 0x1.d92e1f86b305p-3, -0x1.3025354ed7fb9p-33, -0x1.d92e1f86b305p-3,
                               -0x1.f22597e2a5b88p-1, -0x1.02eec0efe7ee2p-32);
  const auto p = penetration(line, pose_line, rings, pose_rings);
  ASSERT_TRUE(p);
  const Polygon edge({{line.edgeStart(p->edge_a), line.edgeEnd(p->edge_a), line.edgeEnd(p->edge_a)}});
  const auto off = distance(edge, pose_line, Polygon({Ring(3, p->point_a)}), kIdentity);
  EXPECT_LE(off.distance, 1e-13 * line.radius());
}

}  // namespace
}  // namespace tricover::support
