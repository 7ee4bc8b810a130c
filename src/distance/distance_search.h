// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <utility>

#include "distance/edge_distance.h"
#include "distance/options.h"
#include "distance/pruned_boxes.h"
#include "pair/facts.h"

namespace tricover::detail {

/// How far a branch and bound for the least distance looks. From what is proven to what is wanted:
///
///   upper   the least distance is at most this: a pair that was shown proves it;
///   limit   whatever is farther apart doesn't count: the caller, or the discs' sizes, say so;
///   worth   no pair beyond it can hold the answer: at most limit, and at most upper less the errors that the caller
///           allows;
///   reach   no pair beyond it is listed: worth, and the lookahead more. While the list is full, the last pair in it.
///
/// The errors are allowed of what is left beyond the margin; whether anything is left stays exact. While upper is above
/// the caller's limit, none are allowed: they would hide on which side of the limit the truth is.
class SearchReach {
 public:
  explicit SearchReach(const DistanceQuery& options)
      : options_(options),
        most_(EdgeDistances::mostWithin(sumAbove(options.limit, options.margin))),
        limit_(most_),
        worth_(limit_),
        reach_(limit_) {}

  double upper() const { return upper_; }
  /// What was found for a pair within the caller's limit is at most this.
  double most() const { return most_; }
  double worth() const { return worth_; }
  double reach() const { return reach_; }
  bool looksAhead() const { return lookahead_ > 0; }

  void setUpper(double distance) { upper_ = distance; }
  void limitTo(double distance) { limit_ = std::min(limit_, distance); }
  void lookAhead(double length) { lookahead_ = length; }

  /// After any of these; `last_listed` is infinity while the list has room.
  void update(double last_listed) {
    const double beyond = (upper_ - options_.margin - options_.absolute_error) / (1 + options_.relative_error);
    const double less_errors = std::min(upper_, sumAbove(std::max(beyond, 0.0), options_.margin));
    worth_ = upper_ <= most_ ? std::min(limit_, less_errors) : limit_;
    reach_ = std::max(worth_, std::min(worth_ + lookahead_, last_listed));
  }

 private:
  /// Without a margin nothing rounds. With one, a difference, a quotient and a sum before have, too.
  static double sumAbove(double length, double margin) {
    return margin == 0 ? length : roundedUp<3 + 1>(length + margin);
  }

  const DistanceQuery& options_;
  double upper_ = std::numeric_limits<double>::infinity(), most_, limit_, worth_, reach_, lookahead_ = 0;
};

/// A pair of edges that was shown to a search.
struct ShownPair {
  double low;  ///< a lower bound of what EdgeDistances::at() says of it
  std::uint32_t i, j;
  int view;  ///< which of the search's views is its; -1 if none is
};

/// The nearest pairs of those shown, the nearest first, each once.
class PairList {
 public:
  int count() const { return count_; }
  const ShownPair& operator[](int k) const { return listed_[k]; }
  bool isFull() const { return count_ == DistanceFacts::kMost; }
  double lastWhenFull() const { return isFull() ? listed_[count_ - 1].low : std::numeric_limits<double>::infinity(); }

  /// Lists the pair. Where the list is full, `left_out` becomes the one that finds no room, and the result is true.
  bool list(const ShownPair& pair, ShownPair& left_out) {
    for (int k = 0; k < count_; ++k)
      if (pair.i == listed_[k].i && pair.j == listed_[k].j) return false;
    const bool is_full = isFull();
    if (is_full) {
      const ShownPair last = listed_[count_ - 1];
      const bool is_near = pair.low < last.low;
      left_out = is_near ? last : pair;
      if (!is_near) return true;
      --count_;
    }
    int k = count_++;
    for (; k > 0 && listed_[k - 1].low > pair.low; --k) listed_[k] = listed_[k - 1];
    listed_[k] = pair;
    return is_full;
  }

 private:
  ShownPair listed_[DistanceFacts::kMost];
  int count_ = 0;
};

/// Evaluates pairs, and keeps the nearest.
class BestPair {
 public:
  BestPair(const EdgeDistances& edges_, const DistanceQuery& options) : edges(edges_), options_(options) {}

  /// The doubles' view of a pair that is likely to be evaluated; its index, -1 if there is no room to keep it.
  const EdgeDistances::View& view(std::uint32_t i, std::uint32_t j, int& index) {
    const EdgeDistances::View& view = views_[view_count_] = edges.view(i, j);
    index = view_count_ < DistanceFacts::kMost ? view_count_++ : -1;
    return view;
  }

  void evaluate(const ShownPair& pair) {
    if (pair.i == pair_.i && pair.j == pair_.j) return;
    if (pair.view >= 0)
      evaluate(pair, views_[pair.view]);
    else
      evaluate(pair, edges.view(pair.i, pair.j));
  }

  void setMeeting(std::uint32_t i, std::uint32_t j) {
    best_ = edges.whereTheyMeet(edges.view(i, j));
    pair_ = {0, i, j, -1};
  }

  const EdgeDistance& best() const { return best_; }
  const ShownPair& pair() const { return pair_; }

  const EdgeDistances& edges;

 private:
  void evaluate(const ShownPair& pair, const EdgeDistances::View& view) {
    if (view.feature != 0 && view.feature == feature_) return;
    const EdgeDistance found = edges.at(view, pair.i, pair.j, options_, best_.distance);
    if (found.distance > best_.distance) return;
    best_ = found;
    pair_ = pair;
    feature_ = view.feature;
  }

  const DistanceQuery& options_;
  EdgeDistance best_{std::numeric_limits<double>::infinity(), 0, 0};
  ShownPair pair_{0, UINT32_MAX, UINT32_MAX, -1};
  EdgeDistances::View views_[DistanceFacts::kMost + 1];  ///< the last one isn't kept
  int view_count_ = 0;
  std::uint64_t feature_ = 0;
};

/// Finds the least distance of all pairs of edges that it is shown: no more are evaluated than may hold it, so that
/// this is the same in whatever order they are shown.
class DistanceSearch {
 public:
  DistanceSearch(const EdgeDistances& edges, const DistanceQuery& options)
      : reach_(options), best_pair_(edges, options) {}

  /// False if they share a point, which ends the search.
  bool show(std::uint32_t i, std::uint32_t j) {
    const EdgeDistances::Bounds bounds = best_pair_.edges.bounds(i, j);
    if (!bounds.clear && best_pair_.edges.meet(i, j)) {
      setMeeting(i, j);
      return false;
    }
    count(bounds, {0, i, j, -1});
    return true;
  }

  /// The same for a pair that is likely to be the nearest and doesn't meet.
  void showNear(std::uint32_t i, std::uint32_t j) {
    int index;
    const EdgeDistances::View& view = best_pair_.view(i, j, index);
    count(best_pair_.edges.bounds(view), {0, i, j, index});
  }

  /// Instead of showing these, which are known to share a point.
  void setMeeting(std::uint32_t i, std::uint32_t j) {
    meets_ = true;
    best_pair_.setMeeting(i, j);
  }

  double worth() const { return reach_.worth(); }
  double reach() const { return reach_.reach(); }
  bool looksAhead() const { return reach_.looksAhead(); }

  void limitTo(double distance) {
    reach_.limitTo(distance);
    update();
  }

  void lookAhead(double length) {
    reach_.lookAhead(length);
    update();
  }

  /// Evaluates what may be the nearest of all that was shown; the distance stays infinity if that was nothing.
  void finish() {
    if (meets_) return;
    if (reach_.upper() < best().distance) best_pair_.evaluate(upper_pair_);
    for (int k = 0; k < listed_.count() && listed_[k].low <= best().distance; ++k) best_pair_.evaluate(listed_[k]);
  }

  /// Prunes what the nearest pair so far tells of others, which won't be shown any more. False if it tells nothing
  /// new.
  bool prune(PrunedBoxes& pruned) {
    if (upper_pair_.i == pruned_.i && upper_pair_.j == pruned_.j) return false;
    pruned_ = upper_pair_;
    PrunedBoxes next(best_pair_.edges, pruned_.i, pruned_.j);
    if (!next.any()) return false;
    pruned = std::move(next);
    unlisted_ = std::min(unlisted_, pruned_.low);
    return true;
  }

  bool meets() const { return meets_; }
  const EdgeDistance& best() const { return best_pair_.best(); }
  /// A pair that was shown and proves how near they are at most, unless they meet.
  bool hasUpper() const { return !meets_ && upper_pair_.i != UINT32_MAX; }
  const ShownPair& upperPair() const { return upper_pair_; }
  std::uint32_t edgeA() const { return best_pair_.pair().i; }
  std::uint32_t edgeB() const { return best_pair_.pair().j; }

  /// Keeps what was found as a fact about all pairs of edges: those that weren't shown are beyond reach.
  void keep(DistanceFacts& cache) const {
    if (meets_) {
      cache.count = 1;
      cache.first_edge[0] = edgeA();
      cache.second_edge[0] = edgeB();
      cache.apart[0] = cache.apart[1] = 0;
      return;
    }
    cache.count = 0;
    // Pruned pairs aren't listed, though they may be as near as the nearest.
    const double known = std::min(unlisted_, reach());
    for (int k = 0; k < listed_.count() && listed_[k].low < known; ++k, ++cache.count) put(cache, k, listed_[k].low);
    // What is left out may have a bound below 0.
    cache.apart[cache.count] = std::max(std::min(known, std::numeric_limits<double>::max()), 0.0);
    assert(std::is_sorted(cache.apart, cache.apart + cache.count + 1) && cache.apart[0] >= 0);
  }

  /// After the first `shown` pairs of the cache's fact were shown and found to suffice, moves the fact to these poses,
  /// so that the next query needs fewer: worth it if some weren't among the nearest.
  bool refresh(DistanceFacts& cache, const Remainder& remainder, int shown) const {
    const int count = listed_.count();
    if (meets_ || count == 0 || count != shown || listed_[count - 1].low <= reach_.upper()) return false;
    for (int k = shown; k <= cache.count; ++k) cache.apart[k] = remainder.of(cache.apart[k]);
    for (int k = 0; k < shown; ++k) put(cache, k, std::min(listed_[k].low, cache.apart[shown]));
    assert(std::is_sorted(cache.apart, cache.apart + cache.count + 1));
    return true;
  }

 private:
  void update() { reach_.update(listed_.lastWhenFull()); }

  void count(const EdgeDistances::Bounds& bounds, ShownPair pair) {
    assert(!(bounds.low > bounds.high));
    pair.low = bounds.low;
    if (bounds.high < reach_.upper()) {
      reach_.setUpper(bounds.high);
      upper_pair_ = pair;
      update();
    }
    if (!(bounds.low <= reach())) return;
    const double last = listed_.lastWhenFull();
    ShownPair left_out;
    if (listed_.list(pair, left_out)) leaveOut(left_out);
    if (listed_.lastWhenFull() != last) update();
  }

  /// A list that is full has room for no more: what may be the nearest is evaluated at once.
  void leaveOut(const ShownPair& pair) {
    unlisted_ = std::min(unlisted_, pair.low);
    if (pair.low <= std::min(reach_.upper(), best().distance)) best_pair_.evaluate(pair);
  }

  void put(DistanceFacts& cache, int k, double low) const {
    cache.first_edge[k] = listed_[k].i;
    cache.second_edge[k] = listed_[k].j;
    cache.apart[k] = std::max(low, 0.0);
  }

  SearchReach reach_;
  PairList listed_;
  BestPair best_pair_;
  double unlisted_ = std::numeric_limits<double>::infinity();  ///< shown, but nearer than this only if listed
  ShownPair upper_pair_{0, UINT32_MAX, UINT32_MAX, -1};        ///< which proves SearchReach::upper()
  ShownPair pruned_ = upper_pair_;                             ///< which pruned others last
  bool meets_ = false;
};

}  // namespace tricover::detail
