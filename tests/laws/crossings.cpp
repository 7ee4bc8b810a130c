// SPDX-License-Identifier: BSD-3-Clause
// crossings() lists exactly the pairs of edges that share a point, or are within a margin.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "contact_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/contacts.h"

namespace tricover::laws {
namespace {

using namespace support;

Polygon edgeOf(const Polygon& polygon, EdgeIndex edge) {
  return Polygon({{polygon.edgeStart(edge), polygon.edgeEnd(edge), polygon.edgeEnd(edge)}});
}

/// The point is on both edges, but for rounding.
bool isOnBoth(const Case& c, const Crossing& crossing) {
  const Polygon p({Ring(3, crossing.point)});
  const double error = support::rounding(c);
  const Case of_a{edgeOf(c.a, crossing.edge_a), c.pose_a, p, Pose::Identity()};
  const Case of_b{edgeOf(c.b, crossing.edge_b), c.pose_b, p, Pose::Identity()};
  return Reference(of_a).within(error) && Reference(of_b).within(error);
}

/// One pair of edges is listed if and only if it is within the margin.
bool areWithin(Random& random, const Case& c, double margin) {
  const EdgeIndex i = anyEdge(random, c.a), j = anyEdge(random, c.b);
  const bool are_edges = exact::edgesOfCrossings(c.a)[static_cast<std::size_t>(i)] &&
                         exact::edgesOfCrossings(c.b)[static_cast<std::size_t>(j)];
  const std::vector<Crossing> found = crossings(c.a, c.pose_a, c.b, c.pose_b, {margin});
  const auto count =
      std::count_if(found.begin(), found.end(), [&](const Crossing& x) { return x.edge_a == i && x.edge_b == j; });
  const bool are_within = Reference({edgeOf(c.a, i), c.pose_a, edgeOf(c.b, j), c.pose_b}).within(margin);
  return count == (are_edges && are_within ? 1 : 0);
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  const bool turned = random.oneIn(4);
  const std::vector<Crossing> found =
      turned ? crossings(c.b, c.pose_b, c.a, c.pose_a) : crossings(c.a, c.pose_a, c.b, c.pose_b);
  std::vector<std::pair<EdgeIndex, EdgeIndex>> pairs;
  for (const Crossing& x : found) pairs.emplace_back(turned ? x.edge_b : x.edge_a, turned ? x.edge_a : x.edge_b);
  std::sort(pairs.begin(), pairs.end());
  tally.count("hits", !pairs.empty());
  if (pairs != Reference(c).meetingEdges()) return "pairs of edges";
  if (!turned && !found.empty() && rounding(c) < 1e285 && random.oneIn(4) &&
      !isOnBoth(c, found[static_cast<std::size_t>(random.integer(0, static_cast<int>(found.size()) - 1))]))
    return "a point beside its edges";
  const double margin = random.oneIn(8) ? random.unit() * std::max(c.a.radius(), c.b.radius()) : 0;
  return !std::isfinite(margin) || areWithin(random, c, margin) ? "" : "edges within " + hex(margin);
}

Laws crossingsLaws() {
  Laws laws;
  add(laws, families(), 1500, wrong, {{"hits", 0.02, 1}});
  add(laws, anyPairs(), 1000, wrong);
  return laws;
}

const Register registered("crossings", crossingsLaws);

}  // namespace
}  // namespace tricover::laws
