// SPDX-License-Identifier: BSD-3-Clause
#include "contact/separating_axes.h"

#include <algorithm>
#include <cmath>

#include "numbers/rigidity.h"
#include "numbers/segment.h"
#include "pair/facts.h"
#include "polygon/fact_balance.h"

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

/// A part of the smaller one's radius: faces that are deeper by less are kept, for steps of a hundredth of that and
/// more.
constexpr double kLookahead = 1.0 / 32;
constexpr double kLeastSteps = 3;

/// Whether depths behind faces of either are the same in a's frame, in b's and in the world.
bool keepsLengths(const PosedPair& pair) { return pair.defect < 0x1p-46 && pair.scale_defect < 0x1p-46; }

/// Whether facts about this pair, which overlapped the last time, are left alone.
bool isResting(const ContactFacts& facts, const PosedPair& pair) {
  return facts.balance.resting > 0 && facts.first_id == pair.a.id && facts.second_id == pair.b.id;
}

bool isLessDeep(const FaceDepth& f, const FaceDepth& g) { return f.depth < g.depth; }

/// At most how far a point of either has moved against the other since. In a's frame the point q of b's frame has moved
/// by d(q), where d is the difference of both maps. A point of a, at q then, has moved by as much in b's frame, but for
/// what that frame is off by; and q is no farther from b's S than both radii and a's once more, because they overlap.
double motionSince(const ContactFacts& facts, const PosedPair& pair) {
  Change change(pair.b, load2(&pair.m00) - load2(facts.second_in_first),
                load2(&pair.m01) - load2(facts.second_in_first + 2),
                load2(&pair.tx) - load2(facts.second_in_first + 4));
  change.radius += pair.b.radius + 3 * pair.a.radius;
  return change.displacement() * (1 + 1e-12) + 2 * (pair.error + facts.error);
}

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

SeparatingAxes::SeparatingAxes(const PosedPair& pair, ContactFacts* facts)
    : swapped_(pair.b, pair.pose_b, pair.a, pair.pose_a),
      a_(pair, convexOutlineOf(pair.a)),
      b_(swapped_, convexOutlineOf(pair.b)),
      error_(std::max(pair.error, swapped_.error)),
      within_(tie() + 3 * kDepthError * error_) {
  static_assert(kDepthError >= kUnitRows * kSumOfDepthErrors);
  if (!(error_ / kMappingError < 0x1p200)) return;  // areas or their squares may overflow
  if (facts != nullptr && !keepsLengths(pair)) facts = nullptr;
  const bool are_resting = facts != nullptr && isResting(*facts, pair);
  // Those of a pair that overlapped the last time.
  if (facts != nullptr && !are_resting && facts->first_id != 0) {
    const bool known = facts->first_id == pair.a.id && facts->second_id == pair.b.id;
    const double motion = known ? motionSince(*facts, pair) : std::numeric_limits<double>::infinity();
    if (facts->count > 0 && motion < facts->deeper) {
      verdict_ = findLeastKept(*facts);
      if (verdict_ == Meet && facts->deeper - motion > least_depth_ + within_ + 64 * error_) {
        isWorthIt(facts->balance, kQuery / 2);
        removeDeep();
        return;
      }
      least_depth_ = least_left_out_ = std::numeric_limits<double>::infinity();
      count_ = 0;
    }
    facts->count = 0;
    facts->first_id = 0;
    // It pays if it lasts for some more steps like the last one; after a jump another may follow.
    if (kLeastSteps * motion < kLookahead * pair.b.radius)
      lookahead_ = kLookahead * pair.b.radius;
    else if (known)
      isWorthIt(facts->balance, -1);
  }
  verdict_ = findLeast();
  if (are_resting && verdict_ != Meet) facts->first_id = 0;
  if (verdict_ != Meet) return;
  // Of queries that do without them the last one sees where the pair is.
  if (facts != nullptr && (!are_resting || --facts->balance.resting == 0)) keep(*facts, pair);
  removeDeep();
}

SeparatingAxes::Verdict SeparatingAxes::findLeast() {
  ConvexFaces faces;
  const Verdict verdict = findNear(faces) ? lookBehind(faces) : lookBehindAll(edgeTowardsOther(a_));
  // Too many may be as deep as the least but for rounding.
  return verdict == Meet && least_left_out_ < least_depth_ + within_ ? Unsure : verdict;
}

/// Of few faces those that floats don't prove to be too deep; false if there are more, or those of a hull.
///
/// A depth d in a's units is D in the world, where |D - u d| <= u |d| s, u is the unit and s = scale_defect; |d| is at
/// most 6. So the D of faces whose d differ by w / u + 16 s differ by at least
///   u (w / u + 16 s) (1 - s) - 12 u s
/// which is above w if w / u + 16 s < 1.
bool SeparatingAxes::findNear(ConvexFaces& faces) const {
  if (std::max(a_.ring.size(), b_.ring.size()) > SmallPolygon::kMost) return false;
  const PolygonData *corners_a = cornersOf(a_.seen.a), *corners_b = cornersOf(a_.seen.b);
  if (corners_a == nullptr || corners_b == nullptr) return false;
  const PosedPair& pair = a_.seen;
  const UnitPlacement at = unitsOf(pair);
  const double wanted = within_ + lookahead_ + 2 * kDepthError * error_,
               more = wanted * at.inverse_unit + 16 * at.scale_defect;
  if (!(more < 1 && at.map.error < 1 && std::abs(at.map.tx) + std::abs(at.map.ty) < 4)) return false;
  const SmallPolygon *a = topOf(*corners_a).small.get(), *b = topOf(*corners_b).small.get();
  if (a == nullptr || b == nullptr) return false;
  faces = convexFaces(*a, *b, at.map, at.rounding, more);
  return true;
}

SeparatingAxes::Verdict SeparatingAxes::lookBehind(const ConvexFaces& faces) {
  const AxisSide &own = side(faces.of_a), &other = side(!faces.of_a);
  const std::uint32_t edge = own.outline.edgeOf(static_cast<std::uint32_t>(faces.edge)),
                      vertex = other.outline.cornerOf(static_cast<std::uint32_t>(faces.vertex));
  Verdict verdict = faces.near != 0 ? Meet : Apart;
  for (unsigned left = faces.near; left != 0 && verdict == Meet; left &= left - 1) {
    const auto number = static_cast<std::uint32_t>(__builtin_ctz(left));
    const bool of_a = number < SmallPolygon::kMost;
    FaceDepth face;
    Vec2 deepest;
    verdict = lookBehind(of_a, side(of_a).outline.edgeOf(number % SmallPolygon::kMost),
                         of_a == faces.of_a ? vertex : edge, face, deepest);
  }
  return verdict;
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

/// Of the faces in the facts, which were the least.
SeparatingAxes::Verdict SeparatingAxes::findLeastKept(const ContactFacts& facts) {
  for (int f = 0; f < facts.count; ++f) {
    FaceDepth face;
    Vec2 deepest;
    const Verdict verdict = lookBehind(facts.of_first[f], facts.face[f], facts.behind[f], face, deepest);
    if (verdict != Meet) return verdict;
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
  if (!other.ring.foremost(inwards, kClimbError * way.lpNorm<1>() * (2.001 * other.seen.a.radius) + kTiny, range))
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

/// An edge at the corner that is foremost on the way to the other one's S.
std::uint32_t SeparatingAxes::edgeTowardsOther(const AxisSide& side) const {
  const ApproxPoint center = side.seen.center();
  const Vec2 origin = side.seen.a.origin, way(center.x - origin.x(), center.y - origin.y());
  const std::uint32_t foremost = side.ring.foremost(load2(way.data()));
  return cross(way, side.corner(foremost) - origin) > 0 ? side.ring.previous(foremost) : foremost;
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
double SeparatingAxes::limit() const { return std::min(least_depth_ + within_ + lookahead_, least_left_out_); }

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

/// Where they are, and if it may be of use the least faces, and how deep all others are at least.
void SeparatingAxes::keep(ContactFacts& facts, const PosedPair& pair) {
  facts.first_id = pair.a.id;
  facts.second_id = pair.b.id;
  std::copy(&pair.m00, &pair.m00 + 6, facts.second_in_first);
  facts.error = pair.error;
  if (!(lookahead_ > 0)) return;
  const auto begin = least_.begin(), end = begin + static_cast<std::ptrdiff_t>(count_);
  std::sort(begin, end, isLessDeep);
  double deeper = limit();
  for (auto face = begin; face != end; ++face) {
    if (face->depth > limit() || facts.count == ContactFacts::kMost) {
      deeper = std::min(deeper, face->depth);
      break;
    }
    facts.of_first[facts.count] = face->of_a;
    facts.face[facts.count] = face->edge;
    facts.behind[facts.count++] = face->deepest;
  }
  facts.deeper = deeper * (1 - 1e-12) - kDepthError * error_;
}

}  // namespace tricover::detail
