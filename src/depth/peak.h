// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tricover::detail {

/// An affine function over a simplex of up to three corners, or a place in it: a number for each corner.
using OfCorners = std::array<double, 3>;

inline double valueAt(const OfCorners& function, const OfCorners& place) {
  return function[0] * place[0] + function[1] * place[1] + function[2] * place[2];
}

/// The largest value that the least of some affine functions has over a simplex, and its place by barycentric
/// coordinates: a linear program, which takes the functions one by one. A function that is lower at the peak so far is
/// the least one at the next peak: that is a corner of what is left of the simplex where all others are higher.
///
/// A convex function is nowhere above the affine one with its values at the corners. Hence the peak is an upper bound
/// of the least of convex functions, such as distances from edges.
class Peak {
 public:
  static constexpr std::size_t kMost = 6;  ///< functions

  explicit Peak(std::size_t corners) : corners_(corners) {}

  void add(const OfCorners& function) {
    if (count_ == 0 || valueAt(function, place) < value) {
      Corners left{{}, 0};
      for (std::size_t i = 0; i < corners_; ++i) left.add({i == 0 ? 1.0 : 0, i == 1 ? 1.0 : 0, i == 2 ? 1.0 : 0});
      for (std::size_t k = 0; k < count_; ++k) left = clipped(left, functions_[k], function);
      double highest = -std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < left.count; ++i)
        if (const double at = valueAt(function, left.all[i]); at > highest) highest = at, place = left.all[i];
      // Rounding may leave nothing: the value so far is an upper bound, too.
      if (left.count > 0) value = std::min(value, highest);
    }
    functions_[count_++] = function;
  }

  double value = std::numeric_limits<double>::infinity();
  OfCorners place{};

 private:
  /// Of a convex polygon in the simplex.
  struct Corners {
    void add(const OfCorners& corner) { all[count++] = corner; }

    std::array<OfCorners, 3 + kMost + 1> all;
    std::size_t count;
  };
  /// The part of a convex polygon where one function is not below the other, but for rounding. Two functions that are
  /// the same leave all of it.
  static Corners clipped(const Corners& polygon, const OfCorners& above, const OfCorners& below) {
    double most = 0;
    for (std::size_t i = 0; i < above.size(); ++i) most = std::max({most, std::abs(above[i]), std::abs(below[i])});
    const double rounding = 0x1p-50 * most;
    const auto room = [&](const OfCorners& p) { return valueAt(above, p) - valueAt(below, p) + rounding; };
    Corners kept{{}, 0};
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const OfCorners &p = polygon.all[i], &q = polygon.all[i + 1 < polygon.count ? i + 1 : 0];
      const double at_p = room(p), at_q = room(q);
      if (at_p >= 0) kept.add(p);
      if ((at_p < 0) == (at_q < 0)) continue;
      const double t = at_p / (at_p - at_q);
      kept.add({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])});
    }
    return kept;
  }

  const std::size_t corners_;
  std::array<OfCorners, kMost> functions_;
  std::size_t count_ = 0;
};

}  // namespace tricover::detail
