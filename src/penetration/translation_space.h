// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "numbers/segment.h"
#include "overlay/rings.h"
#include "pair/edge_pairs.h"
#include "pair/world_frame.h"

namespace tricover::detail {

// In units of U, r_a and r_b the radii, c the way between the origins; reach is their sum:
//   a vertex of b     p - q 1, products 1, sum 1                           3 r_b in either coordinate
//   one of a          the same, the sum with c 1, c itself 1               4 r_a + 2 c
//   a segment's end   their difference 1                                   4 r_b + 5 r_a + 3 c
// which is sqrt2 5 reach in any direction. at() rounds a translation to the spacing of
// doubles at t_b - t_a + t, of which no component is larger than reach and shift: two sums there and two differences
// back, 4.
constexpr double kVertexError = 16 * kUnitRoundoff, kShiftError = 4 * kUnitRoundoff;
static_assert(kVertexError >= kUnitRows * kRoot2 * errorOf(5) + errorOf(4));

struct PlacedVertex {
  Vec2 at;
  Vec2 incoming, outgoing;  ///< edges at it, beyond its repetitions
  bool is_edge;             ///< not a repetition of the next one
  bool is_reflex;           ///< certainly, seen from its region
  std::int8_t side;         ///< of the outgoing edge on which the region is: 1: left, -1: right, 0: unknown
};

/// One polygon (side 0: a, 1: b) in the WorldFrame. Its vertices, by position, are placed when they are first needed:
/// shallow overlaps need few.
class PlacedPolygon {
 public:
  PlacedPolygon(const PosedPair& pair, const WorldFrame& frame, int side)
      : polygon(side == 0 ? pair.a : pair.b), frame_(frame), side_(side) {}

  Vec2 vertex(std::size_t i) const { return frame_.from(side_, polygon.path[i]); }

  /// To be called before the following ones. sides: null if they are not needed.
  void prepare(const RegionSides* sides);
  std::size_t size() const { return is_placed_.size(); }
  const PlacedVertex& operator[](EdgePosition i) const {
    if (!is_placed_[i]) place(i);
    return vertices_[i];
  }

  const PolygonData& polygon;

 private:
  void place(EdgePosition i) const;
  /// From vertices in units, since their difference may overflow.
  Vec2 way(std::size_t from, std::size_t to) const {
    const double inverse = polygon.inverse_unit;
    return frame_.turned(side_, polygon.path[to] * inverse - polygon.path[from] * inverse);
  }

  const WorldFrame& frame_;
  const int side_;
  const RegionSides* sides_ = nullptr;
  mutable std::vector<std::uint8_t> is_placed_;
  std::unique_ptr<PlacedVertex[]> vertices_;
};

/// The plane of b's translations, in which the regions overlap on M = A + (-B), in the WorldFrame's lengths; its origin
/// is b where it is.
///
/// The boundary of M lies on convolution segments: a vertex of a less an edge of b, or an edge of a less a vertex of b;
/// and of these only where the edges at the vertex don't leave to both sides of the other's line, since otherwise the
/// translations around a segment's inner point overlap, too. Where it is known on which side of an edge its region is
/// (regionSidesOf()), the other's vertex has to be a corner of its own region, and on the other side.
class TranslationSpace {
 public:
  explicit TranslationSpace(const PosedPair& pair);
  TranslationSpace(const TranslationSpace&) = delete;
  TranslationSpace& operator=(const TranslationSpace&) = delete;

  /// To be called before the functions about edges and segments, which then are no farther away than that.
  void prepareSearch(double farthest);

  /// Free translations may be on its left, and on its right if it has both sides.
  struct Segment {
    Vec2 v, w;
    EdgePosition edge_a, edge_b;  ///< positions; the vertex is the start of its polygon's edge
    bool vertex_of_a, both_sides;
  };

  /// The kernel's pair with b translated by t as nearly as doubles allow; t becomes what it was translated by. The last
  /// pair made is the valid one.
  PosedPair at(Vec2& t);

  /// The parallelogram of those translations that let two edges meet. Its sides are convolution segments.
  struct MeetingEdges {
    Vec2 corner;            ///< where their starts meet
    Vec2 up_a, up_b;        ///< unit normals of the sides along a's and along b's edge, into the parallelogram
    double high_a, high_b;  ///< how far the opposite sides are from these

    /// How deep t is in it; outside, no more than its distance with the opposite sign. But for three of noise().
    double depth(const Vec2& t) const {
      const double from_a = up_a.dot(t - corner), from_b = up_b.dot(t - corner);
      return std::min({from_a, high_a - from_a, from_b, high_b - from_b});
    }
  };

  /// By two edges' positions.
  MeetingEdges meetingOf(EdgePosition i, EdgePosition j) const;

  /// Calls meet(meeting) for each pair of edges that may meet at t, and visit(segment) for each convolution segment
  /// within `radius` of t, where `pair` is at(t). Either one ends it by returning false.
  template <typename Meet, typename Visit>
  void forEachSegment(const PosedPair& pair, const Vec2& t, double radius, Meet meet, Visit visit) const {
    const double limit = (radius + noise_) * frame.unit();
    forEachPair(pair, limit, [&](double gap, EdgePosition i, EdgePosition j) {
      if (gap <= 0 && !meet(meetingOf(i, j))) return -1.0;
      const bool goes_on = !a_[i].is_edge || !b_[j].is_edge ||
                           (show<true>(i, j, t, radius, visit) && show<false>(i, j, t, radius, visit));
      return goes_on ? limit : -1;
    });
  }

  struct NearestSegment {
    Segment segment;
    double apart;
  };
  /// The segment nearest to t, of all that may bound free translations.
  NearestSegment nearestSegment(const Vec2& t);

  /// Whether so few convolution segments may bound what the regions overlap on that a search gathers all at once.
  bool areFew() const { return are_few_; }
  /// The convolution segments within `radius` of 0, by the directions of edges: it takes what those of all of the plane
  /// are. But for some that bound nothing.
  std::vector<Segment> segmentsWithin(double radius) const;

  bool isFinite() const { return noise_ < std::max(frame.scale(0), frame.scale(1)); }
  /// At least what an end of a segment is wrong by, and t in at().
  double noise() const { return noise_; }

  const PlacedPolygon& side(int side) const { return side == 0 ? a_ : b_; }

  const WorldFrame frame;

 private:
  /// Where free translations may be on both sides of a segment, on one, or on none.
  struct Open {
    bool left, right;
  };
  /// Of an edge of one polygon and a vertex of the other, on which sides of the edge the vertex may be moved away from
  /// it: certainly on none only if the edges at the vertex leave to both sides of the edge's line, or into its region,
  /// or if the vertex is reflex. A direction's coordinates err by a difference, a product and a sum, their cross
  /// product by these of both, a product and a difference: 8U.
  static Open opening(const PlacedVertex& edge, const PlacedVertex& vertex) {
    static_assert(kVertexError >= kUnitRows * errorOf(3 + 3 + 2));
    const double from = cross(edge.outgoing, vertex.incoming), to = cross(edge.outgoing, vertex.outgoing);
    const double error = kVertexError * edge.outgoing.lpNorm<1>();
    const double from_error = error * vertex.incoming.lpNorm<1>(), to_error = error * vertex.outgoing.lpNorm<1>();
    const bool passes = (from > from_error && to > to_error) || (from < -from_error && to < -to_error);
    if (passes || vertex.is_reflex) return {false, false};
    return {edge.side <= 0 && from <= from_error && to >= -to_error,
            edge.side >= 0 && from >= -from_error && to <= to_error};
  }

  /// Segments go along a's edge, of which b's vertex may be moved to the left; and back along b's: where a's vertex is
  /// to its left b is moved to its right, and that is the segment's left.
  template <bool vertex_of_a, typename Visit>
  bool show(EdgePosition i, EdgePosition j, const Vec2& t, double radius, Visit& visit) const {
    const PlacedVertex &of_a = a_[i], &of_b = b_[j];
    const Open open = vertex_of_a ? opening(of_b, of_a) : opening(of_a, of_b);
    if (!open.left && !open.right) return true;
    const Vec2 start = of_a.at - of_b.at, end = vertex_of_a ? of_a.at - b_[j + 1].at : a_[i + 1].at - of_b.at;
    const double within = (radius + noise_) * (radius + noise_);
    if (!(squaredDistanceToSegment(t, start, end) <= within)) return true;
    return visit(Segment{open.left ? start : end, open.left ? end : start, i, j, vertex_of_a, open.left && open.right});
  }

  /// A disc of translations at which a disc in a and one in b overlap: the sum of one of a and one of -b.
  struct Disc {
    Vec2 center;
    double radius;
    bool holds(const Vec2& p) const { return (p - center).squaredNorm() < radius * std::abs(radius); }
  };
  std::vector<Disc> overlappingDiscs() const;

  /// An edge's, with the region on its left: both where nobody knows.
  struct Direction {
    double turn;
    Vec2 start;
    double reach_square;  ///< vertices farther from its start aren't within a radius of it
    EdgePosition edge;
  };
  static std::vector<Direction> directionsOf(const PlacedPolygon& vertices, double radius);
  template <typename Visit>
  static void forEachEdgeBeside(const PlacedVertex& vertex, const std::vector<Direction>& directions, Visit visit);

  PlacedPolygon a_, b_;
  Pose pose_a_, pose_b_;     ///< less a's translation
  Vec2 shift_, shift_rest_;  ///< t_b - t_a, as a rounded part and the rest
  double noise_;
  bool are_few_ = false;
};

}  // namespace tricover::detail
