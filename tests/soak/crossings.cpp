// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases.h"
#include "contact_laws.h"
#include "exact_reference.h"
#include "reproduction.h"
#include "soak.h"
#include "tricover/contacts.h"

namespace tricover::soak {
namespace {

Polygon edgeOf(const Polygon& polygon, EdgeIndex edge) {
  return Polygon({{polygon.edgeStart(edge), polygon.edgeEnd(edge), polygon.edgeEnd(edge)}});
}

/// The point is on both edges, but for rounding.
bool isCommon(const Case& c, const Crossing& crossing) {
  const Polygon p({Ring(3, crossing.point)});
  const double error = support::rounding(c);
  const Case of_a{edgeOf(c.a, crossing.edge_a), c.pose_a, p, Pose::Identity()};
  const Case of_b{edgeOf(c.b, crossing.edge_b), c.pose_b, p, Pose::Identity()};
  return Reference(of_a).within(error) && Reference(of_b).within(error);
}

/// One pair of edges is listed if and only if it is within the margin.
bool areWithin(Random& random, const Case& c, double margin) {
  const auto anyEdge = [&](const Polygon& polygon) {
    return static_cast<EdgeIndex>(random.integer(0, static_cast<int>(polygon.vertexCount()) - 1));
  };
  const EdgeIndex i = anyEdge(c.a), j = anyEdge(c.b);
  const bool are_edges = exact::edgesOfCrossings(c.a)[static_cast<std::size_t>(i)] &&
                         exact::edgesOfCrossings(c.b)[static_cast<std::size_t>(j)];
  const std::vector<Crossing> found = crossings(c.a, c.pose_a, c.b, c.pose_b, {margin});
  const auto count =
      std::count_if(found.begin(), found.end(), [&](const Crossing& x) { return x.edge_a == i && x.edge_b == j; });
  const bool are_within = Reference({edgeOf(c.a, i), c.pose_a, edgeOf(c.b, j), c.pose_b}).within(margin);
  return count == (are_edges && are_within ? 1 : 0);
}

}  // namespace

/// crossings() lists exactly the pairs of edges that share a point.
void soakCrossings(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    const Drawn drawn = anyCase(random);
    const Case& c = drawn.c;
    const bool turned = random.oneIn(4);
    const std::vector<Crossing> found =
        turned ? crossings(c.b, c.pose_b, c.a, c.pose_a) : crossings(c.a, c.pose_a, c.b, c.pose_b);
    std::vector<std::pair<EdgeIndex, EdgeIndex>> pairs;
    for (const Crossing& x : found) pairs.emplace_back(turned ? x.edge_b : x.edge_a, turned ? x.edge_a : x.edge_b);
    std::sort(pairs.begin(), pairs.end());
    run.count(drawn.family, !pairs.empty());
    std::string problem = pairs == Reference(c).meetingEdges() ? "" : "pairs of edges";
    if (problem.empty() && !turned && !found.empty() && support::rounding(c) < 1e285 && random.oneIn(4) &&
        !isCommon(c, found[static_cast<std::size_t>(random.integer(0, static_cast<int>(found.size()) - 1))]))
      problem = "a point beside its edges";
    if (problem.empty() && random.oneIn(8)) {
      const double margin = random.unit() * std::max(c.a.radius(), c.b.radius());
      if (std::isfinite(margin) && !areWithin(random, c, margin)) problem = "edges within " + support::hex(margin);
    }
    if (!problem.empty()) run.fail(drawn.family, problem, support::reproduction(c));
  }
}

}  // namespace tricover::soak
