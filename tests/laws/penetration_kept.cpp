// SPDX-License-Identifier: BSD-3-Clause
// Penetrations that soaking found to be wrong.
#include <algorithm>
#include <cmath>
#include <string>

#include "contact_laws.h"
#include "exact_penetration.h"
#include "exact_reference.h"
#include "law.h"
#include "shapes.h"
#include "tricover/penetration.h"

namespace tricover::laws {
namespace {

using namespace support;

/// A polygon of 1e-11 beside one of 1, of which soak found that a shorter way than the one that was said to be optimal
/// parts them: between edges so close together that what lies between them was never sampled.
std::string wrongBetweenEdges(Random&, Tally&) {
  const Polygon a({{{-0x1.00f8dd2c678a6p-41, 0x1.bc2d38ad0ed9cp-41},
                    {-0x1.7ba2bb4aae467p-39, 0x1.c049f42ddd318p-41},
                    {-0x1.14aa9de57e3ecp-37, 0x1.bc1b15702f636p-41},
                    {-0x1.1ee36f5ee6551p-37, 0x1.b6dabb11a988p-41},
                    {-0x1.5f0ff0c765ae4p-38, 0x1.b09b3a8efdbdbp-41},
                    {-0x1.c6520f3a68e84p-40, 0x1.b2311b5527982p-41}},
                   {{0x1.738922b887af1p-40, -0x1.4f6a94a8f6398p-39},
                    {-0x1.02386faf6ce2cp-38, 0x1.4a2a9ff617a36p-40},
                    {-0x1.3b903ec5d76f7p-38, 0x1.83bce2d17a15fp-40},
                    {-0x1.64472a1a86899p-38, 0x1.ab6035e21e491p-40},
                    {-0x1.3b990f2be4387p-39, -0x1.0073eebccb683p-39},
                    {0x1.e3fd9d2dc9fd8p-40, 0x1.7908851848953p-40},
                    {-0x1.7d19d1d6bd1eep-43, 0x1.5f9312576c341p-41},
                    {0x1.208dac988a35dp-40, 0x1.84135534da99p-39},
                    {-0x1.d5962760d6209p-40, 0x1.eb9c2988e2273p-40}},
                   {{0x1.1108d1d45d67ep-39, 0x1.716eac8be9c7bp-39},
                    {-0x1.888a7d4a82f86p-38, 0x1.57592bb8a4a7ep-38},
                    {0x1.7ba219ad2870cp-40, 0x1.17520895fa426p-41}}},
                  FillRule::EvenOdd);
  const Pose pose_a =
      pose(0x1.1a62633145c07p-54, 0x1p+0, -0x1.0495fbd43a622p+1, 0x1p+0, -0x1.1a62633145c07p-54, 0x1.91682f665e0aap+2);
  const Polygon b({{{0x1.8f38a723df3f6p-1, 0x1.db0e6109bfba8p-1},
                    {-0x1.17ac29407c11p-3, -0x1.fe95c008ecf18p-2},
                    {0x1.1d2cbccaefe64p-1, 0x1.3b082cddba532p-1},
                    {-0x1.464fef9f350ap-3, 0x1.0426dbca9c4dp-1},
                    {0x1.9b29bc668ae7p-3, 0x1.6a67be2acfd1p-2},
                    {-0x1.f5171869325ap-4, 0x1.3d089fa3cee02p-1},
                    {-0x1.d6e999cb73394p-1, -0x1.41ae0fc08192p-3}}},
                  FillRule::NonZero);
  const Pose pose_b = pose(0x1p+0, 0x0p+0, -0x1.4be12b06f59f3p+1, 0x0p+0, 0x1p+0, 0x1.6a0729caa7394p+2);
  const auto p = penetration(a, pose_a, b, pose_b);
  const Vec2 way = 9.75e-12 * Vec2(std::cos(0.2), std::sin(0.2));
  if (exact::collide(a, pose_a, b, moved(pose_b, way))) return "the way doesn't part them";
  return p && p->depth <= way.norm() && p->lower_bound <= way.norm() ? "" : "a shorter way isn't found";
}

/// A polygon of 4e-11, whose edges make lines that are taken for one, in one of 80: it leaves past its nearest edge.
std::string wrongPastLines(Random&, Tally&) {
  const Polygon a({{{0x1.31562653a5387p+5, 0x1.ca01397d77d4ap+4},
                    {0x1.31562653a5387p+5, -0x1.31562653a5387p+5},
                    {0x1.31562653a5387p+3, -0x1.31562653a5387p+3},
                    {0x0p+0, 0x1.ca01397d77d4ap+4},
                    {-0x1.ca01397d77d4ap+4, -0x1.ca01397d77d4ap+4},
                    {-0x1.ca01397d77d4ap+4, 0x1.ca01397d77d4ap+4},
                    {-0x1.ca01397d77d4ap+4, 0x1.31562653a5387p+3},
                    {0x1.31562653a5387p+4, -0x1.31562653a5387p+4}}},
                  FillRule::EvenOdd);
  const Pose pose_a = pose(0x1p+0, -0x0p+0, 0x1.3397f83709da6p+7, 0x0p+0, 0x1p+0, 0x1.15d13e9afa134p+6);
  const Polygon b({{{-0x1.7e4bbfc970b09p-36, 0x1.75bf4a6f6e2b8p-40},
                    {0x1.e4781ada59ed2p-36, -0x1.726607e9a004fp-41},
                    {-0x1.95c0d8aba319ap-39, -0x1.2ba75b13f5896p-36},
                    {0x1.003c110a1eae5p-35, -0x1.956ce4494df8cp-38},
                    {0x1.08caef9321663p-35, 0x1.5d3cadb65ec1fp-35},
                    {0x1.bd1b5c7567316p-36, -0x1.338228c8d5ee7p-37},
                    {0x1.32e298c768353p-37, -0x1.cfd3424fd530cp-40}}},
                  FillRule::EvenOdd);
  const Pose pose_b = pose(0x1.ffd3c2076e867p-1, -0x1.a9a88387cde2dp-6, 0x1.2c40a706d47d7p+7, 0x1.a9a88387cde2dp-6,
                           0x1.ffd3c2076e867p-1, 0x1.6ac6ad402f2f2p+6);
  const auto p = penetration(a, pose_a, b, pose_b);
  const Vec2 way = 0.02 * Vec2(-0.894427191, 0.4472135955);
  if (exact::collide(a, pose_a, b, moved(pose_b, way))) return "the way doesn't part them";
  return p && p->depth <= way.norm() && p->lower_bound <= way.norm() ? "" : "a shorter way isn't found";
}

/// Beside an edge of 1e-9: brute force has to look nearer than that.
std::string wrongBesideAShortEdge(Random&, Tally&) {
  const Polygon a({{{0x1.3f0a7b3c0c3c4p-3, -0x1.f9bfcee85dc07p-1},
                    {-0x1.dda3c39fd0a9dp-1, 0x1.70ce109c008acp-2},
                    {-0x1.dda3c21a14b97p-1, 0x1.70ce142e33bc4p-2},
                    {0x1.fffbce3af32dcp-1, 0x1.3461798049ea8p-9},
                    {0x1.fffdf6f2e55a3p-1, 0x1.31b51e8205fcp-9}}},
                  FillRule::NonZero);
  const Pose pose_a =
      pose(0x1.c94344a253c13p-1, -0x1.ccac21c639c3p-2, 0x0p+0, 0x1.ccac21c639c3p-2, 0x1.c94344a253c13p-1, 0x0p+0);
  const Polygon b({{{-0x1.b2cb9415a91eep-3, -0x1.b2cb9415a91eep-1},
                    {0x1.b2cb9415a91eep-3, 0x1.b2cb9415a91eep-2},
                    {-0x1.b2cb9415a91eep-3, 0x1.b2cb9415a91eep-3},
                    {-0x1.b2cb9415a91eep-1, -0x1.b2cb9415a91eep-1},
                    {-0x1.b2cb9415a91eep-1, 0x1.b2cb9415a91eep-2},
                    {-0x1.4618af103ed72p-1, 0x0p+0}}},
                  FillRule::EvenOdd);
  const Pose pose_b = pose(0x1p+0, 0x0p+0, -0x1.90d5cfbfa4c9ep-1, 0x0p+0, 0x1p+0, 0x1.809aebc50cf3cp-1);
  const auto p = penetration(a, pose_a, b, pose_b);
  return p && std::abs(p->depth - exact::penetrationDepth(a, pose_a, b, pose_b, 1)) <= 1e-16 ? "" : "depth";
}

/// An edge as short as an ulp has a direction.
std::string wrongOfAnUlp(Random&, Tally&) {
  const Polygon a({{{0x1.6f0162db005e8p-2, -0x1.c45915f50a2dep-1},
                    {-0x1.aae001de5d8aep-1, -0x1.0b8a668433c89p-1},
                    {-0x1.a7e031af1c978p-5, 0x1.e3e36b1c9619bp-1},
                    {0x1.b1383d9efa2cfp-1, 0x1.8d5be81265534p-2},
                    {0x1.b1384573d6861p-1, 0x1.8d5bdbf212c45p-2},
                    {0x1.c468ef2d5a797p-1, 0x1.c47dbabf05efep-3}}});
  const Pose pose_a =
      pose(0x1.c49c483786082p-1, -0x1.deb27cc02b8b3p-2, 0x0p+0, 0x1.deb27cc02b8b3p-2, 0x1.c49c483786082p-1, 0x0p+0);
  const Polygon b({{{0x1.4d507e1461a11p-1, 0x0p+0},
                    {0x1.4d507e1461a12p-2, 0x1.7a593731e3ffdp-3},
                    {-0x1.4d507e1461a0ep-2, 0x1.7a593731e3fffp-3},
                    {-0x1.4d507e1461a11p-1, 0x1.e1e7d7b867078p-56},
                    {-0x1.4d507e18742fbp-2, -0x1.7a59372d44957p-3},
                    {-0x1.4d507e0c3c84dp-2, -0x1.7a593731e3ffcp-3},
                    {0x1.4d507e1461a11p-2, -0x1.7a593731e3ffdp-3},
                    {0x1.4d507e1461a12p-2, -0x1.7a593731e3ffdp-3}}});
  const Pose pose_b = pose(-0x1.ef1c780d0c76cp-1, 0x1.04b258affea67p-2, 0x1.e40eedade9c03p-2, -0x1.04a2ef76ae28p-2,
                           -0x1.ef257f6a191ddp-1, -0x1.be8931b6a88a7p-1);
  const auto p = penetration(a, pose_a, b, pose_b);
  const double truth = exact::distanceBelow(exact::convexPenetrationSquared(a, pose_a, b, pose_b));
  return p && std::abs(p->depth - truth) <= 1e-15 * truth ? "" : "depth";
}

Laws penetrationKeptLaws() {
  return {{"between_edges", 1, wrongBetweenEdges},
          {"past_lines", 1, wrongPastLines},
          {"beside_a_short_edge", 1, wrongBesideAShortEdge},
          {"an_edge_of_an_ulp", 1, wrongOfAnUlp}};
}

const Register registered("penetration_kept", penetrationKeptLaws);

}  // namespace
}  // namespace tricover::laws
