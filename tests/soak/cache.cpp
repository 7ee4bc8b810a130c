// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <vector>

#include "cases.h"
#include "contact_laws.h"
#include "distance_laws.h"
#include "limited_distance.h"
#include "reproduction.h"
#include "soak.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"

namespace tricover::soak {
namespace {

/// What pairs remember, each asked of every query.
struct Caches {
  PairCache pair;
  PointCache point;
};

/// What differs from the cold answer; empty if nothing does.
std::string wrongAnswer(Random& random, const Case& c, double size, Caches& caches) {
  CollideOptions options;
  if (random.oneIn(4)) options.margin = size * random.real(0, 2);
  const bool cold = collide(c.a, c.pose_a, c.b, c.pose_b, options);
  const bool turned = random.oneIn(4);
  if (cold != (turned ? collide(c.b, c.pose_b, c.a, c.pose_a, caches.pair, options)
                      : collide(c.a, c.pose_a, c.b, c.pose_b, caches.pair, options)))
    return "collide, margin " + support::hex(options.margin);
  if (random.coin()) {
    support::LimitedOptions limits;
    limits.margin = options.margin;
    if (random.oneIn(3)) limits.limit = size * random.real(0, 3);
    const DistanceResult without = distance(c.a, c.pose_a, c.b, c.pose_b, limits),
                         with = turned ? support::swapped(distance(c.b, c.pose_b, c.a, c.pose_a, caches.pair, limits))
                                       : distance(c.a, c.pose_a, c.b, c.pose_b, caches.pair, limits);
    if (with.distance != without.distance)
      return "distance, margin " + support::hex(limits.margin) + ", limit " + support::hex(limits.limit);
  }
  const ContactOptions few{random.oneIn(3) ? options.margin : 0, random.oneIn(4) ? std::size_t{1} : 8};
  if (random.oneIn(4) && !support::same(contacts(c.a, c.pose_a, c.b, c.pose_b, caches.pair, few),
                                        contacts(c.a, c.pose_a, c.b, c.pose_b, few)))
    return "contacts";
  const Vec2 p = c.pose_a.inverse() * c.pose_b.translation();
  if (p.allFinite() && locate(c.a, p, caches.point) != locate(c.a, p)) return "locate " + support::reproduction(c.a, p);
  return {};
}

}  // namespace

/// Walks of two pairs in turns: with caches of their own, and with one that both use, all answers are the cold ones bit
/// for bit.
void soakCache(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    std::array<Drawn, 2> walks = {anyCase(random), anyCase(random)};
    if (random.oneIn(3)) walks[1].c.a = walks[0].c.a;
    std::array<Caches, 3> caches;
    for (int i = random.integer(10, 80); i > 0; --i)
      for (const std::size_t k : {0u, 1u}) {
        Drawn& drawn = walks[k];
        const std::string problem = wrongAnswer(random, drawn.c, drawn.size, caches[random.oneIn(4) ? 2 : k]);
        run.count(drawn.family, collide(drawn.c.a, drawn.c.pose_a, drawn.c.b, drawn.c.pose_b));
        if (!problem.empty()) run.fail(drawn.family, problem, support::reproduction(drawn.c));
        step(random, drawn.c);
      }
  }
}

}  // namespace tricover::soak
