// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <utility>

#include "distance/distance_query.h"
#include "distance/edge_distance.h"

namespace tricover::detail {

/// A pair of edges that was shown to a search.
struct ShownPair {
  EdgePosition i = kNoEdge, j = kNoEdge;
  double low = 0;  ///< a lower bound of what EdgeDistances::at() says of it
};

/// Finds the least distance of all pairs of edges that it is shown: no more are evaluated than may hold it, so that
/// this is the same in whatever order they are shown. From what is proven to what is wanted:
///
///   upper   the least distance is at most this: a pair that was shown proves it;
///   limit   whatever is farther apart doesn't count: the caller, or the discs' sizes, say so;
///   reach   no pair beyond it can hold the answer: at most limit, and at most upper less the errors that the caller
///           allows.
///
/// The errors are allowed of what is left beyond the margin; whether anything is left stays exact. While upper is above
/// the caller's limit, none are allowed: they would hide on which side of the limit the truth is.
class DistanceSearch {
 public:
  DistanceSearch(const EdgeDistances& edges, const DistanceQuery& options)
      : edges_(edges), options_(options), most_(mostWithin(options)), limit_(most_), reach_(most_) {}

  /// What EdgeDistances::at() says of a pair within the caller's limit is at most this.
  static double mostWithin(const DistanceQuery& options) {
    return EdgeDistances::mostWithin(sumAbove(options.limit, options.margin));
  }

  /// False if they share a point, which ends the search.
  bool show(std::uint32_t i, std::uint32_t j) {
    const EdgeDistances::Bounds bounds = edges_.bounds(i, j);
    if (!bounds.clear && edges_.meet(i, j)) {
      setMeeting(i, j);
      return false;
    }
    assert(!(bounds.low > bounds.high));
    const ShownPair pair{i, j, bounds.low};
    if (bounds.high < upper_) {
      upper_ = bounds.high;
      nearest_ = pair;
      update();
    }
    if (bounds.low <= reach_) keep(pair);
    return true;
  }

  /// Instead of showing these, which are known to share a point.
  void setMeeting(std::uint32_t i, std::uint32_t j) {
    meets_ = true;
    upper_ = 0;
    best_ = edges_.whereTheyMeet(edges_.view(i, j));
    best_pair_ = nearest_ = {i, j, 0};
  }

  double upper() const { return upper_; }
  double reach() const { return reach_; }
  void limitTo(double distance) {
    limit_ = std::min(limit_, distance);
    update();
  }

  /// Evaluates what may be the nearest of all that was shown; the distance stays infinity if that was nothing.
  void finish() {
    if (meets_) return;
    if (upper_ < best_.distance) evaluate(nearest_);
    std::sort(kept_, kept_ + count_, isNearer);
    for (int k = 0; k < count_ && kept_[k].low <= best_.distance; ++k) evaluate(kept_[k]);
  }

  bool meets() const { return meets_; }
  /// The pair that meets or proves upper(), if there is one.
  const ShownPair* nearest() const { return nearest_.i != kNoEdge ? &nearest_ : nullptr; }

  // The answer.
  const EdgeDistance& best() const { return best_; }
  std::uint32_t edgeA() const { return best_pair_.i; }
  std::uint32_t edgeB() const { return best_pair_.j; }

 private:
  void update() {
    const double beyond = (upper_ - options_.margin - options_.absolute_error) / (1 + options_.relative_error);
    const double less_errors = std::min(upper_, sumAbove(std::max(beyond, 0.0), options_.margin));
    reach_ = upper_ <= most_ ? std::min(limit_, less_errors) : limit_;
  }
  /// Without a margin nothing rounds. With one, a difference, a quotient and a sum before have, too.
  static double sumAbove(double length, double margin) {
    return margin == 0 ? length : roundedUp<3 + 1>(length + margin);
  }

  /// Most pairs turn out to be too far apart, and are never evaluated. Where there is no room, the farthest one is.
  void keep(ShownPair pair) {
    const auto isFar = [this](const ShownPair& kept) { return kept.low > upper_; };
    if (count_ == kMostKept) count_ = static_cast<int>(std::remove_if(kept_, kept_ + count_, isFar) - kept_);
    if (count_ < kMostKept) {
      kept_[count_++] = pair;
      return;
    }
    ShownPair& farthest = *std::max_element(kept_, kept_ + count_, isNearer);
    if (pair.low < farthest.low) std::swap(pair, farthest);
    if (pair.low <= std::min(upper_, best_.distance)) evaluate(pair);
  }
  static bool isNearer(const ShownPair& p, const ShownPair& q) { return p.low < q.low; }

  void evaluate(const ShownPair& pair) {
    if (pair.i == best_pair_.i && pair.j == best_pair_.j) return;
    const EdgeDistances::View view = edges_.view(pair.i, pair.j);
    if (view.feature != 0 && view.feature == best_feature_) return;
    const EdgeDistance found = edges_.at(view, pair.i, pair.j, options_, best_.distance);
    if (found.distance > best_.distance) return;
    best_ = found;
    best_pair_ = pair;
    best_feature_ = view.feature;
  }

  static constexpr int kMostKept = 8;

  const EdgeDistances& edges_;
  const DistanceQuery& options_;
  const double most_;
  double upper_ = std::numeric_limits<double>::infinity(), limit_, reach_;
  ShownPair nearest_;  ///< proves upper_
  ShownPair kept_[kMostKept];
  int count_ = 0;
  EdgeDistance best_{std::numeric_limits<double>::infinity(), 0, 0};  ///< of what was evaluated
  ShownPair best_pair_;
  std::uint64_t best_feature_ = 0;
  bool meets_ = false;
};

}  // namespace tricover::detail
