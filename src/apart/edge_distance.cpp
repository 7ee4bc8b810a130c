// SPDX-License-Identifier: BSD-3-Clause
#include "apart/edge_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pair/posed_pair.h"

namespace tricover::detail {
namespace {

/// An unevaluated sum of two doubles, in either coordinate.
struct Twofold {
  Double2 high, low;
};

/// Exact (Knuth).
Twofold twoSum(Double2 p, Double2 q) {
  const Double2 sum = p + q, from_q = sum - p;
  return {sum, (p - (sum - from_q)) + (q - from_q)};
}

/// The high half of each double's digits; what is left is exactly the low half (Dekker, Veltkamp).
Double2 highHalf(Double2 p) {
  const Double2 large = 134217729.0 * p;  // 2^27 + 1
  return large - (large - p);
}

/// Exact, but for underflow of the rest.
Twofold twoProduct(Double2 p, Double2 q) {
  const Double2 product = p * q, ph = highHalf(p), pl = p - ph, qh = highHalf(q), ql = q - qh;
  return {product, ((ph * qh - product) + ph * ql + pl * qh) + pl * ql};
}

Double2 both(double x) { return Double2{x, x}; }

/// Adds a matrix times p to `sum`.
void addProduct(Twofold& sum, const Double2 (&columns)[2], Double2 p) {
  for (int i = 0; i < 2; ++i) {
    const Twofold term = twoProduct(columns[i], both(p[i])), added = twoSum(sum.high, term.high);
    sum.high = added.high;
    sum.low += added.low + term.low;
  }
}

Twofold normalised(const Twofold& sum) { return twoSum(sum.high, sum.low); }

/// A matrix times (q - p).
Twofold mappedDifference(const Double2 (&columns)[2], Double2 p, Double2 q) {
  const Twofold difference = twoSum(q, -p);
  const Twofold first = twoProduct(columns[0], both(difference.high[0]));
  const Twofold second = twoProduct(columns[1], both(difference.high[1])), sum = twoSum(first.high, second.high);
  const Double2 rest = columns[0] * difference.low[0] + columns[1] * difference.low[1];
  return normalised({sum.high, sum.low + (first.low + second.low + rest)});
}

double cross(const Twofold& u, const Twofold& w) {
  const Twofold products = twoProduct(u.high, swapped(w.high));
  const Double2 rest = products.low + (u.high * swapped(w.low) + u.low * swapped(w.high));
  const Twofold difference = twoSum(both(products.high[0]), both(-products.high[1]));
  return difference.high[0] + (difference.low[0] + (rest[0] - rest[1]));
}

double dot(Double2 u, Double2 w) {
  const Double2 products = u * w;
  return products[0] + products[1];
}

/// A distance that is not 0 doesn't become so by rounding.
double atLeastSmallest(double distance) { return std::max(distance, 0x1p-1074); }

Double2 point(const PolygonData& polygon, std::size_t position) { return load2(polygon.path[position].data()); }

}  // namespace

// With M the size, a rounded R p errs by at most 2U |p|_1 in either coordinate, R q + t by 3U (|q|_1 + |t|_1) + U
// |t|_1, a difference of two such by U of what it is: in all below 6U M, so the edges may be out of place by 9U M in
// any direction. For the distance of a point from an edge, as below, doubles then err by at most 16U (|u_a| + |u_b| +
// d), and the edges' lengths and d are at most 2.1 M and 1.1 M together: in all 61U M; 66U M is used.
EdgeDistances::EdgeDistances(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b)
    : a_(a),
      b_(b),
      pose_a_(pose_a),
      pose_b_(pose_b),
      columns_a_{load2(pose_a.data()), load2(pose_a.data() + 3)},
      columns_b_{load2(pose_b.data()), load2(pose_b.data() + 3)},
      scale_(1),
      inverse_(1) {
  Double2 from = load2(pose_a.data() + 6), to = load2(pose_b.data() + 6);
  const Double2 apart = absolute(to - from);
  size_ = (a.extent + b.extent + (apart[0] + apart[1])) * (1 + 8 * kUnitRoundoff);
  if (!(size_ > 0x1p-300 && size_ < 0x1p300)) {
    // So that M is between 2^-400 and 2^400. An extent that overflowed is below 2^1025, hence the factor.
    constexpr double kLargest = std::numeric_limits<double>::max();
    scale_ = size_ < 1 ? 0x1p700 : 0x1p-700;
    inverse_ = size_ < 1 ? 0x1p-700 : 0x1p700;
    from *= scale_;
    to *= scale_;
    const Double2 away = absolute(from) + absolute(to);
    size_ = 4 * (std::min(a.extent, kLargest) * scale_ + std::min(b.extent, kLargest) * scale_ + (away[0] + away[1]));
  }
  const Twofold shift = twoSum(to, -from);
  shift_ = shift.high;
  shift_rest_ = shift.low;
  error_ = 66 * kUnitRoundoff * size_;
  unsure_ = 512 * kUnitRoundoff * size_ * size_;
  for (int i = 0; i < 2; ++i) {
    scaled_a_[i] = columns_a_[i] * scale_;
    scaled_b_[i] = columns_b_[i] * scale_;
  }
}

EdgeDistances::View EdgeDistances::view(std::size_t i, std::size_t j) const {
  const Ends e = ends(i, j);
  View v;
  const auto put = [&v](const Beside& side, int k) {
    store2(v.square + k, side.square);
    store2(v.part + k, side.part);
    store2(v.area + k, side.area);
    store2(v.along + k, side.along);
    v.length_square[k / 2] = side.length_square;
    return side.square[0] <= side.square[1] ? k : k + 1;
  };
  const int at_a = put(beside(e.a2 - e.a1, e.b1 - e.a1, e.b2 - e.a1), 0);
  const int at_b = put(beside(e.b2 - e.b1, e.a1 - e.b1, e.a2 - e.b1), 2);
  v.nearest = v.square[at_a] <= v.square[at_b] ? at_a : at_b;
  v.distance = std::sqrt(v.square[v.nearest]);
  v.feature = featureOf(v, i, j);
  return v;
}

bool EdgeDistances::meet(std::size_t i, std::size_t j) const {
  return edgesMeet(PosedPair(a_, pose_a_, b_, pose_b_), i, j);
}

double EdgeDistances::mostSquare(const View& v) const {
  const double most = v.distance + 2 * error_;
  return most * most * (1 + 16 * kUnitRoundoff);
}

std::uint64_t EdgeDistances::featureOf(const View& v, std::size_t i, std::size_t j) const {
  const double most = mostSquare(v);
  std::uint64_t feature = 0;
  for (int k = 0; k < kCombinations; ++k) {
    if (v.square[k] > most) continue;
    const int place = placeOf(v, k);
    if (place == kUncertain) return 0;
    const std::size_t end = static_cast<std::size_t>(k % 2), other = place > 0 ? 1 : 0;
    const std::uint64_t kind = place != 0 ? 3 : k < 2 ? 1 : 2;
    const std::uint64_t at_a = k < 2 ? i + other : i + end, at_b = k < 2 ? j + end : j + other;
    const std::uint64_t found = kind << 62 | at_a << 31 | at_b;
    if (feature != 0 && feature != found) return 0;
    feature = found;
  }
  return feature;
}

EdgeDistances::Nearest EdgeDistances::at(const View& v, std::size_t i, std::size_t j, double relative_slack,
                                         double absolute_slack) const {
  const int nearest = v.nearest;
  const double low = v.distance - error_, high = v.distance + error_;
  if (high <= low * (1 + relative_slack) + absolute_slack * scale_) {
    const double s = v.part[nearest], end = nearest % 2;
    return {atLeastSmallest(high * inverse_), nearest < 2 ? s : end, nearest < 2 ? end : s};
  }
  Nearest best = combination(nearest, v, i, j);
  if (v.feature != 0) return best;
  const double most = mostSquare(v);
  for (int k = 0; k < kCombinations; ++k) {
    if (k == nearest || v.square[k] > most) continue;
    const Nearest other = combination(k, v, i, j);
    if (other.distance < best.distance) best = other;
  }
  return best;
}

// Where an end of one is on the other but for rounding, that is the point. Otherwise they cross, and so clearly that
// the areas tell where.
EdgeDistances::Nearest EdgeDistances::whereTheyMeet(const View& v) const {
  if (v.distance <= 2 * error_) {
    const double s = v.part[v.nearest], end = v.nearest % 2;
    return {0, v.nearest < 2 ? s : end, v.nearest < 2 ? end : s};
  }
  const auto part = [](double from, double to) { return std::clamp(from / (from - to), 0.0, 1.0); };
  return {0, part(v.area[2], v.area[3]), part(v.area[0], v.area[1])};
}

// Let w go from an end of an edge to the point, and u along the edge; U^2 is the unit here, M the size.
//   w: each of the nine partial sums is at most M and rounds by U M, which is kept in the low parts, whose own ten sums
//   and products round by U of that: below 100 U^2 M in either coordinate; 256 U^2 M in any direction.
//   u: from the exact difference in the polygon's frame: below 32 U^2 |u|.
//   u x w: 32 U^2 |u| |w| by the errors of u, 256 U^2 M |u| by those of w, 16 U^2 |u| |w| by the products that are
//   rounded or left out, and the last sum rounds by U: divided by |u|, with |w| <= 3 M, that is 400 U^2 M + U d.
// So where d >= 2^-44 M (= 512 U M) all of it is below 2U d. Squares, the root and the quotient round by 4U in all, and
// |w| by as little. A point taken for one beside an end of the edge rather than beyond it, or the converse, is so by an
// angle below 16U: in the distance the square of that. Where |w| <= 2 d, a u that is rounded to 4U will do: with three
// roundings of the area that is 14U d. In all below 24U: kRelativeError is 32U.
//
// Vectors go from a to b whatever k is, so that two vertices are found just as far apart from either's edges.
EdgeDistances::Nearest EdgeDistances::combination(int k, const View& view, std::size_t i, std::size_t j) const {
  const bool end_of_b = k < 2;
  const std::size_t end = static_cast<std::size_t>(k % 2);
  const PolygonData& polygon = end_of_b ? a_ : b_;
  const std::size_t edge = end_of_b ? i : j;
  const Double2(&columns)[2] = end_of_b ? columns_a_ : columns_b_;
  /// From the posed vertex of a at one position to that of b at another.
  const auto between = [&](std::size_t at_a, std::size_t at_b) {
    Twofold w{shift_, shift_rest_};
    addProduct(w, columns_b_, point(b_, at_b) * scale_);
    addProduct(w, columns_a_, -(point(a_, at_a) * scale_));
    return normalised(w);
  };
  const auto from = [&](std::size_t v) { return end_of_b ? between(edge + v, j + end) : between(i + end, edge + v); };
  const double where = static_cast<double>(end);
  const auto answer = [&](double d, double part) -> Nearest {
    // Written so that NaN fails.
    if (!(d >= 0x1p-44 * size_)) return exactCombination(k, i, j);
    return {atLeastSmallest(d * inverse_), end_of_b ? part : where, end_of_b ? where : part};
  };
  const auto norm = [](Double2 p) { return std::sqrt(dot(p, p)); };

  const int place = placeOf(view, k);
  const Twofold w = from(view.part[k] > 0.5 ? 1 : 0);
  if (place == -1 || place == 1) return answer(norm(w.high), view.part[k] > 0.5 ? 1 : 0);
  const Double2 v1 = point(polygon, edge) * scale_, v2 = point(polygon, edge + 1) * scale_;
  if (place == 0) {
    const Double2 difference = v2 - v1, u = columns[0] * difference[0] + columns[1] * difference[1];
    const Double2 products = u * swapped(w.high);
    const double d = std::abs(products[0] - products[1]) / norm(u);
    if (dot(w.high, w.high) <= 4 * d * d) return answer(d, view.part[k]);
  }
  const Twofold u = mappedDifference(columns, v1, v2);
  const double square = dot(u.high, u.high);
  if (!(square > 0x1p-900)) return square == 0 ? answer(norm(w.high), 0) : exactCombination(k, i, j);
  const double length = std::sqrt(square);
  if (place == 0) return answer(std::abs(cross(u, w)) / length, view.part[k]);
  const Twofold w1 = from(0), w2 = from(1);
  const double sign = end_of_b ? 1 : -1, along = sign * dot(w1.high, u.high);
  if (along <= 0) return answer(norm(w1.high), 0);
  if (sign * dot(w2.high, u.high) >= 0) return answer(norm(w2.high), 1);
  return answer(std::abs(cross(u, w1)) / length, std::min(along / square, 1.0));
}

EdgeDistances::Nearest EdgeDistances::exactCombination(int k, std::size_t i, std::size_t j) const {
  const bool end_of_b = k < 2;
  const std::size_t end = static_cast<std::size_t>(k % 2);
  const double where = static_cast<double>(end);
  const PosedPoint p = end_of_b ? PosedPoint{&pose_b_, b_.path[j + end]} : PosedPoint{&pose_a_, a_.path[i + end]};
  const PosedPoint v1 = end_of_b ? PosedPoint{&pose_a_, a_.path[i]} : PosedPoint{&pose_b_, b_.path[j]};
  const PosedPoint v2 = end_of_b ? PosedPoint{&pose_a_, a_.path[i + 1]} : PosedPoint{&pose_b_, b_.path[j + 1]};
  const ExactDistance found = distanceExact(p, v1, v2);
  return {atLeastSmallest(found.distance), end_of_b ? found.along : where, end_of_b ? where : found.along};
}

}  // namespace tricover::detail
