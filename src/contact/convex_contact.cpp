// SPDX-License-Identifier: BSD-3-Clause
// Depth, normal and edges are those of the least face. Both outlines are turned so that its normal leads upwards, and
// followed from the face down and from the vertex deepest behind it up, as far as it takes: level lines tell where the
// overlap is deepest, and the upright line through there its middle.
//
// The edges of two convex regions that meet share a point unless one region lies within the other: each has to have a
// corner that is certainly outside the other.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "contact/contact_ends.h"
#include "contact/contact_solvers.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// Edge by edge around an outline.
class Walk {
 public:
  /// From a corner, which is at `start`.
  Walk(const PosedRing& outline, std::uint32_t corner, const Double2& start, bool is_forward)
      : to(start), outline_(outline), corner_(corner), is_forward_(is_forward) {
    advance();
  }

  void advance() {
    corner_ = is_forward_ ? outline_.ring.next(corner_) : outline_.ring.previous(corner_);
    from = to;
    to = outline_.corner(corner_);
  }

  /// Of the edge's point, or the next to it, where one coordinate is as given the other one.
  double at(int axis, double coordinate) const {
    const Double2 way = to - from;
    const double t = (coordinate - from[axis]) / way[axis];
    if (!(t > 0)) return from[1 - axis];
    if (!(t < 1)) return to[1 - axis];
    return t < 0.5 ? from[1 - axis] + t * way[1 - axis] : to[1 - axis] + (t - 1) * way[1 - axis];
  }

  Double2 from, to;

 private:
  const PosedRing& outline_;
  std::uint32_t corner_;
  bool is_forward_;
};

enum class Located { Inside, Outside, Unsure };

/// The middle of two outlines' overlap along the normal of a face of `own`, behind which `other` is deepest with its
/// corner `deepest`.
class OverlapMiddle {
 public:
  OverlapMiddle(const PosedRing& own, const PosedRing& other, const FaceDepth& face, double error, double tie)
      : own_(own),
        other_(other),
        face_at_(own.corner(face.edge)),
        deepest_at_(other.corner(face.deepest)),
        own_right_(fromFace(face, true)),
        own_left_(fromFace(face, false)),
        other_right_(other, face.deepest, deepest_at_, !other_.mirrors()),
        other_left_(other, face.deepest, deepest_at_, other_.mirrors()),
        error_(error),
        tie_(tie) {}

  /// False where doubles don't tell.
  bool find() {
    double across, bottom;
    if (!findDeepest(across, bottom)) return false;
    const double top = topAt(across);
    // Otherwise edges are so steep that one of them is hardly known.
    if (top < bottom - error_) return false;
    point = Vec2(across, 0.5 * bottom + 0.5 * top);
    return true;
  }

  /// The face, and the edge that leaves the other outline's corner or leads to it, both from the point.
  Slope face() const { return slope(own_left_.from, own_right_.from); }
  Slope edgeAtDeepest(bool leaves) const {
    const Walk& walk = leaves != other_.mirrors() ? other_right_ : other_left_;
    return slope(walk.from, walk.to);
  }

  Vec2 point;
  bool own_reaches_beyond = false, other_reaches_beyond = false;  ///< certainly; otherwise it isn't known

 private:
  struct LevelPoint {
    double at, lowest;
    Double2 way;
    double slope() const { return way[0] / way[1]; }
  };

  Slope slope(Double2 v, Double2 w) const { return {Vec2(v[0], v[1]) - point, Vec2(w[0], w[1]) - point}; }

  Walk fromFace(const FaceDepth& face, bool to_right) const {
    if (to_right != own_.mirrors()) return {own_, face.edge, face_at_, false};
    const std::uint32_t end = own_.ring.next(face.edge);
    return {own_, end, own_.corner(end), true};
  }

  /// Where an outline's side is at a level, or at corners that are above it by no more than a tie, if it comes there.
  LevelPoint sideAt(Walk walk, std::uint32_t size, bool leads_down, double level) const {
    const double passed = level + tie_;
    double lowest = walk.to[1];
    // An outline hardly higher than a tie has its face's end there.
    if (leads_down && walk.from[1] <= passed) return {walk.from[0], lowest, walk.to - walk.from};
    for (; size > 0 && (leads_down ? walk.to[1] > passed : walk.to[1] < passed); --size) {
      walk.advance();
      lowest = std::min(lowest, walk.to[1]);
    }
    return {walk.at(1, level), lowest, walk.to - walk.from};
  }

  /// Where the overlap is deepest, or the middle of that. From its bottom on upwards, what the outlines have of a level
  /// line has a part in common. How far these are apart below is convex, so that its tangents lead there from below
  /// (Newton's method), edge by edge.
  bool findDeepest(double& across, double& level) {
    const std::uint32_t own_size = own_.ring.size(), other_size = other_.ring.size();
    level = deepest_at_[1];
    const double beyond = level - 8 * error_;
    for (std::uint32_t steps = own_size + other_size; steps > 0; --steps) {
      const LevelPoint own_right = sideAt(own_right_, own_size, true, level);
      own_reaches_beyond = own_reaches_beyond || own_right.lowest < beyond;
      if (own_right.lowest > level + tie_) {
        level = own_right.lowest;
        continue;
      }
      const LevelPoint own_left = sideAt(own_left_, own_size, true, level),
                       other_right = sideAt(other_right_, other_size, false, level),
                       other_left = sideAt(other_left_, other_size, false, level);
      const LevelPoint &right = own_right.at < other_right.at ? own_right : other_right,
                       &left = own_left.at > other_left.at ? own_left : other_left;
      across = 0.5 * left.at + 0.5 * right.at;
      if (left.at <= right.at) return true;
      const double right_slope = right.slope(), left_slope = left.slope();
      const double closing = right_slope - left_slope, step = (left.at - right.at) / closing;
      if (!(closing > 0)) return false;
      if (step <= error_) {
        // The flatter one's point of a level line is hardly known.
        across = std::abs(right_slope) < std::abs(left_slope) ? right.at : left.at;
        return true;
      }
      level += step;
    }
    return false;
  }

  /// The upper end of what the overlap has of an upright line.
  double topAt(double across) {
    const double beyond = face_at_[1] + 8 * error_;
    double top = face_at_[1];
    for (const double sign : {1, -1}) {
      const auto ahead = [&](Double2 p) { return sign * (p[0] - across); };
      std::uint32_t own_left = own_.ring.size(), other_left = other_.ring.size();
      const Walk& face_end = sign > 0 ? own_right_ : own_left_;
      if (ahead(face_end.from) < 0) {
        Walk own = face_end;
        while (ahead(own.to) < 0 && --own_left > 0) own.advance();
        top = std::min(top, own.at(0, across));
      }
      Walk other = sign > 0 ? other_right_ : other_left_;
      const auto returns = [&] { return ahead(other.to) <= 0 && ahead(other.to) < ahead(other.from); };
      while (!returns() && other.to[1] <= beyond && --other_left > 0) other.advance();
      other_reaches_beyond = other_reaches_beyond || other.to[1] > beyond;
      if (returns()) top = std::min(top, other.at(0, across));
      // An upright line, for all that doubles tell of it, never turns back.
      if (other_left == 0) top = std::min(top, highest(other_));
    }
    return top;
  }

  static double highest(const PosedRing& outline) {
    double height = -std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 0; k < outline.ring.size(); ++k) height = std::max(height, outline.corner(k)[1]);
    return height;
  }

  const PosedRing &own_, &other_;
  const Double2 face_at_, deepest_at_;                          ///< where the face begins, and the corner
  const Walk own_right_, own_left_, other_right_, other_left_;  ///< from the face's ends, and from the corner
  const double error_, tie_;
};

class ConvexPair {
 public:
  ConvexPair(const PosedPair& pair, const SeparatingAxes& axes, double margin)
      : pair_(pair),
        axes_(axes),
        margin_(margin),
        face_(bestFace()),
        up_(axes_.side(face_.of_a).normalOf(face_.edge)),
        incident_(incidentEdge()) {
    // In either coordinate a corner is at most r = kUnitRows size, and errs by at most e = error, which is at least
    // 16U size; a difference d of two is at most 2 r, and errs by 2 e and its own U d. An area, the product of two:
    //   the differences' roundings       two in each of two products     4U (2 r)^2
    //   the products', their difference                                  4U (2 r)^2
    //   what the corners are off by      two for each of four factors    8 e 2 r
    // which is 32U r^2 + 16 e r and terms of second order: 18 e r with all of them.
    doubtful_ = 20 * axes_.error() * axes_.size();
  }

  /// What is proven of a pair that meets.
  std::optional<Contact> contact() const {
    const PosedRing own = turned(face_.of_a), other = turned(!face_.of_a);
    OverlapMiddle middle(own, other, face_, axes_.error(), axes_.tie());
    if (!middle.find()) return {};
    const Located own_place = middle.own_reaches_beyond ? Located::Outside : placeOfRegion(face_.of_a),
                  other_place = middle.other_reaches_beyond ? Located::Outside : placeOfRegion(!face_.of_a);
    if (own_place == Located::Unsure || other_place == Located::Unsure) return {};
    const bool is_own_inside = own_place == Located::Inside, is_other_inside = other_place == Located::Inside;
    Contact contact = contactOf(inWorld(middle.point), is_other_inside, is_own_inside);
    if (is_own_inside || is_other_inside) return contact;
    ContactEnds ends;
    if (contactEnds(middle.face(), middle.edgeAtDeepest(incident_ == face_.deepest), contact.depth, margin_,
                    axes_.tie(), ends)) {
      contact.count = 2;
      for (std::size_t k = 0; k < 2; ++k)
        contact.points[k] = {inWorld(middle.point + Vec2(ends[k].place, ends[k].height)), ends[k].depth};
    }
    return contact;
  }

 private:
  Vec2 inWorld(const Vec2& turned) const {
    return turned.x() * Vec2(up_.y(), -up_.x()) + turned.y() * up_ + pair_.pose_a.translation();
  }

  PosedRing turned(bool of_a) const { return axes_.side(of_a).ring.turnedUp(load2(up_.data())); }

  /// Of those that are equally deep but for rounding, the one that leads b's S away from a's.
  FaceDepth bestFace() const {
    if (axes_.end() - axes_.begin() == 1) return *axes_.begin();
    const Double2 way = pair_.way();
    const Vec2 towards_b(way[0], way[1]);
    const auto along = [&](const FaceDepth& face) {
      return (face.of_a ? 1 : -1) * axes_.side(face.of_a).normalOf(face.edge).dot(towards_b);
    };
    const FaceDepth* best = nullptr;
    for (const FaceDepth& face : axes_)
      if (face.depth <= axes_.leastDepth() + axes_.tie() && (best == nullptr || along(face) > along(*best)))
        best = &face;
    return *best;
  }

  /// Where one region is as seen from the other one: inside if all corners are that may be its support vertices along
  /// the other one's normals.
  Located placeOfRegion(bool of_a) const {
    const AxisSide &own = axes_.side(of_a), &other = axes_.side(!of_a);
    const ConvexRing &corners = own.ring.ring, &faces = other.ring.ring;
    bool is_unsure = false;
    RingRange range;
    for (std::uint32_t k = 0; k < faces.size(); ++k) {
      const Double2 n = other.ring.normal(k);
      if (!corners.supportVertex(own.ring.inFrame(n), own.climbError(n), range)) return Located::Unsure;
      for (std::uint32_t step = 0; step < range.count; ++step) {
        const Double2 corner = own.ring.corner(corners.after(range.first, step));
        const double area = cross(faces.edge(k), other.ring.inOwnFrame(corner) - faces.vertex(k));
        if (area < -doubtful_) return Located::Outside;
        is_unsure = is_unsure || !(area > doubtful_);
      }
    }
    return is_unsure ? Located::Unsure : Located::Inside;
  }

  /// An edge at the corner that is deepest behind the face: the one that is more across its normal.
  EdgePosition incidentEdge() const {
    const AxisSide& side = axes_.side(!face_.of_a);
    const std::uint32_t corner = face_.deepest;
    const auto slope = [&](EdgePosition edge) {
      const Double2 way = side.ring.edge(edge);
      const double along = dot(load2(up_.data()), way);
      return along * along / dot(way, way);
    };
    const std::uint32_t before = side.ring.ring.previous(corner);
    const bool forward = side.outline.forward;
    const std::uint32_t arriving = forward ? before : corner, leaving = forward ? corner : before;
    return slope(arriving) < slope(leaving) ? arriving : leaving;
  }

  Contact contactOf(const Vec2& point, bool other_is_inside, bool own_is_inside) const {
    const AxisSide &own = axes_.side(face_.of_a), &other = axes_.side(!face_.of_a);
    const Double2 deepest = own.ring.inOwnFrame(other.ring.corner(face_.deepest));
    const auto nameOf = [](const AxisSide& side, EdgePosition edge, const Vec2& beside) {
      return side.polygon.edgeName(pathEdge(side.polygon, side.outline, edge, beside));
    };
    const EdgeIndex own_edge = other_is_inside ? -1 : nameOf(own, face_.edge, {deepest[0], deepest[1]}),
                    other_edge = own_is_inside ? -1 : nameOf(other, incident_, other.outline.points[face_.deepest]);
    assert(face_.depth > 0 && std::abs(up_.norm() - 1) < 0x1p-40);
    return contactAt(point, face_.of_a ? up_ : Vec2(-up_), face_.depth + margin_, face_.of_a ? own_edge : other_edge,
                     face_.of_a ? other_edge : own_edge);
  }

  const PosedPair& pair_;
  const SeparatingAxes& axes_;
  const double margin_;
  const FaceDepth face_;
  const Vec2 up_;  ///< outwards from the face
  const EdgePosition incident_;
  double doubtful_;  ///< areas of corners, up to this
};

}  // namespace

std::optional<Contact> convexContact(const PosedPair& pair, const SeparatingAxes& axes, double margin) {
  // Less may be a touch.
  if (!(axes.leastDepth() > 64 * axes.error())) return {};
  return ConvexPair(pair, axes, margin).contact();
}

}  // namespace tricover::detail
