// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <vector>

#include "cases.h"
#include "queries.h"
#include "reproduction.h"
#include "soak.h"
#include "tricover/collide.h"
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
  const double margin = random.oneIn(4) ? size * random.real(0, 2) : 0;
  for (const support::Query& query : support::queries()) {
    if (query.alike == nullptr || !random.oneIn(3)) continue;
    const std::string wrong = support::wrongWithCache(c, query, {margin, random.oneIn(4), &caches.pair});
    if (!wrong.empty()) return wrong;
  }
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
