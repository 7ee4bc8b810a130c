// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cases.h"
#include "distance_laws.h"
#include "limited_distance.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "soak.h"

namespace tricover::soak {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr long double kError = 1e-14L, kSmallest = 0x1p-1074L;

bool isDistance(double found, const Reference& reference) {
  const Reference::Bounds truth = reference.distance();
  if (truth.high == 0 || found == 0) return truth.high == 0 && found == 0;
  if (found < kInfinity && found >= truth.high * (1 - kError) && found <= truth.low * (1 + kError)) return true;
  return support::isRootOf(found, reference.distanceSquared());
}

/// What the options allow of the distance less the margin, but for rounding of both together.
std::string wrongOptions(double found, const support::LimitedOptions& options, const Reference& reference) {
  const Reference::Bounds truth = reference.distance();
  const long double slack = 2 * kError * (truth.high + options.margin) + kSmallest;
  if ((found == 0) != reference.within(options.margin)) return "zero or not";
  if (found > options.limit && found < kInfinity) return "above the limit";
  if (found == kInfinity) {
    const bool is_found = truth.high < options.limit + static_cast<long double>(options.margin) - slack;
    return is_found && options.limit + options.margin < kInfinity ? "not found within the limit" : "";
  }
  if (found == 0) return "";
  if (found < truth.low - options.margin - slack) return "below the truth";
  const long double left = std::max(truth.high - options.margin, 0.0L);
  return found > (left + slack) * (1 + options.relative_error) + options.absolute_error + slack
             ? "more than the options allow"
             : "";
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
    support::LimitedOptions options;
    const std::string problem = [&]() -> std::string {
      if (!isDistance(cold.distance, reference)) return "distance";
      if (!support::same(support::swapped(distance(c.b, c.pose_b, c.a, c.pose_a)), cold)) return "swapped";
      if (random.oneIn(8) && !support::wrongPoints(c, cold).empty()) return support::wrongPoints(c, cold);
      if (!random.oneIn(4)) return "";
      options = anyOptions(random, cold.distance);
      return wrongOptions(distance(c.a, c.pose_a, c.b, c.pose_b, options).distance, options, reference);
    }();
    if (problem.empty()) continue;
    run.fail(drawn.family,
             problem + ", found " + support::hex(cold.distance) + ", truth " +
                 support::hex(static_cast<double>(reference.distance().low)) + ", margin " +
                 support::hex(options.margin) + ", errors " + support::hex(options.relative_error) + " and " +
                 support::hex(options.absolute_error) + ", limit " + support::hex(options.limit),
             support::reproduction(c));
  }
}

}  // namespace tricover::soak
