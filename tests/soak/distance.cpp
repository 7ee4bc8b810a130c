// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cases.h"
#include "distance_laws.h"
#include "reproduction.h"
#include "shapes.h"
#include "soak.h"

namespace tricover::soak {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr long double kError = 1e-14L;

bool isDistance(double found, const Reference& reference) {
  const Reference::Bounds truth = reference.distance();
  if (truth.high == 0 || found == 0) return truth.high == 0 && found == 0;
  if (found < kInfinity && found >= truth.high * (1 - kError) && found <= truth.low * (1 + kError)) return true;
  return support::isRootOf(found, reference.distanceSquared());
}

support::LimitedOptions anyOptions(Random& random, double cold) {
  support::LimitedOptions options;
  const double length = std::min(cold, std::numeric_limits<double>::max()) * random.real(0, 2);
  if (random.coin()) options.margin = random.coin() ? length : support::nudged(std::min(cold, length), 1);
  if (random.coin()) options.relative_error = random.coin() ? 0.5 : 1e-3;
  if (random.coin()) options.absolute_error = random.coin() ? length : 1e-3 * length;
  if (random.coin()) options.limit = random.coin() ? cold : length;
  return options;
}

}  // namespace

/// distance() against the exact truth, in both orders; its points; and what options allow.
void soakDistance(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    const Drawn drawn = anyCase(random);
    const Case& c = drawn.c;
    const Reference reference(c);
    run.count(drawn.family, reference.collide());
    const DistanceResult cold = distance(c.a, c.pose_a, c.b, c.pose_b);
    const std::string problem = [&]() -> std::string {
      if (!isDistance(cold.distance, reference)) return "distance";
      if (!support::same(support::swapped(distance(c.b, c.pose_b, c.a, c.pose_a)), cold)) return "swapped";
      if (random.oneIn(8) && !support::wrongPoints(c, cold).empty()) return support::wrongPoints(c, cold);
      if (!random.oneIn(4)) return "";
      const support::LimitedOptions options = anyOptions(random, cold.distance);
      const std::string wrong = random.oneIn(8) ? support::wrongSignedDistance(c, options.margin) : "";
      if (!wrong.empty()) return wrong + ", margin " + support::hex(options.margin);
      PairCache cache;
      return support::wrongDistances(c, options, reference.distanceSquared(), cache);
    }();
    if (problem.empty()) continue;
    run.fail(drawn.family,
             problem + ", found " + support::hex(cold.distance) + ", truth " +
                 support::hex(static_cast<double>(reference.distance().low)),
             support::reproduction(c));
  }
}

}  // namespace tricover::soak
