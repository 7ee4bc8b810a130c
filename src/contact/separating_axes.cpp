// SPDX-License-Identifier: BSD-3-Clause
#include "contact/separating_axes.h"

#include <algorithm>
#include <cmath>

#include "numbers/rigidity.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// How far an edge climbs along a face's inwards normal, taken to the edge's frame, of the product of their lengths. In
/// units of U:
///   the face's way, the edge                1 each
///   the map of the normal                   Gram::kMatrixError, products and their sum in either coordinate 2 sqrt2
///   products and their sum                  2
constexpr double kClimbError = 18 * kUnitRoundoff;
static_assert(kClimbError >= kUnitRows * (Gram::kMatrixError + errorOf(4) + 2 * kRoot2 * errorOf(1)));

// What a depth is off by, in units of the error e, which is at least 16U of |x| + |y| of any corner and of the shift
// between the frames. So an outline is at most 4 sqrt2 / 16 e / U long, and corners are less than 3.5 / 16 e / U apart:
//   another corner is deeper, by kClimbError of the way there        6.4
//   the corner that is taken for the deepest is off                  sqrt2
//   its way from the edge 2U, the edge 1U                            0.7
//   cross product, determinant, the edge's length, quotient: 13U     2.9
constexpr double kSumOfDepthErrors = 6.4 + kRoot2 + 0.7 + 2.9;

bool isLessDeep(const FaceDepth& f, const FaceDepth& g) { return f.depth < g.depth; }

}  // namespace

AxisSide::AxisSide(const PosedPair& seen_, const ConvexOutline& outline_)
    : seen(seen_),
      outline(outline_),
      ring(outline.points.data(), outline.corners.size(), 1),
      linear(seen.pose_a.linear()),
      mirrors(linear.determinant() < 0),
      determinant(std::abs(linear.determinant())) {}

Vec2 AxisSide::normalOf(std::uint32_t edge) const {
  const Vec2 way = inWorld(corner(edge + 1) - corner(edge));
  return (mirrors ? Vec2(-way.y(), way.x()) : Vec2(way.y(), -way.x())).normalized();
}

SeparatingAxes::SeparatingAxes(const PosedPair& pair)
    : swapped_(pair.b, pair.pose_b, pair.a, pair.pose_a),
      a_(pair, convexOutlineOf(pair.a)),
      b_(swapped_, convexOutlineOf(pair.b)),
      error_(std::max(pair.error, swapped_.error)),
      within_(tie() + 3 * kDepthError * error_) {
  static_assert(kDepthError >= kUnitRows * kSumOfDepthErrors);
  if (!(error_ / kMappingError < 0x1p200)) return;  // areas or their squares may overflow
  verdict_ = lookBehindAll(edgeTowardsOther(a_));
  if (verdict_ != Meet) return;
  // Too many may be as deep as the least but for rounding.
  if (least_left_out_ < least_depth_ + within_) verdict_ = Unsure;
  removeDeep();
}

/// The first face to be asked is one that looks at the other polygon: what the least depth isn't above is soon known.
SeparatingAxes::Verdict SeparatingAxes::lookBehindAll(std::uint32_t first_of_a) {
  std::uint32_t first = first_of_a, at = 0;
  for (const bool of_a : {true, false}) {
    const AxisSide& own = side(of_a);
    FaceDepth face, best{};
    best.depth = std::numeric_limits<double>::infinity();
    Vec2 deepest;
    for (std::uint32_t k = first, left = own.ring.size(); left > 0; skipDeep(own, deepest, k, left)) {
      const Verdict verdict = lookBehind(of_a, k, at, face, deepest);
      if (verdict != Meet) return verdict;
      if (face.depth < best.depth) best = face;
      at = face.deepest;
    }
    first = best.deepest;
    at = best.edge;
  }
  return Meet;
}

/// The other one's corners are asked from `at` on. Unsure if the deepest isn't found.
SeparatingAxes::Verdict SeparatingAxes::lookBehind(bool of_a, std::uint32_t edge, std::uint32_t at, FaceDepth& face,
                                                   Vec2& deepest) {
  const AxisSide &own = side(of_a), &other = side(!of_a);
  const Vec2 start = own.corner(edge), way = own.corner(edge + 1) - start;
  const double square = own.inWorld(way).squaredNorm();
  // Otherwise its length has lost digits.
  if (!(square > 0x1p-400)) return Unsure;
  const PosedPair& seen = own.seen;
  const Double2 inwards{seen.m10 * way.x() - seen.m00 * way.y(), seen.m11 * way.x() - seen.m01 * way.y()};
  // No edge is longer than two radii.
  RingRange range{at, 0};
  if (!other.ring.supportVertex(inwards, kClimbError * way.lpNorm<1>() * (2.001 * other.seen.a.radius) + kTiny, range))
    return Unsure;
  face.certain = range.count == 1;
  face.deepest = range.first;
  for (std::uint32_t v = range.first; --range.count > 0;) {
    v = other.ring.next(v);
    if (dot(inwards, other.ring.way(face.deepest, v)) > 0) face.deepest = v;
  }
  deepest = own.fromOther(other.corner(face.deepest));
  const double area = cross(way, deepest - start);
  face.of_a = of_a;
  face.edge = edge;
  face.depth = own.determinant * area / std::sqrt(square);
  if (face.depth < -kDepthError * error_) return Apart;
  add(face);
  return Meet;
}

/// An edge at the support vertex towards the other one's S.
std::uint32_t SeparatingAxes::edgeTowardsOther(const AxisSide& side) const {
  const ApproxPoint center = side.seen.center();
  const Vec2 origin = side.seen.a.origin, way(center.x - origin.x(), center.y - origin.y());
  const std::uint32_t support = side.ring.supportVertex(load2(way.data()));
  return cross(way, side.corner(support) - origin) > 0 ? side.ring.previous(support) : support;
}

/// Of the faces that are left, on to the next one that point p of the other polygon doesn't prove to be too deep.
void SeparatingAxes::skipDeep(const AxisSide& side, const Vec2& p, std::uint32_t& edge, std::uint32_t& left) const {
  // What the point and an area are off by, of edges that are at most 2 sqrt2 sizes long; and a depth in the world is an
  // area times the determinant by the edge's length there.
  const double doubtful = 12 * error_ * (error_ / kMappingError), most = std::max(limit(), 0.0) + kDepthError * error_,
               most_square = roundedUp<8>(most * most * (1 + 8 * side.seen.scale_defect));
  const Double2 point = load2(p.data());
  while (--left > 0) {
    edge = side.ring.next(edge);
    const Double2 way = side.ring.edge(edge), square = way * way;
    const double area = cross(way, point - side.ring.vertex(edge)) - doubtful;
    // What is compared has all of its digits: `most` is no less than 2^-48 of the size, and so is an edge whose area
    // is above what is doubtful.
    if (!(area > 0 && area * area > most_square * (square[0] + square[1]))) return;
  }
}

/// Deeper faces are of no interest.
double SeparatingAxes::limit() const { return std::min(least_depth_ + within_, least_left_out_); }

void SeparatingAxes::add(const FaceDepth& face) {
  if (face.depth > limit()) return;
  least_depth_ = std::min(face.depth, least_depth_);
  if (count_ < least_.size()) {
    least_[count_++] = face;
    return;
  }
  const auto deepest = std::max_element(least_.begin(), least_.end(), isLessDeep);
  least_left_out_ = std::max(face.depth, deepest->depth);
  if (face.depth < deepest->depth) *deepest = face;
}

/// Those that are deeper than the least by more than rounding; the others in an order of their own.
void SeparatingAxes::removeDeep() {
  if (count_ == 1) return;
  const auto begin = least_.begin(), end = begin + static_cast<std::ptrdiff_t>(count_);
  const auto kept = std::remove_if(begin, end, [&](const FaceDepth& f) { return f.depth > least_depth_ + within_; });
  count_ = static_cast<std::size_t>(kept - begin);
  if (count_ > 1)
    std::sort(begin, kept,
              [](const FaceDepth& f, const FaceDepth& g) { return f.of_a != g.of_a ? f.of_a : f.edge < g.edge; });
}

}  // namespace tricover::detail
