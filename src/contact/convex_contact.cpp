// SPDX-License-Identifier: BSD-3-Clause
// Rotating hulls give the faces' depths. From the best face and the vertex deepest behind it both boundaries are
// followed, to either side, to where they cross.
//
// Why there is nothing else: two pairs of edges are proven to cross properly, one at either end of a chain of vertices
// of one polygon that are proven to be inside the other, and of a chain of the other one's likewise. The two chains
// with their ends are in both regions and on their own one's boundary, so on that of the overlap, which is convex; they
// meet at their ends alone. They are a closed curve on a closed curve, so all of it.
#include "contact/convex_contact.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "contact/convex_outline.h"
#include "contact/convex_ring.h"
#include "contact/frame_of_a.h"
#include "contact/part_middle.h"
#include "pair/facts.h"
#include "pair/world_frame.h"

namespace tricover::detail {
namespace {

/// How an area, the product of two differences of vertices, errs: in either coordinate a vertex is at most r =
/// (1 + 1e-5) size, and errs by at most e = error, which is at least 16U size; a difference d is at most 2 r, and errs
/// by 2 e and its own U d.
///   the differences' roundings       two in each of two products     4U (2 r)^2
///   the products', their difference                                  4U (2 r)^2
///   what the vertices are off by     two for each of four factors    8 e 2 r
/// which is 32U r^2 + 16 e r and terms of second order: 18 e r with all of them.
template <typename Frame>
double doubtfulArea(const Frame& frame) {
  return 20 * frame.error() * frame.size();
}
static_assert(WorldFrame::kPointError >= 16 * kUnitRoundoff && kMappingError >= 16 * kUnitRoundoff);

/// A face and the vertex of the other polygon that is deepest behind it.
struct Face {
  bool of_a = true;
  std::size_t edge = 0, deepest = 0;
  double square = std::numeric_limits<double>::infinity();  ///< of the depth
};

/// Where two edges cross: an edge of the face's polygon and one of the other.
struct Meeting {
  std::size_t own, other;
  std::size_t own_passed, other_passed;  ///< vertices on the way there
};

/// In one of the frames that are there for it, counter-clockwise there; with all vertices kept, for all faces, or not.
template <typename Frame, bool kept>
class ConvexPair {
 public:
  using Ring = ConvexRing<Frame, kept>;

  ConvexPair(const PosedPair& pair, int turn_a, int turn_b)
      : pair_(pair),
        frame_(pair),
        doubtful_(doubtfulArea(frame_)),
        a_(frame_, pair.a, true, turn_a),
        b_(frame_, pair.b, false, turn_b) {}

  /// Keeps in `cache`, unless it is null, which faces were the best.
  ConvexContact byAllFaces(ContactFacts* cache, double lookahead) {
    const bool keeps = cache != nullptr;
    boundLeast(keeps ? lookahead : 0);
    const bool finds = lookBehind(true, 0, a_.size(), 0, keeps) && lookBehind(false, 0, b_.size(), 0, keeps);
    if (!finds) return {is_apart_ ? ConvexContact::Apart : ConvexContact::Unsure, {}};
    if (cache != nullptr) keepFaces(*cache, lookahead);
    return byBestFace();
  }

  /// Of the faces in the cache, which were the best before points moved by up to `motion` against the other polygon.
  /// Overlap only where byAllFaces() says the same.
  ConvexContact byKeptFaces(const ContactFacts& cache, double motion) {
    for (int f = 0; f < cache.count; ++f) {
      const Ring &ring = cache.of_first[f] ? a_ : b_, &body = cache.of_first[f] ? b_ : a_;
      const std::size_t k = ring.position(cache.face[f]);
      if (!lookBehind(cache.of_first[f], k, k + 1, body.position(cache.behind[f]), false)) return {};
    }
    return cache.deeper - motion > least_ + 64 * frame_.error() ? byBestFace() : ConvexContact{};
  }

 private:
  static constexpr std::size_t kMostBest = 8;

  ConvexContact byBestFace() const {
    // Less may be a touch.
    if (!(least_ > 64 * frame_.error())) return {};
    const Face face = bestFace();
    const Ring &own = face.of_a ? a_ : b_, &other = face.of_a ? b_ : a_;
    Meeting left, right;
    if (!findMeeting(own, other, face, true, left) || !findMeeting(own, other, face, false, right)) return {};
    const std::size_t own_passed = left.own_passed + right.own_passed,
                      other_passed = left.other_passed + right.other_passed + 1;
    if (own_passed >= own.size() || other_passed >= other.size()) return {};
    PointList<36> part(own_passed + other_passed + 2);
    part.add(pointOf(face, left));
    if (!addChain(other, other.after(left.other), other_passed, own, part)) return {};
    part.add(pointOf(face, right));
    if (!addChain(own, own.after(right.own), own_passed, other, part)) return {};
    const Vec2 up = normalOf(face);
    const Vec2 middle = partMiddle(part, part, up, 4 * frame_.error()).middle;
    return {ConvexContact::Overlap, contactOf(face, up, middle)};
  }

  /// Behind faces k to end - 1 of one of them, seen from vertex `at` on. False if one of them parts the regions, or
  /// what is deepest isn't found.
  bool lookBehind(bool of_a, std::size_t k, std::size_t end, std::size_t at, bool keeps) {
    const Ring &ring = of_a ? a_ : b_, &body = of_a ? b_ : a_;
    const bool bounded = most_ < std::numeric_limits<double>::infinity();
    const std::size_t facing = of_a ? facing_b_ : facing_a_;
    for (; k < end; ++k) {
      if (bounded && (k = nextNear(ring, k, end, body.vertex(facing), body.end(facing))) == end) break;
      const Vec2 way = ring.edge(k);
      Face face{of_a, k, at, 0};
      if (!climbToDeepest(way, body, at, face.deepest)) return false;
      const double area = cross(way, body.vertex(face.deepest) - ring.vertex(k));
      if (area < -doubtful_) {
        is_apart_ = isBeyond(ring, k, body);
        return false;
      }
      const double positive = std::max(area, 0.0), square = way.squaredNorm();
      const bool is_best = !(positive * positive > limit_ * square);
      if (!is_best && !keeps) continue;
      face.square = positive * positive / square;
      if (is_best && !addBest(face)) return false;
      if (keeps) addNearest(face, std::max(area - 4 * doubtful_, 0.0));
    }
    return true;
  }

  /// The least depth is at most that behind either of the edges that look at the other polygon. Where that isn't found,
  /// nothing is known. Faces that are `lookahead` deeper are of no interest.
  void boundLeast(double lookahead) {
    const Vec2 center_a = frame_.fromA(pair_.a.origin), center_b = frame_.fromB(pair_.b.origin);
    facing_a_ = edgeTowards(a_, center_a, center_b - center_a);
    facing_b_ = edgeTowards(b_, center_b, center_a - center_b);
    double square = std::numeric_limits<double>::infinity();
    for (const bool of_a : {true, false}) {
      const Ring &ring = of_a ? a_ : b_, &body = of_a ? b_ : a_;
      const std::size_t k = of_a ? facing_a_ : facing_b_;
      std::size_t at = of_a ? facing_b_ : facing_a_, deepest = at;
      if (!climbToDeepest(ring.edge(k), body, at, deepest)) return;
      // Another vertex may be as deep but for rounding.
      const double area = std::max(ring.leftOf(k, body.vertex(deepest)) + 2 * doubtful_, 0.0);
      square = std::min(square, area * area / ring.edge(k).squaredNorm());
    }
    const double reach = std::sqrt(square) + 4 * frame_.error() + lookahead;
    most_ = roundedUp<4>(reach * reach);
  }

  /// Where a way from a point inside leaves; any edge if it doesn't.
  static std::size_t edgeTowards(const Ring& ring, const Vec2& from, const Vec2& way) {
    std::size_t k = 0;
    bool left = cross(way, ring.vertex(0) - from) > 0;
    for (; k + 1 < ring.size(); ++k) {
      const bool right = !left;
      left = cross(way, ring.end(k) - from) > 0;
      if (right && left) break;
    }
    return k;
  }

  /// The next face behind which points p and q of the other polygon don't prove that it is deeper than any of interest.
  /// Doubt there is twice, about these points and about the area that lookBehind would find, and as much later.
  std::size_t nextNear(const Ring& ring, std::size_t k, std::size_t end, const Vec2& p, const Vec2& q) const {
    const double doubtful = 4 * doubtful_, most = most_;
    for (; k < end; ++k) {
      const Vec2 start = ring.vertex(k), way = ring.edge(k);
      const double area = std::max(cross(way, p - start), cross(way, q - start)) - doubtful, square = way.squaredNorm();
      // What is compared has all of its digits: `most` is no less than 2^-94 of that square.
      if (!(area > 0 && square > 0x1p-400 && area * area > most * square)) break;
    }
    return k;
  }

  /// From vertex `at` on.
  bool climbToDeepest(const Vec2& way, const Ring& body, std::size_t& at, std::size_t& deepest) const {
    double climb = cross(way, body.edge(at));
    std::size_t steps = climb > doubtful_ ? body.size() : 0;
    // What leads there is proven to climb.
    const bool climbs = steps > 0 || cross(way, body.edge(body.before(at))) > doubtful_;
    for (; climb > doubtful_; climb = cross(way, body.edge(at))) {
      if (steps-- == 0) return false;
      at = body.after(at);
    }
    deepest = at;
    return (climbs && climb < -doubtful_) || findDeepest(way, body, at, deepest);
  }

  /// Of a convex polygon's vertices all that may be the deepest lie between an edge that certainly leads deeper and the
  /// next that certainly doesn't.
  bool findDeepest(const Vec2& way, const Ring& body, std::size_t& at, std::size_t& deepest) const {
    std::size_t steps = 2 * body.size();
    for (std::size_t v = body.before(at); !(cross(way, body.edge(v)) > doubtful_); v = body.before(v)) {
      if (steps-- == 0) return false;
      at = v;
    }
    deepest = at;
    for (std::size_t v = at; !(cross(way, body.edge(v)) < -doubtful_);) {
      if (steps-- == 0) return false;
      v = body.after(v);
      if (cross(way, body.vertex(v) - body.vertex(deepest)) > 0) deepest = v;
    }
    return true;
  }

  bool isBeyond(const Ring& ring, std::size_t k, const Ring& body) const {
    for (std::size_t v = 0; v < body.size(); ++v)
      if (!(ring.leftOf(k, body.vertex(v)) < -doubtful_)) return false;
    return true;
  }

  /// By an area that is less by what rounding makes of it now and later.
  void addNearest(Face face, double area) {
    face.square = area * area / (face.of_a ? a_ : b_).edge(face.edge).squaredNorm();
    for (Face& other : nearest_)
      if (face.square < other.square) std::swap(face, other);
  }

  /// Those that are less than `lookahead` deeper than the least, and how deep the next one is.
  void keepFaces(ContactFacts& cache, double lookahead) const {
    const auto depthOf = [](const Face& face) { return std::sqrt(face.square); };
    const double enough = depthOf(nearest_[0]) + lookahead;
    int count = 1;
    while (count < ContactFacts::kMost && depthOf(nearest_[static_cast<std::size_t>(count)]) < enough) ++count;
    std::array<Face, ContactFacts::kMost + 1> faces = nearest_;
    std::sort(faces.begin(), faces.begin() + count,
              [](const Face& f, const Face& g) { return f.of_a != g.of_a ? f.of_a : f.edge < g.edge; });
    for (int f = 0; f < count; ++f) {
      const Face& face = faces[static_cast<std::size_t>(f)];
      const Ring &ring = face.of_a ? a_ : b_, &body = face.of_a ? b_ : a_;
      cache.of_first[f] = face.of_a;
      cache.face[f] = static_cast<std::uint32_t>(ring.position(face.edge));
      cache.behind[f] = static_cast<std::uint32_t>(body.position(face.deepest));
    }
    cache.count = count;
    // What wasn't looked behind is deeper than the root of most_.
    const double next = std::min(depthOf(faces[static_cast<std::size_t>(count)]), std::sqrt(most_));
    cache.deeper = next * (1 - 1e-12) - 64 * frame_.error();
  }

  /// The best are those that aren't deeper than the least one by more than rounding.
  bool addBest(const Face& face) {
    if (face.square < least_ * least_) {
      least_ = std::sqrt(face.square);
      const double reach = least_ + 4 * frame_.error();
      limit_ = reach * reach;
      const auto end = std::remove_if(best_.begin(), best_.begin() + best_count_,
                                      [this](const Face& f) { return f.square > limit_; });
      best_count_ = end - best_.begin();
    }
    if (best_count_ == static_cast<std::ptrdiff_t>(best_.size())) return false;
    best_[static_cast<std::size_t>(best_count_++)] = face;
    return face.square >= 0;
  }

  /// Outwards.
  Vec2 normalOf(const Face& face) const {
    const Vec2 way = (face.of_a ? a_ : b_).edge(face.edge);
    return Vec2(way.y(), -way.x()).normalized();
  }

  /// Of those that are equally deep but for rounding, the one that leads b's origin away from a's.
  Face bestFace() const {
    const auto towardsB = [this](const Face& face) {
      return (face.of_a ? -1 : 1) * normalOf(face).dot(frame_.originOfA());
    };
    Face best = best_[0];
    for (std::ptrdiff_t k = 1; k < best_count_; ++k)
      if (towardsB(best_[static_cast<std::size_t>(k)]) > towardsB(best)) best = best_[static_cast<std::size_t>(k)];
    return best;
  }

  /// From the face on counter-clockwise and from the vertex deepest behind it back, or (not forward) the other way
  /// round: the edges that cross first. False where that isn't certain.
  bool findMeeting(const Ring& own, const Ring& other, const Face& face, bool forward, Meeting& meeting) const {
    std::size_t i = face.edge, j = forward ? other.before(face.deepest) : face.deepest;
    std::size_t own_passed = 0, other_passed = 0;
    while (own_passed + other_passed < own.size() + other.size()) {
      const Vec2 own_end = forward ? own.end(i) : own.vertex(i), other_end = forward ? other.vertex(j) : other.end(j);
      const double own_in = other.leftOf(j, own_end), other_in = own.leftOf(i, other_end);
      if (own_in < 0 && other_in < 0) {
        meeting = {i, j, own_passed, other_passed};
        const Vec2 own_start = forward ? own.vertex(i) : own.end(i),
                   other_start = forward ? other.end(j) : other.vertex(j);
        return own_in < -doubtful_ && other_in < -doubtful_ && other.leftOf(j, own_start) > doubtful_ &&
               own.leftOf(i, other_start) > doubtful_;
      }
      // One that leaves the other one's edge has to wait for it; or else the one that is ahead.
      const bool own_waits = own_in < 0 || (other_in >= 0 && isAhead(own, i, own_end, other, j, other_end, forward));
      if (own_waits) {
        j = forward ? other.before(j) : other.after(j);
        ++other_passed;
      } else {
        i = forward ? own.after(i) : own.before(i);
        ++own_passed;
      }
    }
    return false;
  }

  static bool isAhead(const Ring& own, std::size_t i, const Vec2& own_end, const Ring& other, std::size_t j,
                      const Vec2& other_end, bool forward) {
    const Vec2 way = own.edge(i) - other.edge(j);
    const double ahead = way.dot(own_end - other_end);
    return forward ? ahead > 0 : ahead < 0;
  }

  /// On b's edge.
  Vec2 pointOf(const Face& face, const Meeting& meeting) const {
    const std::size_t i = face.of_a ? meeting.own : meeting.other, j = face.of_a ? meeting.other : meeting.own;
    const double from = a_.leftOf(i, b_.vertex(j)), to = a_.leftOf(i, b_.end(j));
    const double t = from / (from - to);
    return t < 0.5 ? Vec2(b_.vertex(j) + t * b_.edge(j)) : Vec2(b_.end(j) + (t - 1) * b_.edge(j));
  }

  /// Vertices in a row; false unless they are inside the other for certain.
  template <typename Points>
  bool addChain(const Ring& ring, std::size_t first, std::size_t count, const Ring& other, Points& points) const {
    for (std::size_t v = first; count > 0; --count, v = ring.after(v)) {
      if (!other.holds(ring.vertex(v), doubtful_)) return false;
      points.add(ring.vertex(v));
    }
    return true;
  }

  Contact contactOf(const Face& face, const Vec2& up, const Vec2& point) const {
    const Ring &own = face.of_a ? a_ : b_, &other = face.of_a ? b_ : a_;
    const auto own_edge = static_cast<std::ptrdiff_t>(own.position(face.edge));
    // Of the vertex' edges the one that is more across the normal.
    const std::size_t leaving = other.leaving(face.deepest), arriving = other.arriving(face.deepest);
    const auto slope = [&](std::size_t edge) {
      const double along = up.dot(other.edge(edge));
      return along * along / other.edge(edge).squaredNorm();
    };
    const auto other_edge =
        static_cast<std::ptrdiff_t>(other.position(slope(arriving) < slope(leaving) ? arriving : leaving));
    const double depth = own.leftOf(face.edge, other.vertex(face.deepest)) / own.edge(face.edge).norm();
    assert(depth > 0 && std::abs(up.norm() - 1) < 0x1p-40);
    // One ring: positions are numbers.
    return {frame_.toWorld(point), frame_.directionToWorld(face.of_a ? up : Vec2(-up)), depth * frame_.unit(),
            face.of_a ? own_edge : other_edge, face.of_a ? other_edge : own_edge};
  }

  const PosedPair& pair_;
  const Frame frame_;
  const double doubtful_;
  const Ring a_, b_;
  /// The edges that boundLeast() looked at, and the square of a depth that none of interest exceeds.
  std::size_t facing_a_ = 0, facing_b_ = 0;
  double most_ = std::numeric_limits<double>::infinity();
  bool is_apart_ = false;
  /// The least depth behind a face so far, and the square of what counts as equal.
  double least_ = std::numeric_limits<double>::infinity(), limit_ = least_;
  std::array<Face, kMostBest> best_;
  std::ptrdiff_t best_count_ = 0;
  /// By depth; only where they are to be kept.
  std::array<Face, ContactFacts::kMost + 1> nearest_;
};

/// A part of the smaller one's radius: faces that are deeper by less are kept, for steps of a hundredth of that and
/// more.
constexpr double kLookahead = 1.0 / 32;

/// Whether a's frame and b's differ by no more than FrameOfA lets a's and the world's: then depths behind faces of
/// either are the same in both.
bool keepsLengths(const PosedPair& pair) { return pair.defect < 0x1p-46; }

/// At most how far a point of either has moved against the other since. In a's frame the point q of b's frame has moved
/// by d(q), where d is the difference of both maps. A point of a, at q then, has moved by as much in b's frame, but for
/// what that frame is off by; and q is no farther from b's S than both radii and a's once more, because they overlap.
double motionSince(const ContactFacts& cache, const PosedPair& pair) {
  Change change(pair.b, load2(&pair.m00) - load2(cache.second_in_first),
                load2(&pair.m01) - load2(cache.second_in_first + 2),
                load2(&pair.tx) - load2(cache.second_in_first + 4));
  change.radius += pair.b.radius + 3 * pair.a.radius;
  return change.displacement() * (1 + 1e-12) + 2 * (pair.error + cache.error);
}

void storePose(ContactFacts& cache, const PosedPair& pair) {
  cache.first_id = pair.a.id;
  cache.second_id = pair.b.id;
  std::copy(&pair.m00, &pair.m00 + 6, cache.second_in_first);
  cache.error = pair.error;
}

ConvexContact contactInFrameOfA(const PosedPair& pair, int turn_a, int turn_b, ContactFacts* cache) {
  if (cache == nullptr || !keepsLengths(pair))
    return ConvexPair<FrameOfA, true>(pair, turn_a, turn_b).byAllFaces(nullptr, 0);
  bool coherent = false;
  // Areas are in doubt by at most the square of that more than they were.
  const bool alike = pair.error <= 1.5 * cache->error;
  if (alike && cache->first_id == pair.a.id && cache->second_id == pair.b.id) {
    const double motion = motionSince(*cache, pair);
    coherent = motion < kCoherentPart * pair.b.radius;
    if (cache->count > 0 && motion < cache->deeper) {
      // Of few vertices all are mapped sooner than some of them several times.
      const bool few = pair.a.path.size() + pair.b.path.size() <= 40;
      const ConvexContact found = few ? ConvexPair<FrameOfA, true>(pair, turn_a, turn_b).byKeptFaces(*cache, motion)
                                      : ConvexPair<FrameOfA, false>(pair, turn_a, turn_b).byKeptFaces(*cache, motion);
      if (found.verdict == ConvexContact::Overlap) return found;
    }
  }
  cache->count = 0;
  storePose(*cache, pair);
  // After a jump another may follow.
  return ConvexPair<FrameOfA, true>(pair, turn_a, turn_b)
      .byAllFaces(coherent ? cache : nullptr, kLookahead * pair.b.radius);
}

}  // namespace

ConvexContact convexContact(const PosedPair& pair, ContactFacts* cache) {
  const int turn_a = convexOutlineOf(pair.a).turn, turn_b = convexOutlineOf(pair.b).turn;
  if (turn_a == 0 || turn_b == 0) return {};
  const auto mirrors = [](const Pose& pose) { return pose.linear().determinant() < 0; };
  const bool mirrors_a = mirrors(pair.pose_a), mirrors_b = mirrors(pair.pose_b);
  if (FrameOfA::fits(pair)) return contactInFrameOfA(pair, turn_a, mirrors_a != mirrors_b ? -turn_b : turn_b, cache);
  return ConvexPair<WorldFrame, true>(pair, mirrors_a ? -turn_a : turn_a, mirrors_b ? -turn_b : turn_b)
      .byAllFaces(nullptr, 0);
}

}  // namespace tricover::detail
