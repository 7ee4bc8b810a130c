// SPDX-License-Identifier: BSD-3-Clause
// The shortest parting translation is the nearest point of the closure of the free ones. That is 0's projection on a
// convolution segment, an end of one or a crossing of two (on the boundary of a free face of the segments' arrangement
// no other point is nearest), and which of these are limits of free translations the kernel tells, by samples beside
// them. Looking at all would cost (n m)^2, so the plane is searched from 0 outwards by square cells. A cell is done
// with where the kernel's clearance or depth at its centre reaches beyond it, where two edges meet on all of it, where
// no segment comes near it, and where few enough do for all their candidates to be tried; otherwise it is split in
// four, and edges that meet on part of it are tried first on its parts. Nearer cells are done with before farther ones,
// so the least distance of those left is a lower bound.
//
// Where few segments bound all of a deep overlap, they are gathered once, by the directions of edges, and each cell
// looks at those of the cell that it is a part of. Which side of a segment is free is known; so are the candidates
// whose way from 0 leads out of what bounds them, and the sectors beside them that may be free: no others are asked
// for.
//
// With a margin, what is free is farther from the segments than that, and bounded by lines beside them and by circles
// around their ends; the shortest translation ends at 0's projection on one of these, or where two cross.
//
// Segments within `resolution_` of each other are taken for one: outlines that run parallel but for rounding would make
// slivers without end. So a free slit narrower than twice that may be missed, and nothing else.
//
// Cost: a query of the kernel a cell, and one a sample. The cells are those of the disc of radius depth, as fine as the
// overlap is intricate there; in a long search those that a disc of a and one of b overlap on take no query. Where
// parts repeat, many pairs of edges make the same few segments: there a cell is covered by parallelograms, each of the
// translations at which two edges meet, instead of gathering all pairs. Measured (processor time, median) on the
// paper's polygons of size 100, overlapping by 0.5 / by 30 on the mean: contour of 64 vertices 25 / 250 us, with hole
// 23 / 170 us, starred 45 us / 1 ms; of 256 vertices 75 us / 2.2 ms, 50 us / 0.7 ms, 125 us / 6 ms. Worst case:
// outlines that are nearly parallel by more than the resolution over a long way, as combs turned by 1e-9 against each
// other are, need cells as small as their gaps are narrow; only the number of
// translations ends that.
#include "contact/translation_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include "contact/boundary_curves.h"
#include "contact/uncovered.h"
#include "numbers/segment.h"
#include "pair/collide_by_hierarchy.h"

namespace tricover::detail {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDiagonal = 1.4142135623730951;
/// A search of more queries than this goes on with both regions covered by discs, if inner discs of both overlapped in
/// one of them: otherwise what is searched is too shallow, or the regions too thin, for discs to hold much of it.
constexpr std::size_t kLong = 10;
/// So many pairs of edges that meet near a cell are kept for its parts.
constexpr std::size_t kMostMeetings = 32;
/// Beyond so many segments on lines that are known already, a cell is tried to be covered; by about so many
/// parallelograms.
constexpr std::size_t kMostRepeated = 128;
constexpr int kMostTries = 24;
/// A cell is decided by no more curves than these: fewer where gathering them costs as much as anything.
constexpr std::size_t kMostInherited = 24, kMostGathered = 12;
/// How far beyond a cell's circumcircle its segments are gathered, so that samples around a point of it are understood.
constexpr double kSurroundings = 1.25;

using MeetingEdges = TranslationSpace::MeetingEdges;
using Meetings = std::vector<MeetingEdges>;
using Segments = std::vector<BoundaryCurves::Line>;

/// What a cell leaves to its parts: all that may hold one of them, or come near it.
struct Legacy {
  std::shared_ptr<const DiscSums> sums;  ///< null: all of them
  Meetings meetings;
  Segments segments;
  bool knows_segments;  ///< or else nobody has looked
};

struct Cell {
  double least;  ///< distance of 0
  Vec2 center;
  double half;
  std::shared_ptr<const Legacy> legacy;
};
struct Farther {
  bool operator()(const Cell& c, const Cell& d) const { return c.least > d.least; }
};

Cell makeCell(const Vec2& center, double half, std::shared_ptr<const Legacy> legacy) {
  return {std::hypot(std::max(std::abs(center.x()) - half, 0.0), std::max(std::abs(center.y()) - half, 0.0)), center,
          half, std::move(legacy)};
}

/// Where a free face of the lines' arrangement may be nearest to 0.
struct PossibleLimit {
  Vec2 p;
  double error;  ///< of p, along the lines that cross there
};

class PartingSearch {
  using Ray = BoundaryCurves::Ray;

 public:
  PartingSearch(TranslationSpace& space, const Vec2& known, double error, std::size_t most)
      : space_(space),
        enough_(1 / (1 + error)),
        most_(most),
        margin_(space.margin()),
        options_{margin_ * space.unit(), 0},
        resolution_(16 * space.noise()),
        curves_(margin_, space.noise(), resolution_),
        found_{known, known, 0},
        upper_(known.norm()) {}

  ShortestParting run() {
    std::priority_queue<Cell, std::vector<Cell>, Farther> cells;
    auto all_sums = std::make_shared<const DiscSums>();
    bool are_covered = false;
    cells.push(makeCell(Vec2::Zero(), upper_ * (1 + 0x1p-20),
                        std::make_shared<const Legacy>(Legacy{nullptr, {}, segmentsOfFew(), space_.areFew()})));
    while (!cells.empty() && cells.top().least < enough_ * upper_) {
      const Cell cell = cells.top();
      found_.lower_bound = std::max(found_.lower_bound, cell.least);
      if (queries_ >= most_) return found_;
      cells.pop();
      if (queries_ > kLong && discs_overlap_ && !are_covered) {
        are_covered = true;
        all_sums = std::make_shared<const DiscSums>(space_.discSums());
      }
      auto sums = cell.legacy->sums != nullptr ? cell.legacy->sums : all_sums;
      if (decide(cell, *sums)) continue;
      const double half = cell.half / 2, radius = cell.half * kDiagonal;
      if (sums->areMany())
        sums = std::make_shared<const DiscSums>(sums->near(cell.center, radius));
      else if (!are_covered)
        sums = nullptr;
      const bool knows_segments = cell.legacy->knows_segments;
      const auto legacy = std::make_shared<const Legacy>(
          Legacy{std::move(sums), near_, knows_segments ? segments_ : Segments(), knows_segments});
      for (const Vec2& way : {Vec2(-half, -half), Vec2(half, -half), Vec2(-half, half), Vec2(half, half)}) {
        Cell part = makeCell(cell.center + way, half, legacy);
        if (part.least < upper_) cells.push(std::move(part));
      }
    }
    const double left = cells.empty() ? upper_ : cells.top().least;
    found_.lower_bound = std::max(0.0, std::min(left, upper_ - resolution_ - error_));
    return found_;
  }

 private:
  /// How far translations may differ from the pair's without a change, from a length in a's frame.
  double inUnits(const PosedPair& pair, double length) const {
    return roundedDown<2>(length * (1 - pair.scale_defect)) / space_.unit();
  }

  /// How far the translation t may change until two edges are farther apart than the margin, at least.
  double depthOf(const PosedPair& pair, const Vec2& t, std::size_t i, std::size_t j) const {
    const double depth = inUnits(pair, crossingDepth(pair, i, j));
    if (margin_ == 0) return depth;
    return depth > 0 ? depth + margin_ - 4 * space_.noise() : margin_ - space_.gap(t, i, j) - 4 * space_.noise();
  }
  double depthOf(const MeetingEdges& meeting, const Vec2& t) const {
    const double depth = meeting.depth(t) - 4 * space_.noise();
    if (margin_ == 0 || depth > 0 || depth < -margin_) return depth + margin_;
    return margin_ - space_.gap(t, meeting.edge_a, meeting.edge_b) - 4 * space_.noise();
  }
  double depthOf(const PosedPair& pair, const Vec2& t, const Outcome& outcome) const {
    if (outcome.edge_a >= 0 && outcome.edge_b >= 0)
      return depthOf(pair, t, static_cast<std::size_t>(outcome.edge_a), static_cast<std::size_t>(outcome.edge_b));
    // Boxes within the margin tell of no depth.
    if (outcome.edge_a < 0 && outcome.edge_b < 0 && outcome.clearance == 0) return 0;
    return inUnits(pair, outcome.clearance) + margin_ * (1 - 0x1p-40);
  }

  void improve(const Vec2& limit, const Vec2& parting, double error = 0) {
    const double length = limit.norm();
    if (!(length < upper_)) return;
    upper_ = length;
    error_ = error;
    found_.limit = limit;
    found_.parting = parting;
  }

  /// Whether one of the meetings that are kept holds all within `radius` of t. Who asks next asks nearby.
  bool overlapAround(const Vec2& t, double radius) {
    for (MeetingEdges& meeting : near_) {
      if (depthOf(meeting, t) <= radius) continue;
      std::swap(meeting, near_.front());
      return true;
    }
    return false;
  }

  /// The edges that meet.
  void keep(const Outcome& outcome) {
    if (outcome.edge_a >= 0 && outcome.edge_b >= 0 && near_.size() < kMostMeetings)
      near_.push_back(
          space_.meetingOf(static_cast<std::size_t>(outcome.edge_a), static_cast<std::size_t>(outcome.edge_b)));
  }

  bool isFree(Vec2& t) {
    if (overlapAround(t, 0)) return false;
    ++queries_;
    const Outcome outcome = collideByHierarchy(space_.at(t), options_, 0, Wanted::Answer);
    if (outcome.collides) keep(outcome);
    return !outcome.collides;
  }

  /// Whether nothing shorter than the best is left to be found in the cell.
  bool decide(const Cell& cell, const DiscSums& sums) {
    ++queries_;
    const double radius = cell.half * kDiagonal * (1 + 0x1p-40);
    near_.clear();
    if (sums.hold(cell.center, radius)) return true;
    overlaps_ = false;
    for (const MeetingEdges& meeting : cell.legacy->meetings)
      if (see(meeting, cell.center, radius)) return true;
    if (cell.half <= resolution_) return true;
    // A cell that holds a free translation isn't covered.
    const bool holds_limit = (found_.limit - cell.center).lpNorm<Eigen::Infinity>() <= cell.half;
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    Gathered gathered = Gathered::Many;
    const bool knows_segments = cell.legacy->knows_segments;
    if (knows_segments) gathered = filter(cell, radius, holds_limit ? kAll : kMostRepeated);
    if (gathered != Gathered::Lines && !overlaps_ && ask(cell.center, radius)) return true;
    if (!knows_segments)
      gathered = gather(cell, radius, holds_limit ? kAll : kMostRepeated);
    else if (gathered != Gathered::Lines && meetAround(cell.center, radius))
      return true;
    if (gathered == Gathered::Repeated) {
      switch (cover(cell)) {
        case Cover::Whole:
          return true;
        case Cover::Most:
          return false;
        case Cover::Little:
          gathered = knows_segments ? filter(cell, radius, kAll) : gather(cell, radius, kAll);
      }
    }
    if (gathered != Gathered::Lines) return gathered == Gathered::Deep;
    // No line: the answer at the centre is that of the whole cell.
    return curves_.isEmpty() || decideByCurves(cell, radius);
  }

  /// Whether two edges meet after all translations within `radius` of t; if they may after some, they are kept.
  bool see(const MeetingEdges& meeting, const Vec2& t, double radius) {
    const double depth = depthOf(meeting, t);
    overlaps_ |= depth > 0;
    if (depth > -radius && near_.size() < kMostMeetings) near_.push_back(meeting);
    return depth >= radius;
  }

  /// Whether two edges that meet after the translation t do so after all within `radius`.
  bool meetAround(const Vec2& center, double radius) {
    Vec2 t = center;
    bool held = false;
    forEachPair(space_.at(t), 0, [&](double gap, std::size_t i, std::size_t j) {
      held = gap <= 0 && see(space_.meetingOf(i, j), center, radius);
      return held ? -1.0 : 0.0;
    });
    return held;
  }

  /// Whether the kernel's answer at a cell's centre is that of the whole cell.
  bool ask(const Vec2& center, double radius) {
    Vec2 t = center;
    const PosedPair pair = space_.at(t);
    radius += (t - center).norm() * (1 + 0x1p-40);
    const Outcome outcome =
        collideByHierarchy(pair, options_, pair.reach(2 * radius * space_.unit()), Wanted::Clearance);
    if (outcome.collides) {
      discs_overlap_ = discs_overlap_ || (outcome.edge_a < 0 && outcome.clearance > 0);
      keep(outcome);
      return depthOf(pair, t, outcome) >= radius;
    }
    const double clearance = inUnits(pair, outcome.clearance) - margin_, length = t.norm();
    const double back = std::clamp(clearance - space_.noise(), 0.0, length);
    const Vec2 nearest = length > 0 ? Vec2(t * (1 - back / length)) : t;
    improve(nearest, nearest);
    return clearance >= radius;
  }

  /// All segments of the search, unless they are many.
  Segments segmentsOfFew() {
    Segments all;
    if (!space_.areFew()) return all;
    for (const TranslationSpace::Segment& segment : space_.segmentsWithin(kSurroundings * upper_ + margin_))
      all.emplace_back(BoundaryCurves::Ends{segment.v, segment.w}, segment.both_sides, space_.noise());
    return all;
  }

  enum class Gathered { Lines, Deep, Many, Repeated };
  /// gather() from a cell's segments.
  Gathered filter(const Cell& cell, double radius, std::size_t most) {
    Gathered result = Gathered::Lines;
    std::size_t repeated = 0;
    curves_.clear(kMostInherited);
    const double around = kSurroundings * radius;
    segments_.clear();
    for (const BoundaryCurves::Line& segment : cell.legacy->segments)
      if (segment.comesNear(cell.center, around + margin_)) segments_.push_back(segment);
    for (const BoundaryCurves::Line& segment : segments_) {
      curves_.add(segment, cell.center, around, [&](BoundaryCurves::Added added) {
        if (added == BoundaryCurves::Repeated && ++repeated > most) result = Gathered::Repeated;
        if (added == BoundaryCurves::TooMany) result = Gathered::Many;
      });
      if (result != Gathered::Lines) break;
    }
    return result;
  }

  /// All lines around a cell; or why it is divided: they are too many, or more segments than `most` have been on lines
  /// that were known.
  Gathered gather(const Cell& cell, double radius, std::size_t most) {
    Gathered result = Gathered::Lines;
    std::size_t repeated = 0;
    curves_.clear(kMostGathered);
    const auto note = [&](BoundaryCurves::Added added) {
      if (added == BoundaryCurves::Repeated && ++repeated > most) result = Gathered::Repeated;
      if (added == BoundaryCurves::TooMany) result = Gathered::Many;
    };
    Vec2 t = cell.center;
    const PosedPair pair = space_.at(t);
    const double around = kSurroundings * radius + (t - cell.center).norm();
    space_.forEachSegment(
        pair, t, around + margin_,
        [&](const MeetingEdges& meeting) {
          if (see(meeting, cell.center, radius)) result = Gathered::Deep;
          return result == Gathered::Lines;
        },
        [&](const TranslationSpace::Segment& segment) {
          curves_.add({{segment.v, segment.w}, segment.both_sides, space_.noise()}, t, around, note);
          return result == Gathered::Lines;
        });
    return result;
  }

  /// Whether parallelograms, each of the translations that let two edges meet, cover a cell to within the resolution:
  /// for where many pairs of edges make few lines, as outlines with repeated parts do. One query each; it is given up
  /// where they cover too little for that.
  enum class Cover { Whole, Most, Little };
  Cover cover(const Cell& cell) {
    Uncovered rest(cell.center, cell.half, resolution_);
    const double whole = rest.area();
    for (int tries = 1; !rest.isEmpty(); ++tries) {
      ++queries_;
      Vec2 t = rest.point();
      const PosedPair pair = space_.at(t);
      const Outcome outcome = collideByHierarchy(pair, options_, 0, Wanted::Clearance);
      if (!outcome.collides) return Cover::Little;
      if (outcome.edge_a >= 0 && outcome.edge_b >= 0) {
        rest.takeAway(
            space_.meetings(static_cast<std::size_t>(outcome.edge_a), static_cast<std::size_t>(outcome.edge_b)));
      } else {
        const double half = inUnits(pair, outcome.clearance) / kDiagonal;
        rest.takeAway({t + Vec2(-half, -half), t + Vec2(half, -half), t + Vec2(half, half), t + Vec2(-half, half)});
      }
      if (whole - rest.area() < whole * tries / kMostTries)
        return rest.area() < whole / 2 ? Cover::Most : Cover::Little;
    }
    return Cover::Whole;
  }

  /// The nearest point of a free face of the curves' arrangement is the nearest point, an end or a crossing of them.
  bool decideByCurves(const Cell& cell, double radius) {
    limits_.clear();
    const auto isWanted = [&](const Vec2& p) {
      return (p - cell.center).lpNorm<Eigen::Infinity>() <= cell.half + resolution_ && p.norm() < upper_;
    };
    const auto offer = [&](const Vec2& p, double error) {
      if (!isWanted(p)) return;
      for (const PossibleLimit& other : limits_)
        if ((p - other.p).norm() <= space_.noise()) return;
      limits_.push_back({p, error});
    };
    bool resolved = true;
    curves_.forEachPossibleLimit(offer, [&](const Vec2& p, const Vec2& along) {
      if (isWanted(p)) resolved = decideTouch(p, along, radius) && resolved;
    });
    std::sort(limits_.begin(), limits_.end(),
              [](const PossibleLimit& c, const PossibleLimit& d) { return c.p.squaredNorm() < d.p.squaredNorm(); });
    for (const PossibleLimit& limit : limits_) {
      if (!(limit.p.norm() < upper_)) break;
      // Its lines may stand for others beside them.
      if (overlapAround(limit.p, limit.error + 2 * resolution_)) continue;
      resolved &= decideLimit(limit, radius);
    }
    return resolved;
  }

  /// Samples the two cusps that circles, or a circle and a line, leave where they touch: at s along them they are
  /// s^2 / (2 margin) wide, and what is narrower than some resolutions isn't seen. False if they are yet to be found.
  bool decideTouch(const Vec2& p, const Vec2& along, double radius) {
    const double first = std::max(8 * std::sqrt(resolution_ * margin_), resolution_);  // the product may underflow
    for (const Vec2& way : {along, Vec2(-along)})
      for (double step = first; step < 0.2 * radius; step *= 2) {
        Vec2 sample = p + step * way;
        if (!isFree(sample)) continue;
        improve(sample, sample);
        break;
      }
    return first >= 0.2 * radius || !(p.norm() + first < upper_);
  }

  /// Samples each sector between the curves through p. False if one is too narrow to be certain of it: what is free
  /// there is found, and what isn't may be so for curves that are taken for one.
  bool decideLimit(const PossibleLimit& limit, double radius) {
    const Vec2& p = limit.p;
    double room = 0.2 * radius;
    rays_.clear();
    const bool is_curved = curves_.addRays(p, rays_, room);
    if (rays_.empty()) rays_.push_back({std::atan2(-p.y(), -p.x()), true, true});
    std::sort(rays_.begin(), rays_.end(), [](const Ray& r, const Ray& q) { return r.angle < q.angle; });
    bool resolved = true;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const Ray &ray = rays_[i], &next = rays_[i + 1 < rays_.size() ? i + 1 : 0];
      if (!ray.left || !next.right) continue;
      const double gap = next.angle - ray.angle + (i + 1 < rays_.size() ? 0 : 2 * kPi);
      const double middle = ray.angle + gap / 2, width = std::sin(std::min(gap, kPi) / 2);
      // On a way s a circle leaves its tangent by s^2 / (2 margin): no more than half of the sector's width.
      const double reach = is_curved ? std::min(room, margin_ * width) : room;
      resolved &= reach * width >= 3 * resolution_;
      if (reach * width < 3 * space_.noise()) continue;
      const Vec2 way(std::cos(middle), std::sin(middle));
      Vec2 sample = p + reach * way;
      if (!isFree(sample)) continue;
      for (double step = space_.noise() / width; step < reach; step *= 2) {
        Vec2 beside = p + step * way;
        if (!isFree(beside)) continue;
        improve(p, beside, limit.error);
        return resolved;
      }
      improve(sample, sample);
      resolved = false;
    }
    return resolved;
  }

  TranslationSpace& space_;
  const double enough_;  ///< of the limit's length, as a lower bound
  const std::size_t most_;
  const double margin_;
  const CollideOptions options_;
  /// Segments nearer to each other than this are one; slits between them are not seen.
  const double resolution_;
  BoundaryCurves curves_;
  ShortestParting found_;
  double upper_, error_ = 0;
  std::size_t queries_ = 0;
  Meetings near_;      ///< that may hold parts of the cell
  Segments segments_;  ///< near the cell
  bool overlaps_ = false;
  bool discs_overlap_ = false;  ///< after some translation that was asked

  std::vector<PossibleLimit> limits_;
  std::vector<Ray> rays_;
};

}  // namespace

ShortestParting searchShortestParting(TranslationSpace& space, const Vec2& known, double error, std::size_t most) {
  return PartingSearch(space, known, error, most).run();
}

}  // namespace tricover::detail
