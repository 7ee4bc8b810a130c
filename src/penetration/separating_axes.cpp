// SPDX-License-Identifier: BSD-3-Clause
#include "penetration/separating_axes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hierarchy/simd.h"
#include "numbers/double_double.h"
#include "numbers/rigidity.h"

namespace tricover::detail {
namespace {

/// How far an edge climbs along a face's inwards normal, taken to the edge's frame, of the product of their lengths. In
/// units of U:
///   the face's edge                   difference 1; products and sum 2 in either coordinate, sqrt2 of it
///   the normal in the other's frame   products and sum 2 in either coordinate
///   the other's edge                  1
///   products and their sum            2
constexpr double kClimbError = 18 * kUnitRoundoff;
static_assert(kClimbError >= kUnitRows * errorOf(1) * (1 + 2 * kRoot2 + 2 * kRoot2 + 1 + 2));

// What a depth is off by, in units of U times the size s. Two corners of one outline are at most 2 sqrt2 s apart, two
// of any at most 3 s.
//   another corner is deeper, by kClimbError of the way there          18 * 2 sqrt2
//   both corners are off by PosedPair::kErrorOfB in either coordinate  5 sqrt2
//   their difference 1U, the edge's direction (1 + 2 sqrt2) U          4.9 * 3
//   cross product, the edge's length, quotient: 10U                    10 * 3
// error() is more than what turnedBack() makes of a corner: 1.5 * 5 + 8 sqrt2.
constexpr double kSumOfDepthErrors = 18 * 2 * kRoot2 + 5 * kRoot2 + 4.9 * 3 + 10 * 3;

bool isLessDeep(const FaceDepth& f, const FaceDepth& g) { return f.depth < g.depth; }

// How deep a corner is behind a face is |u x w| / |u|, u along the face and w from its start to the corner: right to
// (sqrt2 100 + 3 * 32 + 3 * 16) U^2 of the size, as edge_distance.cpp has it, and in units of U of itself:
//   u x w    its last sum            1
//   |u|      u rounded, the root     1 + 2
//   / |u|                            1
// With 1e-14 of the size, that is below 1e-15 of the depth.
static_assert((kRoot2 * 100 + 3 * 32 + 3 * 16) * kUnitRoundoff / 1e-14 + 5 * errorOf(1) / kUnitRoundoff <
              1e-15 / kUnitRoundoff);

/// A power of two that keeps products of the pair's lengths in range.
double scaleFor(const PosedPair& pair) {
  const Vec2 ta = pair.pose_a.translation(), tb = pair.pose_b.translation();
  const double largest =
      std::max({pair.a.extent, pair.b.extent, ta.lpNorm<Eigen::Infinity>(), tb.lpNorm<Eigen::Infinity>()});
  return std::ldexp(1, largest > 0 ? -std::clamp(std::ilogb(largest), -1000, 1000) : 0);
}

/// The gap behind a face, times `scale`, in two-fold numbers from both poses as given. Along a convex outline heights
/// fall and rise once each: the way to the deepest corner leads from corner face.deepest on down, unless that is
/// certain.
SupportGap gapBehind(const PosedPair& pair, double scale, const FaceDepth& face) {
  const ConvexRing own = convexOutlineOf(face.of_a ? pair.a : pair.b).ring(),
                   other = convexOutlineOf(face.of_a ? pair.b : pair.a).ring();
  const Pose& own_pose = face.of_a ? pair.pose_a : pair.pose_b;
  const double *pose = own_pose.data(), *other_pose = (face.of_a ? pair.pose_b : pair.pose_a).data();
  const Double2 v = own.vertex(face.edge), w = own.vertex(own.next(face.edge));
  const double hand = isMirrored(own_pose) ? -1 : 1;
  Double2 along;
  Twofold<Double2> way;
  const auto isDeeper = [&](std::uint32_t j, std::uint32_t i) {
    twofoldWay(other_pose, other.vertex(i), other_pose, other.vertex(j), scale, way);
    return hand * twofoldArea(pose, v * scale, w * scale, way, along) > 0;
  };
  std::uint32_t at = face.deepest, steps = face.certain ? other.size() : 0;
  for (; steps < other.size() && isDeeper(other.next(at), at); ++steps) at = other.next(at);
  for (; steps < other.size() && isDeeper(other.previous(at), at); ++steps) at = other.previous(at);
  const Double2 deepest = other.vertex(at);
  twofoldWay(pair.pose_a.data(), face.of_a ? v : deepest, pair.pose_b.data(), face.of_a ? deepest : v, scale, way);
  const double from_a = face.of_a ? hand : -hand, area = from_a * twofoldArea(pose, v * scale, w * scale, way, along);
  // The normal of a short edge among huge ones may be one of the smallest doubles, and its length hardly known.
  const Vec2 normal = from_a * Vec2(along[1], -along[0]);
  const double length = std::hypot(normal.x(), normal.y()), larger = normal.lpNorm<Eigen::Infinity>();
  const double depth = length > 0 ? std::max(0.0, area / length) : std::numeric_limits<double>::infinity();
  return {{face.of_a, true, face.edge, at, depth}, larger > 0 ? Vec2((normal / larger).normalized()) : Vec2(1, 0)};
}

/// Looks at all faces that may be the least by plain doubles, or at all if these don't tell.
std::vector<SupportGap> leastGaps(const PosedPair& pair, const SeparatingAxes* axes, double scale) {
  std::vector<SupportGap> gaps;
  if (axes != nullptr && axes->verdict() == SeparatingAxes::Meet) {
    for (const FaceDepth& face : *axes) gaps.push_back(gapBehind(pair, scale, face));
    return gaps;
  }
  for (const bool of_a : {true, false}) {
    const std::uint32_t size = convexOutlineOf(of_a ? pair.a : pair.b).ring().size();
    std::uint32_t at = 0;
    for (std::uint32_t k = 0; k < size && size > 1; ++k) {
      gaps.push_back(gapBehind(pair, scale, {of_a, false, k, at, 0}));
      at = gaps.back().deepest;
    }
  }
  return gaps;
}

}  // namespace

/// No edge is longer than two radii.
double AxisSide::climbError(Double2 n) const {
  const Double2 lengths = absolute(n);
  return kClimbError * (lengths[0] + lengths[1]) * (2.001 * polygon.radius) + kTiny;
}

SeparatingAxes::SeparatingAxes(const PosedPair& pair)
    : pair_(pair),
      size_(roundedUp<4>(pair.size())),
      a_(pair.a, pair.pose_a, Double2{}),
      b_(pair.b, pair.pose_b, pair.shift()),
      within_(tie() + 3 * depthError()) {
  static_assert(kDepthError * kError >= kUnitRows * kSumOfDepthErrors * kUnitRoundoff &&
                kError >= kUnitRows * (1.5 * PosedPair::kErrorOfB + kRoot2 * kTurnedBackError));
  if (!(size_ < 0x1p200)) return;  // areas or their squares may overflow
  verdict_ = lookBehindAll();
  if (verdict_ != Meet) return;
  // Too many may be as deep as the least but for rounding.
  if (least_left_out_ < best_.depth + within_) verdict_ = Unsure;
  removeDeep();
}

/// The first face to be asked is one that looks at the other polygon: what the least depth isn't above is soon known.
/// Faces that a corner of the other polygon proves to be deeper than the limit are left out.
SeparatingAxes::Verdict SeparatingAxes::lookBehindAll() {
  // A corner and an area are off by at most this, of edges that are at most 2 sqrt2 sizes long.
  const double doubtful = 12 * error() * size_;
  double most_square = mostSquare();
  std::uint32_t first = edgeTowardsB(), at = 0;
  for (const bool of_a : {true, false}) {
    const PosedRing& own = side(of_a).ring;
    OtherCorners others(own, side(!of_a).ring, at);
    for (std::uint32_t k = first, left = own.ring.size(); left > 0; k = own.ring.next(k), --left) {
      const Double2 start = own.ring.vertex(k), way = own.ring.edge(k), square = way * way;
      // The compared numbers have all of their digits: the limit is no less than 2^-48 of the size, and so is an edge
      // whose area is above what is doubtful.
      const double area = others.largestArea(start, way) - doubtful;
      if (area > 0 && area * area > most_square * (square[0] + square[1])) continue;
      const Verdict verdict = lookBehind(of_a, k, at);
      if (verdict != Meet) return verdict;
      most_square = mostSquare();
      others.put(at);
    }
    first = best_.deepest;
    at = best_.edge;
  }
  return Meet;
}

/// The other one's corners are asked from `at` on, which becomes the deepest. Unsure if that isn't found.
SeparatingAxes::Verdict SeparatingAxes::lookBehind(bool of_a, EdgePosition edge, std::uint32_t& at) {
  const AxisSide &own = side(of_a), &other = side(!of_a);
  const Double2 outwards = own.ring.normal(edge);
  const double square = dot(outwards, outwards);
  // Otherwise its length has lost digits.
  if (!(square > 0x1p-400)) return Unsure;
  const Double2 inwards = other.ring.inFrame(-outwards);
  const ConvexRing& corners = other.ring.ring;
  RingRange range{at, 0};
  if (!corners.supportVertex(inwards, other.climbError(outwards), range)) return Unsure;
  const bool is_certain = range.count == 1;
  at = range.first;
  for (std::uint32_t v = range.first; --range.count > 0;) {
    v = corners.next(v);
    if (dot(inwards, corners.way(at, v)) > 0) at = v;
  }
  const double depth = dot(outwards, own.ring.corner(edge) - other.ring.corner(at)) / std::sqrt(square);
  if (depth < -depthError()) {
    gap_ = roundedDown<1>(-depth - depthError());
    return Apart;
  }
  add({of_a, is_certain, edge, at, depth});
  return Meet;
}

/// An edge of a at the support vertex towards b's S.
std::uint32_t SeparatingAxes::edgeTowardsB() const {
  const ConvexRing& ring = a_.ring.ring;
  const Double2 way = a_.ring.inFrame(pair_.way());
  const std::uint32_t support = ring.supportVertex(way);
  const Double2 to_support = ring.vertex(support) - load2(pair_.a.origin.data());
  return cross(way, to_support) > 0 ? ring.previous(support) : support;
}

/// Deeper faces are of no interest.
double SeparatingAxes::limit() const { return std::min(best_.depth + within_, least_left_out_); }

/// The square of the limit in a polygon's frame. A depth in the world is an area times the determinant by the edge's
/// length there.
double SeparatingAxes::mostSquare() const {
  const double most = std::max(limit(), 0.0) + depthError();
  return most * most * (1 + 8.1 * kLargestDefect);
}

void SeparatingAxes::add(const FaceDepth& face) {
  if (face.depth > limit()) return;
  if (face.depth < best_.depth) best_ = face;
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
  const auto kept = std::remove_if(begin, end, [&](const FaceDepth& f) { return f.depth > best_.depth + within_; });
  count_ = static_cast<std::size_t>(kept - begin);
  if (count_ > 1)
    std::sort(begin, kept,
              [](const FaceDepth& f, const FaceDepth& g) { return f.of_a != g.of_a ? f.of_a : f.edge < g.edge; });
}

SupportGap leastSupportGap(const PosedPair& pair, const SeparatingAxes* axes, double tie) {
  const double scale = scaleFor(pair);
  const std::vector<SupportGap> gaps = leastGaps(pair, axes, scale);
  if (gaps.empty()) return {{true, true, 0, 0, 0}, Vec2(1, 0)};  // two points, which any translation parts
  double least = std::numeric_limits<double>::infinity();
  for (const SupportGap& gap : gaps) least = std::min(least, gap.depth);
  const Vec2 towards_b = pair.pose_b.linear() * (pair.b.origin * scale) -
                         pair.pose_a.linear() * (pair.a.origin * scale) +
                         (pair.pose_b.translation() * scale - pair.pose_a.translation() * scale);
  const auto along = [&](const SupportGap& gap) { return gap.normal.dot(towards_b); };
  const SupportGap* best = nullptr;
  for (const SupportGap& gap : gaps)
    if (gap.depth <= least + tie * scale && (best == nullptr || along(gap) > along(*best))) best = &gap;
  SupportGap result = *best;
  result.depth /= scale;
  return result;
}

}  // namespace tricover::detail
