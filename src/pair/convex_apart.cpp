// SPDX-License-Identifier: BSD-3-Clause
#include "pair/convex_apart.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {
namespace {

/// The only ring of a convex polygon, in a's frame.
class Outline {
 public:
  /// `error_`, of n . p for a vertex p and |n| <= 1 + 4U:
  ///   of a   products 1, their sum 1, |n_x x| + |n_y y| being at most (1 + 4U) extent       2.1U extent
  ///   of b   sqrt2 error, of the mapped point; and 2.1U of |x| + |y|, which is at most sqrt2 (b.extent + |t|_1), with
  ///          16U of that in pair.error                                                      1.42 error + 0.19 error
  Outline(const PosedPair& pair, bool of_a)
      : pair_(pair),
        path_((of_a ? pair.a : pair.b).path),
        of_a_(of_a),
        size_(path_.size() - 1),
        error_(of_a ? 4 * kUnitRoundoff * pair.a.extent + kTiny : 2 * pair.error) {}

  std::size_t after(std::size_t k) const { return k + 1 < size_ ? k + 1 : 0; }
  std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : size_ - 1; }

  Vec2 vertex(std::size_t k) const {
    if (of_a_) return path_[k];
    const ApproxPoint p = pair_.fromB(path_[k]);
    return {p.x, p.y};
  }

  /// A lower bound of n . p for all of the polygon's points, starting from the vertex k and leaving there the least
  /// one; NaN where rounding leaves it in doubt.
  ///
  /// Along a convex ring n . p falls to its least and rises to its greatest value, once. So where it is greater at two
  /// vertices than at one between them, its least is between these two.
  double least(const Vec2& n, std::size_t& k) const {
    constexpr int kMostAlike = 8;
    double height = n.dot(vertex(k));
    const auto descend = [&](auto next) {
      for (std::size_t steps = 0; steps < size_; ++steps) {
        const std::size_t other = (this->*next)(k);
        const double h = n.dot(vertex(other));
        if (!(h < height)) return;
        height = h;
        k = other;
      }
    };
    descend(&Outline::after);
    descend(&Outline::before);
    // What isn't certainly greater may be less. The difference of two heights that are off by `error_` each rounds
    // once.
    double lowest = height;
    const auto pass = [&](auto next) {
      std::size_t other = k;
      for (int steps = 0; steps < kMostAlike; ++steps) {
        other = (this->*next)(other);
        const double h = n.dot(vertex(other));
        if (h - height > 2.5 * error_) return true;
        lowest = std::min(lowest, h);
      }
      return false;
    };
    const bool certain = pass(&Outline::after) && pass(&Outline::before);
    return certain ? lowest - error_ : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const PosedPair& pair_;
  const std::vector<Vec2>& path_;
  bool of_a_;
  std::size_t size_;
  double error_;
};

/// Of length 1 to 4U; NaN where v is too small or too large for that.
Vec2 unit(const Vec2& v) {
  const double square = v.squaredNorm();
  const bool fits = square > 0x1p-960 && square <= std::numeric_limits<double>::max();
  return v / (fits ? std::sqrt(square) : std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

std::optional<ConvexApart> findConvexApart(const PosedPair& pair, std::ptrdiff_t near_a, std::ptrdiff_t near_b,
                                           double enough) {
  constexpr int kMostRounds = 8;
  const Outline a(pair, true), b(pair, false);
  const int turn_a = hierarchyOf(pair.a).convex;
  const int turn_b = hierarchyOf(pair.b).convex * (pair.m00 * pair.m11 - pair.m10 * pair.m01 < 0 ? -1 : 1);
  assert(turn_a != 0 && turn_b != 0);
  std::size_t i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(near_a, 0));
  std::size_t j = static_cast<std::size_t>(std::max<std::ptrdiff_t>(near_b, 0));
  if (near_a < 0 || near_b < 0) {
    const Vec2 between = unit(Vec2(pair.center_x, pair.center_y) - pair.a.origin);
    a.least(-between, i);
    b.least(between, j);
  }
  ConvexApart best{0, 0, 0};
  // n leads from a to b.
  const auto attempt = [&](const Vec2& n) {
    std::size_t at_a = i, at_b = j;
    // Sums and the product with 1 - 4U, for the length of n, round once each; n . p of both did in `error_`.
    const double gap = (b.least(n, at_b) + a.least(-n, at_a)) * (1 - 8 * kUnitRoundoff);
    if (gap > best.gap) best = {gap, static_cast<std::ptrdiff_t>(at_a), static_cast<std::ptrdiff_t>(at_b)};
    return best.gap > 0 && best.gap >= enough;
  };
  const auto across = [](const Vec2& v, const Vec2& w, int turn) -> Vec2 {
    return turn * unit({w.y() - v.y(), v.x() - w.x()});
  };
  for (int round = 0; round < kMostRounds; ++round) {
    const double gap = best.gap;
    const Vec2 v = a.vertex(i), w = b.vertex(j);
    if (attempt(across(v, a.vertex(a.after(i)), turn_a)) || attempt(across(a.vertex(a.before(i)), v, turn_a)) ||
        attempt(-across(w, b.vertex(b.after(j)), turn_b)) || attempt(-across(b.vertex(b.before(j)), w, turn_b)) ||
        attempt(unit(w - v)))
      break;
    if (!(best.gap > gap)) break;
    i = static_cast<std::size_t>(best.near_a);
    j = static_cast<std::size_t>(best.near_b);
  }
  return best.gap > 0 ? std::optional(best) : std::nullopt;
}

}  // namespace tricover::detail
