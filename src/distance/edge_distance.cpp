// SPDX-License-Identifier: BSD-3-Clause
#include "distance/edge_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/rigidity.h"
#include "pair/posed_pair.h"

namespace tricover::detail {
namespace {

/// A distance that is not 0 doesn't become so by rounding.
double atLeastSmallest(double distance) { return std::max(distance, 0x1p-1074); }

}  // namespace

// With M the size, |p|_1, |q|_1 and |t|_1 (of t_b - t_a) sum to at most M. In units of U, rows of R being unit vectors
// but for kUnitRows:
//   R p        products 1, sum 1                         2 |p|_1 in either coordinate
//   R q + t    the same, t itself 1, the sum 1           3 |q|_1 + 2 |t|_1
// so that a distance between the edges is off by sqrt2 3 M in any direction because its ends are, and besideSegment()
// by 13 |u| + 8 d, with |u| <= 2 M, d <= M:
//   4.25 M + 26 M + 8 M = 38.25 M.
constexpr double kDistanceError = 64 * kUnitRoundoff;
static_assert(kDistanceError >=
              kUnitRows * (errorOf(3) * kRoot2 + 2 * errorOf(kBesideOfLength) + errorOf(kBesideOfDistance)));

// Areas u x w and products u . w, where u leads along an edge and w from its start to an end of the other, |u| <= 2 M
// and |w| <= M; in units of U:
//   u          of b: twice 3 |q|_1 + 2 |t|_1, the difference 1 |u|     8 M in either coordinate
//   w          R p and R q + t together, the difference 1              4 M
//   u, w       sqrt2 (8 |w| + 4 |u|)                                   sqrt2 16 M^2
//   products and their sum, 2 |u| |w|                                  4 M^2
// in all below 27 M^2. The square of u is off by 2 sqrt2 8 |u| + 2 |u|^2, 53.3 M^2, and the sum with unsure_ by 5 M^2:
// where an end is beyond it, 86 M^2. foot() errs by less, its u leading along a difference of vertices. So it agrees
// with what is certain here, twice that.
constexpr double kProductError = 256 * kUnitRoundoff;
static_assert(kProductError >=
              2 * kUnitRows * (errorOf(16) * kRoot2 + errorOf(4) + errorOf(32) * kRoot2 + errorOf(8 + 5)));

EdgeDistances::EdgeDistances(const PosedVertices& vertices) : PosedVertices(vertices), scale_(1), inverse_(1) {
  if (!isUnscaled()) {
    // So that M is between 2^-400 and 2^400. An extent that overflowed is below 2^1025.
    scale_ = size_ < 1 ? 0x1p700 : 0x1p-700;
    inverse_ = size_ < 1 ? 0x1p-700 : 0x1p700;
    // Translations may be large where their difference is small.
    const double first = std::min(scale_, 1.0), then = std::max(scale_, 1.0);
    const Double2 from = load2(pose_a.data() + 6) * first, to = load2(pose_b.data() + 6) * first;
    shift_ = (to - from) * then;
    const Double2 away = absolute(shift_);
    const auto scaled = [&](double extent) {
      return extent < std::numeric_limits<double>::infinity() ? extent * scale_ : 0x1p325;
    };
    size_ = roundedUp<4>(scaled(a.extent) + scaled(b.extent) + (away[0] + away[1]));
    for (int i = 0; i < 2; ++i) {
      columns_a_[i] *= scale_;
      columns_b_[i] *= scale_;
    }
  }
  error_ = kDistanceError * size_;
  unsure_ = kProductError * size_ * size_;
}

EdgeDistances::View EdgeDistances::view(EdgePosition i, EdgePosition j) const {
  const EdgePairEnds e = ends(i, j);
  View v;
  const auto put = [&v](const Beside& side, int k) {
    store2(v.square + k, side.square);
    store2(v.part + k, side.part);
    store2(v.area + k, side.area);
    store2(v.along + k, side.along);
    v.length_square[k / 2] = side.length_square;
    return side.square[0] <= side.square[1] ? k : k + 1;
  };
  v.nearest = put(beside(e.a2 - e.a1, e.b1 - e.a1, e.b2 - e.a1), 0);
  if (!b.isPoint()) {
    const int at_b = put(beside(e.b2 - e.b1, e.a1 - e.b1, e.a2 - e.b1), 2);
    if (v.square[at_b] < v.square[v.nearest]) v.nearest = at_b;
  }
  v.distance = std::sqrt(v.square[v.nearest]);
  v.feature = featureOf(v, i, j);
  return v;
}

bool EdgeDistances::meet(EdgePosition i, EdgePosition j) const {
  return edgesMeet(PosedPair(a, pose_a, b, pose_b), i, j);
}

double EdgeDistances::mostSquare(const View& v) const {
  const double most = v.distance + 2 * error_;
  return roundedUp<6>(most * most);  // a root, a product and a sum, twice, and the square
}

std::uint64_t EdgeDistances::featureOf(const View& v, EdgePosition i, EdgePosition j) const {
  const double most = mostSquare(v);
  std::uint64_t feature = 0;
  for (int k = 0; k < combinations(); ++k) {
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

double EdgeDistances::allowed(double distance, const DistanceQuery& options) const {
  const double low = distance - error_, high = distance + error_, margin = options.margin * scale_;
  const double rounded = atLeastSmallest(high * inverse_);
  const bool is_allowed =
      high - margin <= (low - margin) * (1 + options.relative_error) + options.absolute_error * scale_ &&
      (margin == 0 || low > margin) && rounded - options.margin <= options.limit;
  return is_allowed ? rounded : 0;
}

EdgeDistance EdgeDistances::at(const View& v, EdgePosition i, EdgePosition j, const DistanceQuery& options,
                               double least) const {
  const int nearest = v.nearest;
  if (const double rounded = allowed(v.distance, options); rounded > 0)
    return placed(nearest, rounded, v.part[nearest]);
  EdgeDistance best = combination(nearest, v, i, j, least);
  if (v.feature != 0) return best;
  const double most = mostSquare(v);
  for (int k = 0; k < combinations(); ++k) {
    if (k == nearest || v.square[k] > most) continue;
    const EdgeDistance other = combination(k, v, i, j, std::min(least, best.distance));
    if (other.distance < best.distance) best = other;
  }
  return best;
}

bool EdgeDistances::cross(const PosedVertices& vertices, EdgePosition i, EdgePosition j, EdgeDistance& point) {
  const EdgePairEnds e = vertices.ends(i, j);
  const double unsure = kProductError * vertices.size() * vertices.size();
  const Double2 u = e.a2 - e.a1, v = e.b2 - e.b1;
  const auto area = [](Double2 p, Double2 q) { return p[0] * q[1] - p[1] * q[0]; };
  const double b1 = area(u, e.b1 - e.a1), b2 = area(u, e.b2 - e.a1);
  const double a1 = area(v, e.a1 - e.b1), a2 = area(v, e.a2 - e.b1);
  const auto areApart = [unsure](double p, double q) { return std::min(p, q) < -unsure && std::max(p, q) > unsure; };
  if (!areApart(a1, a2) || !areApart(b1, b2)) return false;
  point = {0, a1 / (a1 - a2), b1 / (b1 - b2)};
  return true;
}

// Where an end of one is on the other but for rounding, that is the point. Otherwise they cross, and so clearly that
// the areas tell where.
EdgeDistance EdgeDistances::whereTheyMeet(const View& v) const {
  if (v.distance <= 2 * error_) return placed(v.nearest, 0, v.part[v.nearest]);
  const auto part = [](double from, double to) { return std::clamp(from / (from - to), 0.0, 1.0); };
  return {0, part(v.area[2], v.area[3]), part(v.area[0], v.area[1])};
}

// Let w go from an end of an edge to the point, and u along the edge; M is the size.
//   w: below 100 U^2 M in either coordinate (twofoldWay()).
//   u: from the exact difference in the polygon's frame, by the same count of U |u|: below 32 U^2 |u|.
// The distance d = |u x w| / |u|, where |w| <= 3 M, then errs by
//   256 U^2 M      by w, sqrt2 100 in any direction,
//   3 * 32 U^2 M   by u,
//   3 * 16 U^2 M   by the products in u x w that are rounded or left out,
//   U d            by its last sum,
// which is 400 U^2 M + U d, below 2U d where d >= kLeastShare M. A point taken for one beside an end of the edge rather
// than beyond it, or the converse, is so by an angle below 16U: in the distance the square of that. |w| alone errs by
// as little as that. Where |w| <= r d, r = kSteepest, a u will do whose coordinates err by 3U |u| (difference, product,
// sum):
//   r (sqrt2 3 + 1 + 1) U d   u, w's own rounding and the products, of |u| |w|
//   U d                       their difference
// which is 54.1U d. To either the root of the square of u (u itself 4.3U, two roundings halved, and the root 1U) and
// the quotient (U) add 7.3U: in all below 62U, and kRelativeError is 64U.
static_assert(PosedVertices::kLeastShare * kUnitRoundoff >= (256 + 3 * 32 + 3 * 16) * kUnitRoundoff * kUnitRoundoff);
static_assert(EdgeDistances::kRelativeError >=
              errorOf(1) * (EdgeDistances::kSteepest * (3 * kRoot2 + 2) + 1 + 3 * kRoot2 + 2 + 1));
static_assert(EdgeDistances::kRelativeError >= kExactDistanceError);

/// What a distance below kLeastShare M is off by at most, beside kRelativeError of itself: the 400 U^2 M; and, where
/// the end that is nearest to the point isn't certain, what its foot is off by along the edge, since w u errs by (100
/// sqrt2 + 3 * 32 + 3 * 16) U^2 M |u|. Of M.
constexpr double kTwofoldError = 1024 * kUnitRoundoff * kUnitRoundoff;
static_assert(1024 >= 400 + 100 * kRoot2 + 3 * 32 + 3 * 16);

EdgeDistance EdgeDistances::ofCloseFeatures(const PosedVertices& vertices, const FeaturePair& features,
                                            const Foot& foot, double part, const DistanceQuery& options) {
  const EdgePosition i = features.edge_a, j = features.edge_b;
  const bool are_vertices = features.kind == FeaturePair::kVertices, edge_of_a = features.kind != FeaturePair::kEdgeOfB;
  const int k = edge_of_a ? 0 : 2;
  const EdgePosition edge = edge_of_a ? i : j, vertex = edge_of_a ? j : i;
  const bool allows_error = options.relative_error > 0 || options.absolute_error > 0;
  const double rounded = allows_error ? EdgeDistances(vertices).allowed(foot.distance, options) : 0;
  const double d = rounded > 0    ? rounded
                   : are_vertices ? vertices.twofoldBetween(i, j).distance
                                  : vertices.twofoldDistance(edge_of_a, 0, foot.at_end, edge, vertex, 1, part);
  return d >= kLeastShare * vertices.size() ? placed(k, d, part) : EdgeDistances(vertices).exactCombination(k, i, j);
}

EdgeDistance EdgeDistances::combination(int k, const View& view, EdgePosition i, EdgePosition j, double least) const {
  const bool end_of_b = k < 2;
  const EdgePosition end = k % 2 == 0 ? 0 : 1, edge = end_of_b ? i : j, vertex = end_of_b ? j + end : i + end;
  bool at_end = view.part[k] > 0.5;
  if (isUnscaled()) {
    const Foot foot = end_of_b ? PosedVertices::foot<true>(edge, vertex) : PosedVertices::foot<false>(edge, vertex);
    if (foot.is_plain) return placed(k, foot.distance, foot.part());
    at_end = foot.at_end;
  }
  double part = view.part[k];
  const double d = twofoldDistance(end_of_b, placeOf(view, k), at_end, edge, vertex, scale_, part);
  // Written so that NaN fails.
  if (d >= kLeastShare * size_) return placed(k, atLeastSmallest(d * inverse_), part);
  const bool is_beyond = d * (1 - 2 * kRelativeError) - kTwofoldError * size_ > least * scale_;
  return is_beyond ? EdgeDistance{std::numeric_limits<double>::infinity(), 0, 0} : exactCombination(k, i, j);
}

EdgeDistance EdgeDistances::exactCombination(int k, EdgePosition i, EdgePosition j) const {
  const bool end_of_b = k < 2;
  const std::size_t end = static_cast<std::size_t>(k % 2);
  const PosedPoint p = end_of_b ? PosedPoint{&pose_b, b.path[j + end]} : PosedPoint{&pose_a, a.path[i + end]};
  const PosedPoint v1 = end_of_b ? PosedPoint{&pose_a, a.path[i]} : PosedPoint{&pose_b, b.path[j]};
  const PosedPoint v2 = end_of_b ? PosedPoint{&pose_a, a.path[i + 1]} : PosedPoint{&pose_b, b.path[j + 1]};
  const ExactDistance found = distanceExact(p, v1, v2);
  return placed(k, atLeastSmallest(found.distance), found.along);
}

}  // namespace tricover::detail
