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
// Where few segments bound all of a deep overlap, they are gathered once, by the directions of edges, but for those
// that lie where inner discs of both overlap; and each cell looks at those of the cell that it is a part of. Which side
// of a segment is free is known; so are the candidates whose way from 0 leads out of what bounds them, and the sectors
// beside them that may be free: no others are asked for.
//
// Segments within `resolution_` of each other are taken for one: outlines that run parallel but for rounding would make
// slivers without end. So a free slit narrower than twice that may be missed, and nothing else.
//
// Cost: a query of the kernel a cell, and one a sample. The cells are those of the disc of radius depth, as fine as the
// overlap is intricate there; in a long search those that a disc of a and one of b overlap on take no query. Worst
// case: outlines that are nearly parallel by more than the resolution over a long way, as combs turned by 1e-9 against
// each other are, need cells as small as their gaps are narrow; only the number of translations ends that.
#include "contact/translation_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include "contact/boundary_lines.h"
#include "contact/parting_limits.h"
#include "contact/translation_probe.h"

namespace tricover::detail {
namespace {

constexpr double kDiagonal = 1.4142135623730951;
/// A search of more queries than this goes on with both regions covered by discs, if inner discs of both overlapped in
/// one of them: otherwise what is searched is too shallow, or the regions too thin, for discs to hold much of it.
constexpr std::size_t kLong = 10;
/// A cell is decided by no more lines than these: fewer where gathering them costs as much as anything, unless it is
/// so small a part of what is searched that it may be one point they cross in.
constexpr std::size_t kMostInherited = 24, kMostGathered = 6;
constexpr double kSmall = 0x1p-8;
/// How far beyond a cell its segments are gathered, so that samples around a point of it are understood: a share of the
/// radius of its circumcircle, and beside small cells so many resolutions, since a sector shows whether it is free only
/// where it is a few of them wide.
constexpr double kSurroundings = 0x1p-5, kLeastSurroundings = 64;

using MeetingEdges = TranslationSpace::MeetingEdges;

/// One of the search's segments, and the box around it: its middle and half its sides.
struct NearSegment {
  float x, y, wide, high;
  std::uint32_t number;
};
using Segments = std::vector<NearSegment>;

/// The sides are rounded up by more than what its place loses as floats: half a unit of 2^-23 in either coordinate.
NearSegment nearSegment(const BoundaryLines::Line& line, std::size_t number) {
  const Vec2 middle = 0.5 * (line.v + line.w);
  const Vec2 half =
      ((0.5 * (line.w - line.v)).cwiseAbs() + Vec2::Constant(0x1p-22 * middle.lpNorm<1>())) * (1 + 0x1p-20);
  return {static_cast<float>(middle.x()), static_cast<float>(middle.y()), static_cast<float>(half.x()),
          static_cast<float>(half.y()), static_cast<std::uint32_t>(number)};
}

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
  PartingSearch(TranslationSpace& space, const Vec2& known, std::size_t most)
      : space_(space),
        most_(most),
        resolution_(16 * space.noise()),
        lines_(space.noise(), resolution_),
        probe_(space),
        limits_(space, resolution_),
        best_{{known, known, 0}, known.norm()} {}

  /// last: null, or where the last search ended.
  ShortestParting run(const Vec2* last) {
    space_.prepareSearch(best_.length);
    if (last != nullptr) tryFirst(*last);
    auto all_sums = std::make_shared<const DiscSums>();
    bool are_covered = false;
    begin();
    while (!cells_.empty() && cells_.top().least < best_.length) {
      const Cell cell = cells_.top();
      best_.found.lower_bound = std::max(best_.found.lower_bound, cell.least);
      if (probe_.queries() >= most_) return best_.found;
      cells_.pop();
      if (probe_.queries() > kLong && discs_overlap_ && !are_covered) {
        are_covered = true;
        all_sums = std::make_shared<const DiscSums>(space_.discSums());
      }
      auto sums = cell.legacy->sums != nullptr ? cell.legacy->sums : all_sums;
      if (isDone(cell, *sums)) continue;
      if (sums->areMany())
        sums = std::make_shared<const DiscSums>(sums->near(cell.center, cell.half * kDiagonal));
      else if (!are_covered)
        sums = nullptr;
      const bool knows_segments = cell.legacy->knows_segments;
      divide(cell, std::make_shared<const Legacy>(Legacy{std::move(sums), probe_.meetings(),
                                                         knows_segments ? segments_ : Segments(), knows_segments}));
    }
    const double left = cells_.empty() ? best_.length : cells_.top().least;
    best_.found.lower_bound = std::max(0.0, std::min(left, best_.length - resolution_ - best_.error));
    return best_.found;
  }

 private:
  /// Tries a little farther, too, because the polygons may have rotated since.
  void tryFirst(const Vec2& last) {
    for (const double farther : {1.0, 1.01, 1.05}) {
      Vec2 t = farther * last;
      if (!(t.norm() < best_.length)) return;
      if (probe_.isFree(t)) return best_.improve(t, t);
    }
  }

  void begin() {
    const double half = best_.length * (1 + 0x1p-20);
    const bool knows_segments = space_.areFew();
    add(makeCell(Vec2::Zero(), half,
                 std::make_shared<const Legacy>(
                     Legacy{nullptr, {}, knows_segments ? segmentsAround(half) : Segments(), knows_segments})));
  }

  void add(Cell cell) {
    if (cell.least < best_.length) cells_.push(std::move(cell));
  }

  void divide(const Cell& cell, const std::shared_ptr<const Legacy>& legacy) {
    const double half = cell.half / 2;
    for (const Vec2& way : {Vec2(-half, -half), Vec2(half, -half), Vec2(-half, half), Vec2(half, half)})
      add(makeCell(cell.center + way, half, legacy));
  }

  /// Whether a cell holds no limit that is shorter than the best.
  bool isDone(const Cell& cell, const DiscSums& sums) {
    probe_.countQuery();
    const double radius = cell.half * kDiagonal * (1 + 0x1p-40);
    probe_.leave();
    if (sums.hold(cell.center, radius)) return true;
    for (const MeetingEdges& meeting : cell.legacy->meetings)
      if (probe_.see(meeting, cell.center, radius)) return true;
    if (cell.half <= resolution_) return true;
    const bool knows_segments = cell.legacy->knows_segments;
    Gathered gathered = knows_segments ? filter(cell, radius) : Gathered::Many;
    // Among many segments what meets in the middle seldom decides.
    const bool passes = knows_segments && gathered == Gathered::Many && discs_overlap_;
    if (gathered != Gathered::Lines && !passes && !probe_.overlaps() && decidesAll(cell.center, radius)) return true;
    if (!knows_segments) gathered = gather(cell, radius);
    if (gathered != Gathered::Lines) return gathered == Gathered::Deep;
    // Without a line the answer at the centre is that of the whole cell.
    return lines_.isEmpty() || limits_.find(lines_, cell.center, cell.half, surroundings(radius), probe_, best_);
  }

  /// Whether the kernel's answer at a cell's centre is that of the whole cell.
  bool decidesAll(const Vec2& center, double radius) {
    Vec2 t = center;
    const PosedPair pair = space_.at(t);
    radius += (t - center).norm() * (1 + 0x1p-40);
    const Outcome outcome = probe_.ask(pair, 2 * radius * space_.unit());
    if (outcome.collides) {
      discs_overlap_ = discs_overlap_ || (outcome.edge_a < 0 && outcome.clearance > 0);
      probe_.keep(outcome);
      return probe_.depthOf(pair, outcome) >= radius;
    }
    const double clearance = probe_.inUnits(outcome.clearance), length = t.norm();
    const double back = std::clamp(clearance - space_.noise(), 0.0, length);
    const Vec2 nearest = length > 0 ? Vec2(t * (1 - back / length)) : t;
    best_.improve(nearest, nearest);
    return clearance >= radius;
  }

  double surroundings(double radius) const {
    return std::max(kSurroundings * radius, kLeastSurroundings * resolution_);
  }
  /// To where, from a cell's centre, its lines are cut.
  double cutAt(double radius) const { return radius + 2 * surroundings(radius); }

  /// All segments that a search by squares of such a half side needs.
  Segments segmentsAround(double half) {
    for (const TranslationSpace::Segment& s : space_.segmentsWithin(best_.length + surroundings(2 * half)))
      all_segments_.emplace_back(BoundaryLines::Ends{s.v, s.w}, s.both_sides, space_.noise());
    Segments all;
    all.reserve(all_segments_.size());
    for (const BoundaryLines::Line& line : all_segments_) all.push_back(nearSegment(line, all.size()));
    return all;
  }

  enum class Gathered { Lines, Deep, Many };

  /// Keeps those of the segments that may come near a cell that do.
  void narrow(const Cell& cell, double radius) {
    const double around = cell.half + surroundings(radius);
    const auto x = static_cast<float>(cell.center.x()), y = static_cast<float>(cell.center.y());
    const auto rounded = static_cast<float>((around + 0x1p-22 * cell.center.lpNorm<1>()) * (1 + 0x1p-20));
    // Without branches, as none could be predicted.
    segments_.resize(cell.legacy->segments.size());
    NearSegment* end = segments_.data();
    for (const NearSegment& segment : cell.legacy->segments) {
      const float dx = std::abs(segment.x - x), dy = std::abs(segment.y - y);
      *end = segment;
      end += !((dx > segment.wide + rounded) | (dy > segment.high + rounded));
    }
    NearSegment* kept = segments_.data();
    for (const NearSegment* segment = kept; segment < end; ++segment) {
      const bool is_near = all_segments_[segment->number].lineMeets(cell.center, around);
      *kept = *segment;
      kept += is_near;
    }
    segments_.resize(static_cast<std::size_t>(kept - segments_.data()));
  }

  /// gather() from a cell's segments.
  Gathered filter(const Cell& cell, double radius) {
    lines_.clear(kMostInherited);
    narrow(cell, radius);
    for (const NearSegment& segment : segments_)
      if (!lines_.add(all_segments_[segment.number], cell.center, cutAt(radius))) return Gathered::Many;
    return Gathered::Lines;
  }

  /// All lines around a cell; or why there are none: too many, or two edges meet on all of it.
  Gathered gather(const Cell& cell, double radius) {
    Gathered result = Gathered::Lines;
    lines_.clear(cell.half < kSmall * best_.length ? kMostInherited : kMostGathered);
    Vec2 t = cell.center;
    const PosedPair pair = space_.at(t);
    const double off = (t - cell.center).norm(), around = cutAt(radius) + off;
    const double half = cell.half + surroundings(radius) + off;
    space_.forEachSegment(
        pair, t, half * kDiagonal * (1 + 0x1p-40),
        [&](const MeetingEdges& meeting) {
          if (probe_.see(meeting, cell.center, radius)) result = Gathered::Deep;
          return result == Gathered::Lines;
        },
        [&](const TranslationSpace::Segment& segment) {
          const BoundaryLines::Line line({segment.v, segment.w}, segment.both_sides, space_.noise());
          if (line.boxMeets(t, half) && line.lineMeets(t, half) && !lines_.add(line, t, around))
            result = Gathered::Many;
          return result == Gathered::Lines;
        });
    return result;
  }

  TranslationSpace& space_;
  const std::size_t most_;
  /// Segments nearer to each other than this are one; slits between them are not seen.
  const double resolution_;
  BoundaryLines lines_;
  TranslationProbe probe_;
  PartingLimits limits_;
  BestParting best_;
  std::vector<BoundaryLines::Line> all_segments_;
  Segments segments_;  ///< near the cell
  std::priority_queue<Cell, std::vector<Cell>, Farther> cells_;
  bool discs_overlap_ = false;  ///< after some translation that was asked for
};

}  // namespace

ShortestParting searchShortestParting(TranslationSpace& space, const Vec2& known, const Vec2* last, std::size_t most) {
  return PartingSearch(space, known, most).run(last);
}

}  // namespace tricover::detail
