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
#include "contact/parting_limits.h"
#include "contact/translation_probe.h"
#include "contact/uncovered.h"

namespace tricover::detail {
namespace {

constexpr double kDiagonal = 1.4142135623730951;
/// A search of more queries than this goes on with both regions covered by discs, if inner discs of both overlapped in
/// one of them: otherwise what is searched is too shallow, or the regions too thin, for discs to hold much of it.
constexpr std::size_t kLong = 10;
/// Beyond so many segments on lines that are known already, a cell is tried to be covered; by about so many
/// parallelograms.
constexpr std::size_t kMostRepeated = 128;
constexpr int kMostTries = 24;
/// A cell is decided by no more curves than these: fewer where gathering them costs as much as anything.
constexpr std::size_t kMostInherited = 24, kMostGathered = 12;
/// How far beyond a cell's circumcircle its segments are gathered, so that samples around a point of it are understood.
constexpr double kSurroundings = 1.25;

using MeetingEdges = TranslationSpace::MeetingEdges;
using Segments = std::vector<BoundaryCurves::Line>;

/// What a cell leaves to its parts: all that may hold one of them, or come near it.
struct Legacy {
  std::shared_ptr<const DiscSums> sums;  ///< null: all of them
  std::vector<MeetingEdges> meetings;
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

class PartingSearch {
 public:
  PartingSearch(TranslationSpace& space, const Vec2& known, double error, std::size_t most)
      : space_(space),
        enough_(1 / (1 + error)),
        most_(most),
        margin_(space.margin()),
        resolution_(16 * space.noise()),
        curves_(margin_, space.noise(), resolution_),
        probe_(space),
        limits_(space, resolution_),
        best_{{known, known, 0}, known.norm()} {}

  ShortestParting run() {
    std::priority_queue<Cell, std::vector<Cell>, Farther> cells;
    auto all_sums = std::make_shared<const DiscSums>();
    bool are_covered = false;
    cells.push(makeCell(Vec2::Zero(), best_.length * (1 + 0x1p-20),
                        std::make_shared<const Legacy>(Legacy{nullptr, {}, segmentsOfFew(), space_.areFew()})));
    while (!cells.empty() && cells.top().least < enough_ * best_.length) {
      const Cell cell = cells.top();
      best_.found.lower_bound = std::max(best_.found.lower_bound, cell.least);
      if (probe_.queries() >= most_) return best_.found;
      cells.pop();
      if (probe_.queries() > kLong && discs_overlap_ && !are_covered) {
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
          Legacy{std::move(sums), probe_.meetings(), knows_segments ? segments_ : Segments(), knows_segments});
      for (const Vec2& way : {Vec2(-half, -half), Vec2(half, -half), Vec2(-half, half), Vec2(half, half)}) {
        Cell part = makeCell(cell.center + way, half, legacy);
        if (part.least < best_.length) cells.push(std::move(part));
      }
    }
    const double left = cells.empty() ? best_.length : cells.top().least;
    best_.found.lower_bound = std::max(0.0, std::min(left, best_.length - resolution_ - best_.error));
    return best_.found;
  }

 private:
  /// Whether nothing shorter than the best is left to be found in the cell.
  bool decide(const Cell& cell, const DiscSums& sums) {
    probe_.countQuery();
    const double radius = cell.half * kDiagonal * (1 + 0x1p-40);
    probe_.leave();
    if (sums.hold(cell.center, radius)) return true;
    for (const MeetingEdges& meeting : cell.legacy->meetings)
      if (probe_.see(meeting, cell.center, radius)) return true;
    if (cell.half <= resolution_) return true;
    // A cell that holds a free translation isn't covered.
    const bool holds_limit = (best_.found.limit - cell.center).lpNorm<Eigen::Infinity>() <= cell.half;
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    const bool knows_segments = cell.legacy->knows_segments;
    const auto curvesAround = [&](std::size_t most) {
      return knows_segments ? filter(cell, radius, most) : gather(cell, radius, most);
    };
    const std::size_t most = holds_limit ? kAll : kMostRepeated;
    Gathered gathered = knows_segments ? curvesAround(most) : Gathered::Many;
    if (gathered != Gathered::Lines && !probe_.overlaps() && ask(cell.center, radius)) return true;
    if (!knows_segments) gathered = curvesAround(most);
    if (knows_segments && gathered != Gathered::Lines && probe_.meetAround(cell.center, radius)) return true;
    if (gathered == Gathered::Repeated) {
      switch (cover(cell)) {
        case Cover::Whole:
          return true;
        case Cover::Most:
          return false;
        case Cover::Little:
          gathered = curvesAround(kAll);
      }
    }
    if (gathered != Gathered::Lines) return gathered == Gathered::Deep;
    // No line: the answer at the centre is that of the whole cell.
    return curves_.isEmpty() || limits_.find(curves_, cell.center, cell.half, radius, probe_, best_);
  }

  /// Whether the kernel's answer at a cell's centre is that of the whole cell.
  bool ask(const Vec2& center, double radius) {
    Vec2 t = center;
    const PosedPair pair = space_.at(t);
    radius += (t - center).norm() * (1 + 0x1p-40);
    const Outcome outcome = probe_.ask(pair, pair.reach(2 * radius * space_.unit()));
    if (outcome.collides) {
      discs_overlap_ = discs_overlap_ || (outcome.edge_a < 0 && outcome.clearance > 0);
      probe_.keep(outcome);
      return probe_.depthOf(pair, t, outcome) >= radius;
    }
    const double clearance = probe_.inUnits(pair, outcome.clearance) - margin_, length = t.norm();
    const double back = std::clamp(clearance - space_.noise(), 0.0, length);
    const Vec2 nearest = length > 0 ? Vec2(t * (1 - back / length)) : t;
    best_.improve(nearest, nearest);
    return clearance >= radius;
  }

  /// All segments of the search, unless they are many.
  Segments segmentsOfFew() {
    Segments all;
    if (!space_.areFew()) return all;
    for (const TranslationSpace::Segment& segment : space_.segmentsWithin(kSurroundings * best_.length + margin_))
      all.emplace_back(BoundaryCurves::Ends{segment.v, segment.w}, segment.both_sides, space_.noise());
    return all;
  }

  enum class Gathered { Lines, Deep, Many, Repeated };
  /// What has come of the curves around a cell: why it is divided, if they are too many, or more than `most` have been
  /// there already.
  struct Tally {
    std::size_t most;
    Gathered result = Gathered::Lines;
    std::size_t repeated = 0;

    void operator()(BoundaryCurves::Added added) {
      if (added == BoundaryCurves::Repeated && ++repeated > most) result = Gathered::Repeated;
      if (added == BoundaryCurves::TooMany) result = Gathered::Many;
    }
    bool goesOn() const { return result == Gathered::Lines; }
  };

  /// gather() from a cell's segments.
  Gathered filter(const Cell& cell, double radius, std::size_t most) {
    Tally tally{most};
    curves_.clear(kMostInherited);
    const double around = kSurroundings * radius;
    segments_.clear();
    for (const BoundaryCurves::Line& segment : cell.legacy->segments)
      if (segment.comesNear(cell.center, around + margin_)) segments_.push_back(segment);
    for (std::size_t k = 0; k < segments_.size() && tally.goesOn(); ++k)
      curves_.add(segments_[k], cell.center, around, tally);
    return tally.result;
  }

  /// All lines around a cell; or why it is divided.
  Gathered gather(const Cell& cell, double radius, std::size_t most) {
    Tally tally{most};
    curves_.clear(kMostGathered);
    Vec2 t = cell.center;
    const PosedPair pair = space_.at(t);
    const double around = kSurroundings * radius + (t - cell.center).norm();
    space_.forEachSegment(
        pair, t, around + margin_,
        [&](const MeetingEdges& meeting) {
          if (probe_.see(meeting, cell.center, radius)) tally.result = Gathered::Deep;
          return tally.goesOn();
        },
        [&](const TranslationSpace::Segment& segment) {
          curves_.add({{segment.v, segment.w}, segment.both_sides, space_.noise()}, t, around, tally);
          return tally.goesOn();
        });
    return tally.result;
  }

  /// Whether parallelograms, each of the translations that let two edges meet, cover a cell to within the resolution:
  /// for where many pairs of edges make few lines, as outlines with repeated parts do. One query each; it is given up
  /// where they cover too little for that.
  enum class Cover { Whole, Most, Little };
  Cover cover(const Cell& cell) {
    Uncovered rest(cell.center, cell.half, resolution_);
    const double whole = rest.area();
    for (int tries = 1; !rest.isEmpty(); ++tries) {
      probe_.countQuery();
      Vec2 t = rest.point();
      const PosedPair pair = space_.at(t);
      const Outcome outcome = probe_.ask(pair, 0);
      if (!outcome.collides) return Cover::Little;
      if (outcome.edge_a >= 0 && outcome.edge_b >= 0) {
        rest.takeAway(
            space_.meetings(static_cast<std::size_t>(outcome.edge_a), static_cast<std::size_t>(outcome.edge_b)));
      } else {
        const double half = probe_.inUnits(pair, outcome.clearance) / kDiagonal;
        rest.takeAway({t + Vec2(-half, -half), t + Vec2(half, -half), t + Vec2(half, half), t + Vec2(-half, half)});
      }
      if (whole - rest.area() < whole * tries / kMostTries)
        return rest.area() < whole / 2 ? Cover::Most : Cover::Little;
    }
    return Cover::Whole;
  }

  TranslationSpace& space_;
  const double enough_;  ///< of the limit's length, as a lower bound
  const std::size_t most_;
  const double margin_;
  /// Segments nearer to each other than this are one; slits between them are not seen.
  const double resolution_;
  BoundaryCurves curves_;
  TranslationProbe probe_;
  PartingLimits limits_;
  BestParting best_;
  Segments segments_;           ///< near the cell
  bool discs_overlap_ = false;  ///< after some translation that was asked for
};

}  // namespace

ShortestParting searchShortestParting(TranslationSpace& space, const Vec2& known, double error, std::size_t most) {
  return PartingSearch(space, known, error, most).run();
}

}  // namespace tricover::detail
