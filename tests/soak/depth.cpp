// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/depth.h"

#include <string>

#include "cases.h"
#include "depth_laws.h"
#include "exact_depth.h"
#include "reproduction.h"
#include "soak.h"

namespace tricover::soak {
namespace {

constexpr EdgeIndex kMostEdges = 40;  // for the oracle

std::string wrongAnswers(Random& random, const Case& c, const Depth& deep) {
  std::string wrong = support::wrongDepth(c, deep);
  if (wrong.empty() && random.oneIn(4)) wrong = support::wrongBesideOthers(random, c, deep);
  if (wrong.empty()) wrong = support::wrongMargins(random, c);
  if (!wrong.empty()) return wrong;
  const Excess out = excess(c.a, c.pose_a, c.b, c.pose_b);
  wrong = support::wrongExcess(c, out);
  if (wrong.empty() && random.oneIn(4)) wrong = support::wrongBesideOthers(random, c, out);
  if (wrong.empty()) wrong = support::wrongCoversButFor(c, out);
  if (!wrong.empty() || c.a.edgeCount() + c.b.edgeCount() > kMostEdges || !random.oneIn(4)) return wrong;
  wrong = support::wrongLargest(c, deep.depth, exact::depth(c.a, c.pose_a, c.b, c.pose_b));
  return wrong.empty() ? support::wrongLargest(c, out.distance, exact::excess(c.a, c.pose_a, c.b, c.pose_b)) : wrong;
}

}  // namespace

/// depth(), excess(), hausdorffDistance() and negative margins by their laws, small pairs against the oracle.
void soakDepth(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    Limits limits;
    limits.most_exponent = 280;
    limits.most_vertices = 16;
    const Drawn drawn = anyCase(random, limits);
    const Case c = support::pushedTogether(random, drawn.c);
    // Sums of coordinates must not overflow here.
    if (!(support::depthPrecision(c) < 1e285)) continue;
    const Depth deep = depth(c.a, c.pose_a, c.b, c.pose_b);
    run.count(drawn.family, deep.depth > 0);
    const std::string problem = wrongAnswers(random, c, deep);
    if (!problem.empty()) run.fail(drawn.family, problem, support::reproduction(c));
  }
}

}  // namespace tricover::soak
