// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>

#include "distance/edge_distance.h"
#include "distance/options.h"

namespace tricover::detail {

/// How far a branch and bound for the least distance looks. From what is proven to what is wanted:
///
///   upper   the least distance is at most this: a pair that was shown proves it;
///   limit   whatever is farther apart doesn't count: the caller, or the discs' sizes, say so;
///   reach   no pair beyond it can hold the answer: at most limit, and at most upper less the errors that the caller
///           allows.
///
/// The errors are allowed of what is left beyond the margin; whether anything is left stays exact. While upper is above
/// the caller's limit, none are allowed: they would hide on which side of the limit the truth is.
class SearchReach {
 public:
  explicit SearchReach(const DistanceQuery& options)
      : options_(options),
        most_(EdgeDistances::mostWithin(sumAbove(options.limit, options.margin))),
        limit_(most_),
        reach_(limit_) {}

  double upper() const { return upper_; }
  /// What was found for a pair within the caller's limit is at most this.
  double most() const { return most_; }
  double reach() const { return reach_; }

  void setUpper(double distance) { upper_ = distance, update(); }
  void limitTo(double distance) { limit_ = std::min(limit_, distance), update(); }

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

  const DistanceQuery& options_;
  double upper_ = std::numeric_limits<double>::infinity(), most_, limit_, reach_;
};

/// A pair of edges that was shown to a search.
struct ShownPair {
  double low;  ///< a lower bound of what EdgeDistances::at() says of it
  std::uint32_t i, j;
};

/// The nearest pairs of those shown, the nearest first, each once.
class PairList {
 public:
  static constexpr int kMost = 8;

  int count() const { return count_; }
  const ShownPair& operator[](int k) const { return listed_[k]; }

  /// Lists the pair. Where the list is full, `left_out` becomes the one that finds no room, and the result is true.
  bool list(const ShownPair& pair, ShownPair& left_out) {
    for (int k = 0; k < count_; ++k)
      if (pair.i == listed_[k].i && pair.j == listed_[k].j) return false;
    const bool is_full = count_ == kMost;
    if (is_full) {
      const ShownPair last = listed_[count_ - 1];
      const bool is_near = pair.low < last.low;
      left_out = is_near ? last : pair;
      if (!is_near) return true;
      --count_;
    }
    ShownPair* const end = listed_ + count_++;
    ShownPair* const place =
        std::upper_bound(listed_, end, pair.low, [](double low, const ShownPair& listed) { return low < listed.low; });
    std::move_backward(place, end, end + 1);
    *place = pair;
    return is_full;
  }

 private:
  ShownPair listed_[kMost] = {};
  int count_ = 0;
};

/// Finds the least distance of all pairs of edges that it is shown: no more are evaluated than may hold it, so that
/// this is the same in whatever order they are shown.
class DistanceSearch {
 public:
  DistanceSearch(const EdgeDistances& edges, const DistanceQuery& options)
      : reach_(options), edges_(edges), options_(options) {}

  /// False if they share a point, which ends the search.
  bool show(std::uint32_t i, std::uint32_t j) {
    const EdgeDistances::Bounds bounds = edges_.bounds(i, j);
    if (!bounds.clear && edges_.meet(i, j)) {
      setMeeting(i, j);
      return false;
    }
    count(bounds, {0, i, j});
    return true;
  }

  /// Instead of showing these, which are known to share a point.
  void setMeeting(std::uint32_t i, std::uint32_t j) {
    meets_ = true;
    best_ = edges_.whereTheyMeet(edges_.view(i, j));
    best_pair_ = {0, i, j};
  }

  /// The least distance is at most this: 0 if edges meet.
  double upper() const { return meets_ ? 0 : reach_.upper(); }
  /// No pair beyond it can hold the answer.
  double reach() const { return reach_.reach(); }
  void limitTo(double distance) { reach_.limitTo(distance); }

  /// Evaluates what may be the nearest of all that was shown; the distance stays infinity if that was nothing.
  void finish() {
    if (meets_) return;
    if (reach_.upper() < best_.distance) evaluate(upper_pair_);
    for (int k = 0; k < listed_.count() && listed_[k].low <= best_.distance; ++k) evaluate(listed_[k]);
  }

  bool meets() const { return meets_; }
  const EdgeDistance& best() const { return best_; }
  /// A pair that was shown and proves how near they are at most, unless they meet.
  bool hasUpper() const { return !meets_ && upper_pair_.i != UINT32_MAX; }
  const ShownPair& upperPair() const { return upper_pair_; }
  std::uint32_t edgeA() const { return best_pair_.i; }
  std::uint32_t edgeB() const { return best_pair_.j; }

 private:
  void count(const EdgeDistances::Bounds& bounds, ShownPair pair) {
    assert(!(bounds.low > bounds.high));
    pair.low = bounds.low;
    if (bounds.high < reach_.upper()) {
      reach_.setUpper(bounds.high);
      upper_pair_ = pair;
    }
    if (!(bounds.low <= reach())) return;
    // A list that is full has room for no more: what may be the nearest is evaluated at once.
    ShownPair left_out;
    if (listed_.list(pair, left_out) && left_out.low <= std::min(reach_.upper(), best_.distance)) evaluate(left_out);
  }

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

  SearchReach reach_;
  PairList listed_;
  const EdgeDistances& edges_;
  const DistanceQuery& options_;
  EdgeDistance best_{std::numeric_limits<double>::infinity(), 0, 0};  ///< of what was evaluated
  ShownPair best_pair_{0, UINT32_MAX, UINT32_MAX};
  std::uint64_t best_feature_ = 0;
  ShownPair upper_pair_{0, UINT32_MAX, UINT32_MAX};  ///< which proves SearchReach::upper()
  bool meets_ = false;
};

}  // namespace tricover::detail
