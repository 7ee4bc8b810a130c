// SPDX-License-Identifier: BSD-3-Clause
// The shortest parting translation is the nearest point of the closure of the free ones. That is 0's projection on a
// convolution segment, an end of one or a crossing of two (on the boundary of a free face of the segments' arrangement
// no other point is nearest), and which of these are limits of free translations the kernel tells, by samples beside
// them. Looking at all would cost (n m)^2, so the plane is searched from 0 outwards by square cells. A cell is done
// with where no segment comes near it, where few enough do for all their candidates to be tried, where the kernel's
// clearance or depth at its centre reaches beyond it, and where two edges meet on all of it; otherwise it is split in
// four. Nearer cells are done with before farther ones, so the least distance of those left is a lower bound.
//
// Where few segments bound all of a deep overlap, they are gathered once, by the directions of edges, but for those
// that lie where inner discs of both overlap; and each cell looks at those of the cell that it is a part of. Which side
// of a segment is free is known; so are the candidates whose way from 0 leads out of what bounds them, and the sectors
// beside them that may be free: no others are asked for.
//
// Segments within `resolution_` of each other are taken for one: outlines that run parallel but for rounding would make
// slivers without end. So a free slit narrower than twice that may be missed, and nothing else.
//
// Cost: a query of the kernel a sample, and one a cell whose segments aren't known; cells are as small as the overlap
// is intricate. Worst case: outlines that are nearly parallel by more than the resolution over a long way, as combs
// rotated by 1e-9 against each other are, need cells as small as their gaps; only the number of translations ends that.
#include "penetration/translation_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "numbers/angle.h"
#include "numbers/best_first.h"
#include "pair/collide_by_hierarchy.h"
#include "penetration/boundary_lines.h"

namespace tricover::detail {
namespace {

constexpr double kDiagonal = 1.4142135623730951;
/// A cell is decided by no more lines than these: fewer where gathering them costs as much as anything, unless it is
/// so small a part of what is searched that it may be one point they cross in.
constexpr std::size_t kMostKnown = 24, kMostGathered = 6;
constexpr double kSmall = 0x1p-8;
/// How far beyond a cell its segments are gathered, so that samples around a point of it are understood: a share of the
/// radius of its circumcircle, and beside small cells so many resolutions, since a sector shows whether it is free only
/// where it is a few of them wide.
constexpr double kSurroundings = 0x1p-5, kLeastSurroundings = 64;
/// How far beside a point samples are, as a share of that: the rest is for lines that count as one with others.
constexpr double kRoom = 0.64;
/// So many pairs of edges that met last are tried first.
constexpr std::size_t kMostMeetings = 8;

using MeetingEdges = TranslationSpace::MeetingEdges;

using Segments = std::vector<std::uint32_t>;  ///< numbers of the search's segments

struct Cell {
  Cell(const Vec2& center_, double half_, std::shared_ptr<const Segments> segments_)
      : least((center_.cwiseAbs() - Vec2::Constant(half_)).cwiseMax(0).norm()),
        center(center_),
        half(half_),
        segments(std::move(segments_)) {}

  double least;  ///< distance of 0
  Vec2 center;
  double half;
  std::shared_ptr<const Segments> segments;  ///< all that may come near it; null where they aren't known

  bool operator<(const Cell& other) const { return least > other.least; }
};

class PartingSearch {
 public:
  PartingSearch(TranslationSpace& space, const Vec2& known, std::size_t most)
      : space_(space),
        most_(most),
        noise_(space.noise()),
        resolution_(16 * noise_),
        lines_(noise_, resolution_),
        best_{known, known, 0, {}},
        search_(known.norm()) {}

  /// last: null, or where the last search ended.
  ShortestParting run(const Vec2* last) {
    space_.prepareSearch(search_.upper);
    if (last != nullptr) tryFirst(*last);
    const double half = search_.upper * (1 + 0x1p-20);
    search_.push(Cell(Vec2::Zero(), half, space_.areFew() ? segmentsAround(half) : nullptr));
    search_.run(
        0, [&] { return tries_ >= most_; },
        [&](const Cell& cell) {
          if (!isDone(cell)) divide(cell);
        });
    reachSegment();
    best_.lower_bound = std::max(0.0, std::min(search_.lower(), search_.upper - resolution_ - best_error_));
    return best_;
  }

 private:
  /// Tries a little farther, too, because the polygons may have rotated since.
  void tryFirst(const Vec2& last) {
    for (const double farther : {1.0, 1.01, 1.05}) {
      Vec2 t = farther * last;
      if (!(t.norm() < search_.upper)) return;
      if (isFree(t)) return improve(t, t);
    }
  }

  void improve(const Vec2& limit, const Vec2& parting, double limit_error = 0) {
    if (!(limit.norm() < search_.upper)) return;
    search_.upper = limit.norm();
    best_error_ = limit_error;
    best_.limit = limit;
    best_.parting = parting;
  }

  /// A limit that a clearance gave may end before the regions touch. Nothing changes up to the nearest segment, so that
  /// much shorter is free, too. Few steps do unless the way grazes the segment.
  void reachSegment() {
    constexpr int kMostSteps = 16;
    const bool by_clearance = best_.limit == best_.parting;
    best_.nearest = space_.nearestSegment(best_.limit);
    for (int step = 0; by_clearance && step < kMostSteps && best_.nearest.apart > resolution_; ++step) {
      const double left = 1 - (best_.nearest.apart - resolution_ / 2) / best_.limit.norm();
      improve(std::max(left, 0.0) * best_.limit, best_.parting);
      best_.nearest = space_.nearestSegment(best_.limit);
    }
  }

  void divide(const Cell& cell) {
    const auto segments = cell.segments ? std::make_shared<const Segments>(segments_) : nullptr;
    const double half = cell.half / 2;
    for (const Vec2& way : {Vec2(-half, -half), Vec2(half, -half), Vec2(-half, half), Vec2(half, half)})
      search_.push(Cell(cell.center + way, half, segments));
  }

  /// Whether a cell holds no limit that is shorter than the best.
  bool isDone(const Cell& cell) {
    ++tries_;
    const double radius = cell.half * kDiagonal * (1 + 0x1p-40);
    if (cell.half <= resolution_ || overlapAround(cell.center, radius)) return true;
    if (cell.segments) {
      if (!filter(cell, radius)) return false;
    } else {
      if (!overlapAround(cell.center, 0) && decidesAll(cell.center, radius)) return true;
      const Gathered gathered = gather(cell, radius);
      if (gathered != Gathered::Lines) return gathered == Gathered::Deep;
    }
    // Without a line the answer at the centre is that of the whole cell.
    return lines_.isEmpty() || tryLimits(cell, kRoom * surroundings(radius));
  }

  /// Whether two edges that met last meet after all translations within `radius` of t.
  bool overlapAround(const Vec2& t, double radius) {
    for (MeetingEdges& meeting : met_) {
      if (meeting.depth(t) - 4 * noise_ <= radius) continue;
      std::swap(meeting, met_.front());
      return true;
    }
    return false;
  }

  void keep(const MeetingEdges& meeting) {
    if (met_.size() == kMostMeetings) met_.pop_back();
    met_.insert(met_.begin(), meeting);
  }
  void keep(const Outcome& outcome) {
    if (outcome.edge_a == kNoEdge || outcome.edge_b == kNoEdge) return;
    keep(space_.meetingOf(outcome.edge_a, outcome.edge_b));
  }

  /// Whether the regions are apart after a translation; t becomes the one that was asked for.
  bool isFree(Vec2& t) {
    if (overlapAround(t, 0)) return false;
    ++tries_;
    const Outcome outcome = collideByHierarchy(space_.at(t), {}, 0, Wanted::Answer);
    if (outcome.collides) keep(outcome);
    return !outcome.collides;
  }

  /// Whether the kernel's answer at a cell's centre is that of the whole cell.
  bool decidesAll(const Vec2& center, double radius) {
    Vec2 t = center;
    const PosedPair pair = space_.at(t);
    radius += (t - center).norm() * (1 + 0x1p-40);
    const Outcome outcome = collideByHierarchy(pair, {}, 2 * radius * space_.frame.unit(), Wanted::Clearance);
    const bool cross = outcome.collides && outcome.edge_a != kNoEdge && outcome.edge_b != kNoEdge;
    const double length = cross ? crossingDepth(pair, outcome.edge_a, outcome.edge_b) : outcome.clearance;
    const double unchanged = length / space_.frame.unit();
    if (outcome.collides) {
      keep(outcome);
    } else {
      const double back = std::clamp(unchanged - noise_, 0.0, t.norm());
      const Vec2 nearest = t.isZero(0) ? t : Vec2(t * (1 - back / t.norm()));
      improve(nearest, nearest);
    }
    return unchanged >= radius;
  }

  double surroundings(double radius) const {
    return std::max(kSurroundings * radius, kLeastSurroundings * resolution_);
  }
  /// To where, from a cell's centre, its lines are cut.
  double cutAt(double radius) const { return radius + 2 * surroundings(radius); }

  /// All segments that a search by squares of such a half side needs.
  std::shared_ptr<const Segments> segmentsAround(double half) {
    for (const TranslationSpace::Segment& s : space_.segmentsWithin(search_.upper + surroundings(2 * half)))
      all_segments_.emplace_back(Ends{s.v, s.w}, s.both_sides, noise_);
    Segments all(all_segments_.size());
    std::iota(all.begin(), all.end(), 0);
    return std::make_shared<const Segments>(std::move(all));
  }

  /// The lines around a cell, and its segments, from those of the cell that it is a part of. False if they are many.
  bool filter(const Cell& cell, double radius) {
    const double around = cell.half + surroundings(radius);
    segments_.clear();
    for (const std::uint32_t k : *cell.segments)
      if (all_segments_[k].boxMeets(cell.center, around) && all_segments_[k].lineMeets(cell.center, around))
        segments_.push_back(k);
    lines_.clear(kMostKnown);
    return segments_.size() <= 2 * kMostKnown && std::all_of(segments_.begin(), segments_.end(), [&](std::uint32_t k) {
             return lines_.add(all_segments_[k], cell.center, cutAt(radius));
           });
  }

  enum class Gathered { Lines, Deep, Many };

  /// All lines around a cell; or why there are none: too many, or two edges meet on all of it.
  Gathered gather(const Cell& cell, double radius) {
    Gathered result = Gathered::Lines;
    lines_.clear(cell.half < kSmall * search_.upper ? kMostKnown : kMostGathered);
    Vec2 t = cell.center;
    const PosedPair pair = space_.at(t);
    const double off = (t - cell.center).norm(), around = cutAt(radius) + off;
    const double half = cell.half + surroundings(radius) + off;
    space_.forEachSegment(
        pair, t, half * kDiagonal * (1 + 0x1p-40),
        [&](const MeetingEdges& meeting) {
          const double depth = meeting.depth(cell.center) - 4 * noise_;
          if (depth > -radius) keep(meeting);
          if (depth >= radius) result = Gathered::Deep;
          return result == Gathered::Lines;
        },
        [&](const TranslationSpace::Segment& segment) {
          const BoundaryLines::Line line({segment.v, segment.w}, segment.both_sides, noise_);
          if (line.boxMeets(t, half) && line.lineMeets(t, half) && !lines_.add(line, t, around))
            result = Gathered::Many;
          return result == Gathered::Lines;
        });
    return result;
  }

  struct PossibleLimit {
    Vec2 p;
    double error;  ///< of p, along the lines that cross there
  };

  /// Tries all points that may be the nearest limit in a cell, if the lines are all that come within more than `room`
  /// of it. The nearest point of a free face of the lines' arrangement is the nearest point, an end or a crossing of
  /// them. False if the cell's quarters have to be searched.
  bool tryLimits(const Cell& cell, double room) {
    limits_.clear();
    lines_.forEachPossibleLimit([&](const Vec2& p, double error) {
      if ((p - cell.center).lpNorm<Eigen::Infinity>() > cell.half + resolution_ || !(p.norm() < search_.upper)) return;
      for (const PossibleLimit& other : limits_)
        if ((p - other.p).norm() <= noise_) return;
      limits_.push_back({p, error});
    });
    std::sort(limits_.begin(), limits_.end(),
              [](const PossibleLimit& c, const PossibleLimit& d) { return c.p.squaredNorm() < d.p.squaredNorm(); });
    bool resolved = true;
    for (const PossibleLimit& limit : limits_) {
      if (!(limit.p.norm() < search_.upper)) break;
      // Its lines may stand for others beside them.
      if (!overlapAround(limit.p, limit.error + 2 * resolution_)) resolved &= tryLimit(limit, room);
    }
    return resolved;
  }

  /// Samples each sector between the lines through a point. False if a sector is too narrow to be certain of it: a free
  /// translation found there counts, but one that is not free may be so for lines that count as one.
  bool tryLimit(const PossibleLimit& limit, double most_room) {
    const Vec2& p = limit.p;
    rays_.clear();
    lines_.addRays(p, rays_);
    if (rays_.empty()) rays_.push_back({std::atan2(-p.y(), -p.x()), true, true});
    std::sort(rays_.begin(), rays_.end(), [](const auto& r, const auto& q) { return r.angle < q.angle; });
    bool resolved = true;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const BoundaryLines::LeavingLine &ray = rays_[i], &next = rays_[i + 1 < rays_.size() ? i + 1 : 0];
      if (!ray.left || !next.right) continue;
      const double gap = next.angle - ray.angle + (i + 1 < rays_.size() ? 0 : 2 * kPi);
      const double middle = ray.angle + gap / 2, width = std::sin(std::min(gap, kPi) / 2);
      const double room = lines_.roomBetween(p, ray, next, gap, most_room);
      resolved &= room * width >= 3 * resolution_;
      if (room * width < 3 * noise_) continue;
      const Vec2 way(std::cos(middle), std::sin(middle));
      Vec2 sample = p + room * way;
      if (!isFree(sample)) continue;
      for (double step = noise_ / width; step < room; step *= 2) {
        Vec2 beside = p + step * way;
        if (!isFree(beside)) continue;
        // Lines that count as one may bar the sector's tip: then it begins where it is first free.
        const bool from_tip = step * width <= 4 * noise_;
        improve(from_tip ? p : beside, beside, limit.error);
        return resolved;
      }
      improve(sample, sample);
      resolved = false;
    }
    return resolved;
  }

  TranslationSpace& space_;
  const std::size_t most_;
  const double noise_;
  /// Segments nearer to each other than this are one; slits between them are not seen.
  const double resolution_;
  BoundaryLines lines_;
  ShortestParting best_;
  BestFirst<Cell> search_;         ///< its upper bound is the length of the best limit
  double best_error_ = 0;          ///< what that may be off by
  std::size_t tries_ = 0;          ///< cells and translations
  std::vector<MeetingEdges> met_;  ///< edges that met after some translations, the last first
  std::vector<PossibleLimit> limits_;
  std::vector<BoundaryLines::LeavingLine> rays_;
  std::vector<BoundaryLines::Line> all_segments_;
  Segments segments_;  ///< near the cell
};

}  // namespace

ShortestParting searchShortestParting(TranslationSpace& space, const Vec2& known, const Vec2* last, std::size_t most) {
  return PartingSearch(space, known, most).run(last);
}

}  // namespace tricover::detail
