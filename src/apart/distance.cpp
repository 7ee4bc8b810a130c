// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apart/edge_distance.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/containment.h"
#include "pair/discs.h"
#include "pair/edge_pairs.h"
#include "pair/facts.h"
#include "pair/kernel_order.h"

namespace tricover {
namespace detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two polygons and their poses, in the kernel's own order.
struct Pair {
  const PolygonData& a;
  const Pose& pose_a;
  const PolygonData& b;
  const Pose& pose_b;
};

/// The nearest pairs of edges of all that it is shown: no more are evaluated than may hold the least distance, so that
/// this is the same whatever they are shown in.
class Search {
 public:
  Search(const Pair& pair, const DistanceOptions& options)
      : edges_(pair.a, pair.pose_a, pair.b, pair.pose_b),
        options_(options),
        limit_(options.limit),
        worth_(limit_),
        reach_(limit_) {}

  /// False if they share a point, which ends the search.
  bool show(std::uint32_t i, std::uint32_t j) {
    const EdgeDistances::Bounds bounds = edges_.bounds(i, j);
    if (!bounds.clear && edges_.meet(i, j)) {
      meets_ = true;
      best_ = edges_.whereTheyMeet(edges_.view(i, j));
      best_pair_ = {0, i, j, -1};
      return false;
    }
    count(bounds, {0, i, j, -1});
    return true;
  }

  /// The same for a pair that is likely to be the nearest and doesn't meet.
  void showNear(std::uint32_t i, std::uint32_t j) {
    const EdgeDistances::View& view = views_[view_count_] = edges_.view(i, j);
    const int index = view_count_;
    if (view_count_ < DistanceCache::kMost) ++view_count_;
    count(edges_.bounds(view), {0, i, j, index < DistanceCache::kMost ? index : -1});
  }

  /// A length beyond which no pair holds the answer.
  double worth() const { return worth_; }
  /// A length beyond which no pair is listed.
  double reach() const { return reach_; }

  /// Pairs that are farther apart don't count.
  void limitTo(double distance) {
    limit_ = std::min(limit_, distance);
    updateReach();
  }

  /// Lists pairs that are farther away by this, too.
  void lookAhead(double length) {
    lookahead_ = length;
    updateReach();
  }

  bool meets() const { return meets_; }

  /// Finds the least distance of all that was shown, infinity if that was nothing.
  void finish() {
    if (meets_) return;
    if (upper_ < best_.distance) evaluate(upper_pair_);
    for (int k = 0; k < count_ && listed_[k].low <= best_.distance; ++k) evaluate(listed_[k]);
  }

  const EdgeDistances::Nearest& nearest() const { return best_; }
  std::uint32_t edgeA() const { return best_pair_.i; }
  std::uint32_t edgeB() const { return best_pair_.j; }

  /// What was found, as a fact about all pairs of edges: those that weren't shown are beyond reach.
  void keep(DistanceCache& cache) const {
    if (meets_) {
      cache.count = 1;
      cache.first_edge[0] = edgeA();
      cache.second_edge[0] = edgeB();
      cache.apart[0] = cache.apart[1] = 0;
      return;
    }
    cache.count = 0;
    for (int k = 0; k < count_ && listed_[k].low < reach_; ++k, ++cache.count) {
      put(cache, k, listed_[k].low);
    }
    cache.apart[cache.count] = std::min({unlisted_, reach_, std::numeric_limits<double>::max()});
  }

  /// After the first `shown` pairs of the cache's fact were shown and found to suffice, moves the fact to these poses,
  /// so that the next query needs fewer: worth it if some weren't among the nearest.
  bool refresh(DistanceCache& cache, const Remainder& remainder, int shown) const {
    if (meets_ || count_ == 0 || count_ != shown || listed_[count_ - 1].low <= upper_) return false;
    for (int k = shown; k <= cache.count; ++k) cache.apart[k] = remainder.of(cache.apart[k]);
    for (int k = 0; k < shown; ++k) put(cache, k, std::min(listed_[k].low, cache.apart[shown]));
    return true;
  }

 private:
  struct Listed {
    double low;
    std::uint32_t i, j;
    int view;  ///< of views_; -1 if there is none
  };

  void count(const EdgeDistances::Bounds& bounds, Listed pair) {
    pair.low = bounds.low;
    if (bounds.high < upper_) {
      upper_ = bounds.high;
      upper_pair_ = pair;
      updateReach();
    }
    if (bounds.low <= reach_) list(pair);
  }

  void updateReach() {
    worth_ = std::min(limit_, std::max((upper_ - options_.absolute_error) / (1 + options_.relative_error), 0.0));
    reach_ = worth_ + lookahead_;
    // The last one that is listed might as well not be.
    if (count_ == DistanceCache::kMost) reach_ = std::max(worth_, std::min(reach_, listed_[count_ - 1].low));
  }

  void put(DistanceCache& cache, int k, double low) const {
    cache.first_edge[k] = listed_[k].i;
    cache.second_edge[k] = listed_[k].j;
    cache.apart[k] = std::max(low, 0.0);
  }

  void list(const Listed& pair) {
    for (int k = 0; k < count_; ++k)
      if (pair.i == listed_[k].i && pair.j == listed_[k].j) return;
    if (count_ == DistanceCache::kMost) {
      const Listed last = listed_[count_ - 1];
      const bool is_near = pair.low < last.low;
      leaveOut(is_near ? last : pair);
      if (!is_near) return;
      --count_;
    }
    int k = count_++;
    for (; k > 0 && listed_[k - 1].low > pair.low; --k) listed_[k] = listed_[k - 1];
    listed_[k] = pair;
    if (count_ == DistanceCache::kMost) updateReach();
  }

  /// A list that is full has room for no more: what may be the nearest is evaluated at once.
  void leaveOut(const Listed& pair) {
    unlisted_ = std::min(unlisted_, pair.low);
    if (pair.low <= std::min(upper_, best_.distance)) evaluate(pair);
  }

  void evaluate(const Listed& pair) {
    if (pair.i == best_pair_.i && pair.j == best_pair_.j) return;
    if (pair.view >= 0)
      evaluate(pair, views_[pair.view]);
    else
      evaluate(pair, edges_.view(pair.i, pair.j));
  }

  void evaluate(const Listed& pair, const EdgeDistances::View& view) {
    if (view.feature != 0 && view.feature == best_feature_) return;
    const EdgeDistances::Nearest found =
        edges_.at(view, pair.i, pair.j, options_.relative_error, options_.absolute_error);
    if (found.distance > best_.distance) return;
    best_ = found;
    best_pair_ = pair;
    best_feature_ = view.feature;
  }

  const EdgeDistances edges_;
  const DistanceOptions& options_;
  double upper_ = kInfinity;  ///< the least distance is at most this, that of upper_pair_
  double limit_, worth_, reach_, lookahead_ = 0;
  double unlisted_ = kInfinity;  ///< shown, but nearer than this only if listed
  Listed listed_[DistanceCache::kMost];
  int count_ = 0;
  bool meets_ = false;
  EdgeDistances::Nearest best_{kInfinity, 0, 0};
  Listed upper_pair_, best_pair_{0, UINT32_MAX, UINT32_MAX, -1};
  EdgeDistances::View views_[DistanceCache::kMost + 1];  ///< the last one isn't kept
  int view_count_ = 0;
  std::uint64_t best_feature_ = 0;
};

/// Rounded as a posed vertex is. What could overflow on the way is made smaller first.
Vec2 worldPoint(const PolygonData& polygon, const Pose& pose, std::size_t edge, double along) {
  const bool large = !(polygon.extent < 0x1p1000 && pose.translation().lpNorm<Eigen::Infinity>() < 0x1p1000);
  const double scale = large ? 0x1p-4 : 1;
  const Vec2 v = polygon.path[edge] * scale, w = polygon.path[edge + 1] * scale;
  const Vec2 local = along == 0 ? v : along == 1 ? w : Vec2(v + along * (w - v));
  return (pose.linear() * local + pose.translation() * scale) / scale;
}

DistanceResult farResult() {
  const Vec2 none = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  return {kInfinity, none, none, -1, -1};
}

DistanceResult resultOf(const Pair& pair, const Search& search) {
  const EdgeDistances::Nearest& nearest = search.nearest();
  const std::size_t i = search.edgeA(), j = search.edgeB();
  const Vec2 point_a = worldPoint(pair.a, pair.pose_a, i, nearest.along_a);
  return {nearest.distance, point_a, search.meets() ? point_a : worldPoint(pair.b, pair.pose_b, j, nearest.along_b),
          static_cast<std::ptrdiff_t>(pair.a.edgeNumber(i)), static_cast<std::ptrdiff_t>(pair.b.edgeNumber(j))};
}

DistanceResult contained(const Pair& pair, const Outcome& outcome) {
  const bool in_b = outcome.edge_a >= 0;
  const auto edge = static_cast<std::size_t>(in_b ? outcome.edge_a : outcome.edge_b);
  const Vec2 point = in_b ? worldPoint(pair.a, pair.pose_a, edge, 0) : worldPoint(pair.b, pair.pose_b, edge, 0);
  const auto number = static_cast<std::ptrdiff_t>((in_b ? pair.a : pair.b).edgeNumber(edge));
  return {0, point, point, in_b ? number : -1, in_b ? -1 : number};
}

/// How many of the pairs that the fact lists had to be shown for the least distance, or a meeting, to be among them
/// after a motion; -1 if it isn't certain to be.
int recall(const DistanceCache& cache, const Remainder& remainder, Search& search) {
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

Remainder remainderOf(const DistanceCache& cache, const Pair& pair, bool& both_moved) {
  const bool a_moved = !sameAs(cache.first_pose, pair.pose_a), b_moved = !sameAs(cache.second_pose, pair.pose_b);
  both_moved = a_moved && b_moved;
  const double motion = (a_moved ? Change(pair.a, cache.first_pose, pair.pose_a).displacement() : 0) +
                        (b_moved ? Change(pair.b, cache.second_pose, pair.pose_b).displacement() : 0);
  return {roundedDown<Remainder::kRoundings>(1), motion};
}

/// Shows the search what it must see. False if two edges meet.
bool descend(const PosedPair& pair, Search& search) {
  // The discs' farthest points are no nearer than any of the polygons.
  const double dx = std::abs(pair.center_x - pair.a.origin.x()), dy = std::abs(pair.center_y - pair.a.origin.y());
  constexpr int kSums = 1 + 4;  // one difference, four sums; and the scale's sum and product
  search.limitTo(
      roundedUp<kSums + 2>((dx + dy + 2 * pair.error + pair.a.radius + pair.radiusB()) * (1 + pair.scale_defect)));
  const auto limit = [&] { return pair.reach(EdgeDistances::above(search.reach())); };
  forNearPairs(
      pair, limit(),
      [&](double, std::size_t i, std::size_t j) {
        return search.show(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)) ? limit() : -1;
      },
      [&](double length) {
        search.limitTo(roundedUp<2>(length * (1 + pair.scale_defect)));
        return limit();
      });
  return !search.meets();
}

DistanceResult distanceInOrder(const Pair& pair, DistanceCache* cache, const DistanceOptions& options) {
  Search search(pair, options);
  const auto answer = [&] {
    search.finish();
    return search.nearest().distance <= options.limit ? resultOf(pair, search) : farResult();
  };
  const auto storePoses = [&] {
    store(cache->first_pose, pair.pose_a);
    store(cache->second_pose, pair.pose_b);
    cache->uses = 0;
  };
  if (cache != nullptr && cache->first_id == pair.a.id && cache->second_id == pair.b.id) {
    bool both_moved;
    Remainder remainder = remainderOf(*cache, pair, both_moved);
    search.lookAhead(kInfinity);
    int shown = recall(*cache, remainder, search);
    if (shown < 0 && both_moved) {
      remainder =
          remainderOfRelativeMotion(cache->first_pose, cache->second_pose, pair.a, pair.pose_a, pair.b, pair.pose_b);
      shown = recall(*cache, remainder, search);
    }
    if (shown >= 0) {
      ++cache->uses;
      if (!search.meets() && !(remainder.of(cache->apart[0]) > 0)) {
        const Outcome outcome = findContainment(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b));
        if (outcome.collides) return contained(pair, outcome);
      }
      if (search.refresh(*cache, remainder, shown)) storePoses();
      return answer();
    }
    const double ahead = kStepsAhead * remainder.motion / (cache->uses + 1.0);
    search.lookAhead(remainder.motion <= kCoherentPart * pair.b.radius ? std::min(ahead, pair.b.radius) : 0);
  } else if (cache != nullptr) {
    *cache = DistanceCache();
    cache->first_id = pair.a.id;
    cache->second_id = pair.b.id;
  }
  const PosedPair posed(pair.a, pair.pose_a, pair.b, pair.pose_b);
  if (descend(posed, search)) {
    const Outcome outcome = findContainment(posed);
    if (outcome.collides) {
      if (cache != nullptr) cache->count = 0, cache->apart[0] = 0;
      return contained(pair, outcome);
    }
  }
  if (cache != nullptr) {
    storePoses();
    search.keep(*cache);
  }
  return answer();
}

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        DistanceCache* cache, const DistanceOptions& options) {
  requireRigid(pose_a, "pose_a");
  requireRigid(pose_b, "pose_b");
  requireNotNegative(options.relative_error, "relative_error");
  requireNotNegative(options.absolute_error, "absolute_error");
  requireNotNegative(options.limit, "limit");
  return inKernelOrder(
      a.data(), pose_a, b.data(), pose_b,
      [&](const auto&... operands) { return distanceInOrder({operands...}, cache, options); },
      [](DistanceResult& result) {
        std::swap(result.point_a, result.point_b);
        std::swap(result.edge_a, result.edge_b);
      });
}

}  // namespace
}  // namespace detail

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        const DistanceOptions& options) {
  return detail::distance(a, pose_a, b, pose_b, nullptr, options);
}

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        DistanceCache& cache, const DistanceOptions& options) {
  return detail::distance(a, pose_a, b, pose_b, &cache, options);
}

}  // namespace tricover
