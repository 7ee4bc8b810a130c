// SPDX-License-Identifier: BSD-3-Clause
// crossings() lists exactly the pairs of edges that share a point, or are within a margin.
#include <algorithm>
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
#include "tricover/contacts.h"
#include "tricover/distance.h"

namespace tricover::laws {
namespace {

using namespace support;

using Pairs = std::vector<std::pair<EdgeIndex, EdgeIndex>>;

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

Pairs pairsOf(const std::vector<Crossing>& crossings) {
  Pairs pairs;
  for (const Crossing& x : crossings) pairs.emplace_back(x.edge_a, x.edge_b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// What of the edges that results name is within the margin is listed, and nothing else.
std::string wrongWithMargin(Random& random, const Case& c) {
  const double apart = distance(c.a, c.pose_a, c.b, c.pose_b).distance;
  const double size = std::min(std::max(c.a.radius(), c.b.radius()), 1e140);
  const double margin = random.oneIn(3) && apart > 0 ? apart : random.unit() * size;
  if (!(margin < 1e150) || c.a.vertexCount() * c.b.vertexCount() > 1600) return {};
  const std::vector<bool> named_a = exact::edgesOfCrossings(c.a), named_b = exact::edgesOfCrossings(c.b);
  Pairs near;
  for (EdgeIndex i = 0; i < static_cast<EdgeIndex>(c.a.vertexCount()); ++i)
    for (EdgeIndex j = 0; j < static_cast<EdgeIndex>(c.b.vertexCount()); ++j)
      if (named_a[static_cast<std::size_t>(i)] && named_b[static_cast<std::size_t>(j)] &&
          Reference({edgeOf(c.a, i), c.pose_a, edgeOf(c.b, j), c.pose_b}).within(margin))
        near.emplace_back(i, j);
  return pairsOf(crossings(c.a, c.pose_a, c.b, c.pose_b, {margin})) == near ? "" : "edges within " + hex(margin);
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  const bool turned = random.oneIn(4);
  std::vector<Crossing> found =
      turned ? crossings(c.b, c.pose_b, c.a, c.pose_a) : crossings(c.a, c.pose_a, c.b, c.pose_b);
  if (turned)
    for (Crossing& x : found) std::swap(x.edge_a, x.edge_b);
  const Pairs pairs = pairsOf(found);
  tally.count("hits", !pairs.empty());
  if (pairs != Reference(c).meetingEdges()) return "pairs of edges";
  if (!found.empty() && rounding(c) < 1e285 && random.oneIn(4) &&
      !isOnBoth(c, found[static_cast<std::size_t>(random.integer(0, static_cast<int>(found.size()) - 1))]))
    return "a point beside its edges";
  return random.oneIn(8) ? wrongWithMargin(random, c) : "";
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
