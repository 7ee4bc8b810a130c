// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/locate.h"

#include <cmath>

#include "cases.h"
#include "exact_reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "soak.h"

namespace tricover::soak {
namespace {

/// On a vertex, on an edge or beside one by hardly anything, anywhere, or far away.
Vec2 anyPoint(Random& random, const Polygon& polygon) {
  const EdgeIndex edge = support::anyEdge(random, polygon);
  const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge);
  switch (random.integer(0, 4)) {
    case 0:
      return random.coin() ? v : Vec2(v.x(), w.y());
    case 1:
      return support::nudged(random, v + random.integer(1, 7) / 8.0 * (w - v), random.integer(0, 2));
    case 2:
      return v + random.unit() * (w - v) + std::pow(10, random.real(-17, 0)) * random.unit() * (polygon.origin() - v);
    case 3:
      return polygon.origin() + random.real(0, 3) * (v - polygon.origin());
    default:
      return polygon.origin() + polygon.radius() * Vec2(random.real(-1, 1), random.real(-1, 1));
  }
}

}  // namespace

/// locate() against the exact truth, without a cache and with one that follows the point.
void soakLocate(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    const Drawn drawn = anyCase(random);
    for (const Polygon& polygon : {drawn.c.a, drawn.c.b}) {
      PointCache cache;
      Vec2 point = anyPoint(random, polygon);
      for (int i = 0; i < 12; ++i) {
        if (random.oneIn(3))
          point = anyPoint(random, polygon);
        else
          point += std::pow(10, random.real(-17, 0)) * random.unit() * (anyPoint(random, polygon) - point);
        if (!point.allFinite()) break;
        const Location truth = Reference::locate(polygon, point), cold = locate(polygon, point);
        run.count(drawn.family, truth != Location::Outside);
        if (cold != truth || locate(polygon, point, cache) != truth)
          run.fail(drawn.family, cold != truth ? "locate" : "locate with a cache",
                   support::reproduction(polygon, point));
      }
    }
  }
}

}  // namespace tricover::soak
