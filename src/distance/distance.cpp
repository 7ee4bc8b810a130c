// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "distance/convex_nearest.h"
#include "distance/distance_search.h"
#include "distance/edge_distance.h"
#include "distance/options.h"
#include "distance/point_distance.h"
#include "distance/ring_distance.h"
#include "numbers/double_double.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/containment.h"
#include "pair/discs.h"
#include "pair/edge_pairs.h"
#include "pair/facts.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"

namespace tricover {
namespace detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity(), kLargest = std::numeric_limits<double>::max();

/// Two polygons and their poses, in the kernel's own order.
struct Pair {
  const PolygonData& a;
  const Pose& pose_a;
  const PolygonData& b;
  const Pose& pose_b;
  bool is_swapped;  ///< the caller's order is the other one
};

DistanceResult inCallersOrder(const Pair& pair, double distance, const Vec2& point_a, const Vec2& point_b,
                              std::ptrdiff_t edge_a, std::ptrdiff_t edge_b) {
  if (pair.is_swapped) return {distance, point_b, point_a, edge_b, edge_a};
  return {distance, point_a, point_b, edge_a, edge_b};
}

Double2 onEdge(Double2 v, Double2 w, double along) { return along == 0 ? v : along == 1 ? w : v + along * (w - v); }

Vec2 plainPoint(const PolygonData& polygon, const Pose& pose, std::size_t edge, double along) {
  Vec2 point;
  store2(point.data(), onEdge(load2(polygon.path[edge].data()), load2(polygon.path[edge + 1].data()), along));
  return posed(pose, point);
}

/// Rounded as a posed vertex is. What could overflow on the way is made smaller first.
Vec2 worldPoint(const PolygonData& polygon, const Pose& pose, std::size_t edge, double along) {
  const Double2 shift = absolute(load2(pose.data() + 6));
  if (polygon.extent < 0x1p1000 && shift[0] + shift[1] < 0x1p1000) return plainPoint(polygon, pose, edge, along);
  const Double2 v = load2(polygon.path[edge].data()), w = load2(polygon.path[edge + 1].data());
  constexpr double kScale = 0x1p-4;
  Pose smaller = pose;
  smaller.translation() *= kScale;
  Vec2 point;
  store2(point.data(), onEdge(v * kScale, w * kScale, along));
  return posed(smaller, point) / kScale;
}

DistanceResult farResult() {
  const Vec2 none = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  return {kInfinity, none, none, -1, -1};
}

bool areWithin(const Pair& pair, double margin) {
  CollideOptions options;
  options.margin = margin;
  return collideByHierarchy(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b), options, 0, Wanted::Answer).collides;
}

/// What is left of a distance that EdgeDistances::at() returned. Where rounding hides whether anything is, collide()
/// tells.
double beyond(const Pair& pair, double distance, double margin) {
  if (margin == 0) return distance;
  const double finite = std::min(distance, kLargest);
  if (EdgeDistances::below(finite) > margin) return distance - margin;
  const bool within = EdgeDistances::above(finite) <= margin || areWithin(pair, margin);
  return within ? 0 : std::max(distance - margin, std::numeric_limits<double>::denorm_min());
}

/// What is left is above the limit, but what was found may be too large by rounding: whether the truth is within the
/// limit and the margin together, their sum rounded down.
bool isWithinLimit(const Pair& pair, double found, const DistanceOptions& options) {
  if (!(found <= SearchReach(options).most()) || options.limit == 0) return false;
  const DoubleDouble sum = twoSum(std::min(options.limit, kLargest), options.margin);
  return areWithin(pair, std::min(sum.low < 0 ? std::nextafter(sum.high, 0) : sum.high, kLargest));
}

/// Of edges i and j, at their nearest or common point.
DistanceResult resultOf(const Pair& pair, const EdgeDistances::Nearest& nearest, bool meets, std::size_t i,
                        std::size_t j, const DistanceOptions& options) {
  const double distance = beyond(pair, nearest.distance, options.margin);
  if (!(distance <= options.limit) && !isWithinLimit(pair, nearest.distance, options)) return farResult();
  const Vec2 point_a = worldPoint(pair.a, pair.pose_a, i, nearest.along_a);
  const Vec2 point_b = meets ? point_a : worldPoint(pair.b, pair.pose_b, j, nearest.along_b);
  return inCallersOrder(pair, std::min(distance, options.limit), point_a, point_b,
                        static_cast<std::ptrdiff_t>(pair.a.edgeNumber(i)),
                        static_cast<std::ptrdiff_t>(pair.b.edgeNumber(j)));
}

DistanceResult resultOf(const Pair& pair, const DistanceSearch& search, const DistanceOptions& options) {
  return resultOf(pair, search.best(), search.meets(), search.edgeA(), search.edgeB(), options);
}

DistanceResult contained(const Pair& pair, const Outcome& outcome) {
  const bool in_b = outcome.edge_a >= 0;
  const auto edge = static_cast<std::size_t>(in_b ? outcome.edge_a : outcome.edge_b);
  const Vec2 point = in_b ? worldPoint(pair.a, pair.pose_a, edge, 0) : worldPoint(pair.b, pair.pose_b, edge, 0);
  const auto number = static_cast<std::ptrdiff_t>((in_b ? pair.a : pair.b).edgeNumber(edge));
  return inCallersOrder(pair, 0, point, point, in_b ? number : -1, in_b ? -1 : number);
}

/// How many of the pairs that the fact lists had to be shown for the least distance, or a meeting, to be among them
/// after a motion; -1 if it isn't certain to be.
int recall(const DistanceFacts& cache, const Remainder& remainder, DistanceSearch& search) {
  const bool apart = remainder.of(cache.apart[0]) > 0;
  for (int k = 0; k <= cache.count; ++k) {
    if (EdgeDistances::below(remainder.of(cache.apart[k])) > search.worth()) return k;
    if (k == cache.count) break;
    if (apart)
      search.showNear(cache.first_edge[k], cache.second_edge[k]);
    else if (!search.show(cache.first_edge[k], cache.second_edge[k]))
      return k;
  }
  return -1;
}

Remainder remainderOf(const DistanceFacts& cache, const Pair& pair, bool& both_moved) {
  const bool a_moved = !sameAs(cache.first_pose, pair.pose_a), b_moved = !sameAs(cache.second_pose, pair.pose_b);
  both_moved = a_moved && b_moved;
  const double motion = (a_moved ? Change(pair.a, cache.first_pose, pair.pose_a).displacement() : 0) +
                        (b_moved ? Change(pair.b, cache.second_pose, pair.pose_b).displacement() : 0);
  return {roundedDown<Remainder::kRoundings>(1), motion};
}

/// Shows the search what it must see. False if two edges meet.
bool descend(const PosedPair& pair, DistanceSearch& search) {
  // The discs' farthest points are no nearer than any of the polygons.
  const double dx = std::abs(pair.center_x - pair.a.origin.x()), dy = std::abs(pair.center_y - pair.a.origin.y());
  constexpr int kSums = 1 + 4;  // one difference, four sums; and the scale's sum and product
  search.limitTo(
      roundedUp<kSums + 2>((dx + dy + 2 * pair.error + pair.a.radius + pair.radiusB()) * (1 + pair.scale_defect)));
  const auto limit = [&] { return pair.reach(EdgeDistances::above(search.reach())); };
  if (pair.a.isDegenerate() && pair.b.isDegenerate())
    return search.show(static_cast<std::uint32_t>(pair.a.degenerate_edge),
                       static_cast<std::uint32_t>(pair.b.degenerate_edge));
  // More pairs than there are edges are seldom shown, unless many are equally near: then it pays to prune those, and
  // to begin again without them. As patience is doubled, all beginnings together cost no more than the last.
  std::size_t patience = pair.a.path.size() + pair.b.path.size(), shown = 0;
  PrunedBoxes pruned;
  bool begins_again;
  do {
    begins_again = false;
    forNearPairs(
        pair, limit(), pruned.pairs(),
        [&](double, std::size_t i, std::size_t j) {
          if (!search.show(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))) return -1.0;
          if (++shown <= patience) return limit();
          patience *= 2;
          begins_again = search.prune(pruned);
          return begins_again ? -1 : limit();
        },
        [&](double length) {
          search.limitTo(roundedUp<2>(length * (1 + pair.scale_defect)));
          return limit();
        });
  } while (begins_again);
  return !search.meets();
}

/// Shows the search where the regions meet, which is known to be so, as collide() finds it: the deepest boxes first.
Outcome findMeeting(const PosedPair& pair, DistanceSearch& search) {
  const Outcome outcome = collideByHierarchy(pair, {}, 0, Wanted::Edges);
  if (outcome.edge_a >= 0 && outcome.edge_b >= 0)
    search.setMeeting(static_cast<std::uint32_t>(outcome.edge_a), static_cast<std::uint32_t>(outcome.edge_b));
  return outcome;
}

/// Shows the search what it must see when no fact helps; the result is where a ring lies inside the other region.
Outcome findNearest(const PosedPair& pair, DistanceSearch& search) {
  if (depthOfDiscs(Placement(pair.a, pair.pose_a, pair.b, pair.pose_b), 0) > 0) return findMeeting(pair, search);
  if (showSmall(pair, search)) return Outcome();
  return descend(pair, search) ? findContainment(pair) : Outcome();
}

/// Where `distance` is certain, see plainDistance().
DistanceResult resultOfPoints(const Pair& pair, double distance, const DistanceOptions& options) {
  const std::size_t i = pair.a.degenerate_edge, j = pair.b.degenerate_edge;
  return inCallersOrder(pair, beyond(pair, distance, options.margin), posed(pair.pose_a, pair.a.origin),
                        posed(pair.pose_b, pair.b.origin), static_cast<std::ptrdiff_t>(i),
                        static_cast<std::ptrdiff_t>(j));
}

/// DistanceFacts::hint: a kind of features of two small convex polygons, or a pair of edges that may be near.
constexpr std::uint8_t kNoHint = ConvexFeatures::kNone, kNearEdges = ConvexFeatures::kCrossing + 1;
/// DistanceFacts::answered: facts pay if they answer two queries, or more of small rings, whose search takes little, in
/// steps of at most that part of the radius. Those that didn't look ahead aren't judged.
constexpr std::uint8_t kPaying = 2, kPayingOfRings = 8, kUnjudged = 255;
constexpr double kCoherentPartOfRings = kCoherentPart / 16;
/// DistanceFacts::resting after facts have failed for the first, second, third time in a row, and from then on.
constexpr std::uint8_t kRests[] = {0, 3, 15, 63}, kMostFailed = 3;

bool knowsFacts(const DistanceFacts& cache) { return cache.count > 0 || cache.apart[0] > 0; }

void storePoses(DistanceFacts& cache, const Pair& pair) {
  store(cache.first_pose, pair.pose_a);
  store(cache.second_pose, pair.pose_b);
  cache.uses = 0;
}

/// Keeps no facts, but where it was nearest.
void storeHint(DistanceFacts& cache, std::uint8_t hint, std::uint32_t edge_a, std::uint32_t edge_b) {
  cache.count = 0;
  cache.apart[0] = 0;
  cache.hint = hint;
  cache.first_edge[0] = edge_a;
  cache.second_edge[0] = edge_b;
}

/// After facts that didn't answer: whether to find new ones.
void judgeFacts(DistanceFacts& cache, bool jumped, std::uint8_t paying) {
  if (!jumped && cache.answered == kUnjudged) return;
  cache.failed = !jumped && cache.answered >= paying ? 0 : std::min<std::uint8_t>(cache.failed + 1, kMostFailed);
  cache.resting = kRests[cache.failed];
}

/// After features were tried: one failure is nothing, they change now and then.
void judgeHint(DistanceFacts& cache, bool proven) {
  cache.resting = kRests[cache.failed];
  cache.failed = proven ? 0 : std::min<std::uint8_t>(cache.failed + 1, kMostFailed);
}

/// Whether the cache's facts answer; `outcome` is then where a ring lies inside the other region. If they don't, tells
/// the search how far to look ahead.
bool answersByFacts(const Pair& pair, DistanceFacts& cache, DistanceSearch& search, Outcome& outcome) {
  bool both_moved;
  Remainder remainder = remainderOf(cache, pair, both_moved);
  search.lookAhead(kInfinity);
  int shown = recall(cache, remainder, search);
  if (shown < 0 && both_moved) {
    remainder =
        remainderOfRelativeMotion(cache.first_pose, cache.second_pose, pair.a, pair.pose_a, pair.b, pair.pose_b);
    shown = recall(cache, remainder, search);
  }
  if (shown < 0) {
    const bool are_rings = areSmall(pair.a, pair.b);
    const double most = are_rings ? kCoherentPartOfRings * (cache.uses + 1.0) : kCoherentPart;
    const bool jumped = !(remainder.motion <= most * pair.b.radius);
    judgeFacts(cache, jumped, are_rings ? kPayingOfRings : kPaying);
    const double ahead = kStepsAhead * remainder.motion / (cache.uses + 1.0);
    search.lookAhead(jumped || cache.resting > 0 ? 0 : std::min(ahead, pair.b.radius));
    return false;
  }
  ++cache.uses;
  if (cache.answered < kPayingOfRings) ++cache.answered;
  if (!search.meets() && !(remainder.of(cache.apart[0]) > 0))
    outcome = findContainment(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b));
  if (!outcome.collides && search.refresh(cache, remainder, shown)) storePoses(cache, pair);
  return true;
}

/// By the cache, or so that the cache can tell the next time.
Outcome findCoherently(const Pair& pair, DistanceFacts& cache, DistanceSearch& search) {
  Outcome outcome;
  if (knowsFacts(cache)) {
    if (answersByFacts(pair, cache, search, outcome)) return outcome;
  } else if (cache.resting > 0) {
    --cache.resting;
    if (cache.hint == kNearEdges && !search.show(cache.first_edge[0], cache.second_edge[0])) return outcome;
  }
  const bool looks_ahead = search.looksAhead();
  outcome = findNearest(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b), search);
  if (outcome.collides && !search.meets()) {
    storeHint(cache, kNoHint, 0, 0);
  } else if (cache.resting > 0) {
    const ShownPair& upper = search.upperPair();
    const bool is_hint = search.hasUpper() && !areSmall(pair.a, pair.b);  // all of whose edges are asked anyway
    storeHint(cache, is_hint ? kNearEdges : kNoHint, upper.i, upper.j);
  } else {
    storePoses(cache, pair);
    cache.hint = kNoHint;
    cache.answered = looks_ahead ? 0 : kUnjudged;
    search.keep(cache);
  }
  return outcome;
}

/// The features that the cache knows, unless they rest.
ConvexFeatures hinted(DistanceFacts& cache) {
  if (cache.hint == kNoHint || cache.hint >= kNearEdges) return {};
  if (cache.resting > 0) {
    --cache.resting;
    return {};
  }
  return {static_cast<ConvexFeatures::Kind>(cache.hint), cache.first_edge[0], cache.second_edge[0]};
}

/// Of two strictly convex polygons, whether they are clearly apart, or small ones clearly meet.
bool findConvex(const Pair& pair, const PlainWays& ways, DistanceFacts* cache, const DistanceOptions& options,
                ConvexNearest& found) {
  if (pair.a.isDegenerate() || pair.b.isDegenerate()) return false;
  if (!hierarchyOf(pair.a).strictly_convex || !hierarchyOf(pair.b).strictly_convex) return false;
  const ConvexFeatures tried = cache != nullptr ? hinted(*cache) : ConvexFeatures();
  nearestOfConvex(ways, tried, options, found);
  if (!found.is_unique && !found.isInside() && found.meeting != Meeting::Apart) return false;
  if (cache != nullptr) {
    if (tried.kind != ConvexFeatures::kNone) judgeHint(*cache, found.is_proven);
    storeHint(*cache, found.features.kind, found.features.edge_a, found.features.edge_b);
  }
  return true;
}

/// Beyond a ring's last edge its first one comes.
std::uint32_t inRing(const PolygonData& polygon, std::uint32_t edge) {
  const auto count = static_cast<std::uint32_t>(polygon.path.size() - 1);
  return edge < count ? edge : edge - count;
}

DistanceResult resultOf(const Pair& pair, const PlainWays& ways, const ConvexNearest& found,
                        const DistanceOptions& options) {
  if (found.is_unique) {
    const EdgeDistances::Nearest& nearest = found.nearest;
    const std::size_t i = found.features.edge_a, j = found.features.edge_b;
    const bool meets = found.meeting == Meeting::Meet;
    if (options.margin > 0 || !(nearest.distance <= options.limit))
      return resultOf(pair, nearest, meets, i, j, options);
    // They are neither large nor have more than a ring.
    const Vec2 point_a = plainPoint(pair.a, pair.pose_a, i, nearest.along_a);
    const Vec2 point_b = meets ? point_a : plainPoint(pair.b, pair.pose_b, j, nearest.along_b);
    return inCallersOrder(pair, nearest.distance, point_a, point_b, static_cast<std::ptrdiff_t>(i),
                          static_cast<std::ptrdiff_t>(j));
  }
  if (found.isInside()) {
    Outcome outcome;
    outcome.edge_a = found.inner_a;
    outcome.edge_b = found.inner_b;
    return contained(pair, outcome);
  }
  const EdgeDistances edges(ways);
  DistanceSearch search(edges, options);
  for (std::uint32_t k = 0; k < found.edges_a.count; ++k)
    for (std::uint32_t l = 0; l < found.edges_b.count; ++l)
      search.showNear(inRing(pair.a, found.edges_a.first + k), inRing(pair.b, found.edges_b.first + l));
  search.finish();
  return resultOf(pair, search, options);
}

/// Of a point b and a polygon, where plain doubles do.
std::optional<DistanceResult> distanceFromPoint(const Pair& pair, const DistanceOptions& options) {
  const NearestEdge nearest = nearestEdge(pair.a, pair.pose_a, pair.b, pair.pose_b);
  if (!(nearest.distance > 0)) return std::nullopt;
  if (nearest.may_be_inside) {
    const Outcome outcome = findContainment(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b));
    if (outcome.collides) return contained(pair, outcome);
  }
  const double distance = beyond(pair, nearest.distance, options.margin);
  if (!(distance <= options.limit)) {
    if (nearest.distance > SearchReach(options).most()) return farResult();
    return std::nullopt;
  }
  return inCallersOrder(pair, distance, nearest.point_a, nearest.point_b,
                        static_cast<std::ptrdiff_t>(pair.a.edgeNumber(nearest.edge)),
                        static_cast<std::ptrdiff_t>(pair.b.degenerate_edge));
}

/// Of any polygons.
DistanceResult distanceBySearch(const Pair& pair, const PlainWays& ways, DistanceFacts* cache,
                                const DistanceOptions& options) {
  const EdgeDistances edges(ways);
  DistanceSearch search(edges, options);
  const Outcome outcome = cache != nullptr ? findCoherently(pair, *cache, search)
                                           : findNearest(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b), search);
  if (outcome.collides && !search.meets()) return contained(pair, outcome);
  search.finish();
  return resultOf(pair, search, options);
}

/// Of a point b and anything, where plain doubles do.
std::optional<DistanceResult> distanceOfPoint(const Pair& pair, const DistanceOptions& options) {
  if (!pair.a.isDegenerate()) return distanceFromPoint(pair, options);
  if (!pair.a.isPoint()) return std::nullopt;
  const double distance = plainDistance(pair.a, pair.pose_a, pair.b, pair.pose_b);
  const DistanceResult result = resultOfPoints(pair, distance, options);
  if (distance > 0 && result.distance <= options.limit) return result;
  return std::nullopt;
}

DistanceResult distanceInOrder(const Pair& pair, DistanceFacts* cache, const DistanceOptions& options) {
  if (pair.b.isPoint())
    if (const auto result = distanceOfPoint(pair, options)) return *result;
  if (cache != nullptr && (cache->first_id != pair.a.id || cache->second_id != pair.b.id)) {
    *cache = DistanceFacts();
    cache->first_id = pair.a.id;
    cache->second_id = pair.b.id;
  }
  const PlainWays ways(pair.a, pair.pose_a, pair.b, pair.pose_b);
  ConvexNearest found;
  if (findConvex(pair, ways, cache, options, found)) return resultOf(pair, ways, found, options);
  return distanceBySearch(pair, ways, cache, options);
}

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        DistanceFacts* cache, const DistanceOptions& options) {
  requireRigid(pose_a, pose_b);
  checkOptions(options);
  const PolygonData &first = a.data(), &second = b.data();
  if (inOrder(first, pose_a, second, pose_b))
    return distanceInOrder({first, pose_a, second, pose_b, false}, cache, options);
  return distanceInOrder({second, pose_b, first, pose_a, true}, cache, options);
}

}  // namespace
}  // namespace detail

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        const DistanceOptions& options) {
  return detail::distance(a, pose_a, b, pose_b, nullptr, options);
}

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
                        const DistanceOptions& options) {
  return detail::distance(a, pose_a, b, pose_b, &detail::factsIn(cache).distance, options);
}

}  // namespace tricover
