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
// With a margin, what is free is farther from the segments than that, and bounded by lines beside them and by circles
// around their ends; the shortest translation ends at 0's projection on one of these, or where two cross.
//
// Segments within `resolution_` of each other are taken for one: outlines that run parallel but for rounding would make
// slivers without end. So a free slit narrower than twice that may be missed, and nothing else.
//
// Cost: a query of the kernel a cell, and one a sample. The cells are those of the disc of radius depth, as fine as the
// overlap is intricate there; in a long search those that a disc of a and one of b overlap on take no query. Where
// parts repeat, many pairs of edges make the same few segments: there a cell is covered by parallelograms, each of the
// translations at which two edges meet, instead of gathering all pairs. Measured (instructions, mean) on the
// paper's polygons of size 100, overlapping by 33 on the mean: contour of 64 vertices 0.21 million, with hole 0.11,
// starred 1.7; contour of 256 vertices 2.5, starred 5.8, contour of 512 vertices 8.0, with hole 3.1. Worst case:
// outlines that are nearly parallel by more than the resolution over a long way, as combs turned by 1e-9 against each
// other are, need cells as small as their gaps are narrow; only the number of translations ends that.
#include "contact/translation_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include "contact/boundary_curves.h"
#include "contact/known_cells.h"
#include "contact/parting_limits.h"
#include "contact/translation_probe.h"
#include "contact/uncovered.h"

namespace tricover::detail {
namespace {

constexpr double kDiagonal = 1.4142135623730951;
/// A search of more queries than this goes on with both regions covered by discs, if inner discs of both overlapped in
/// one of them: otherwise what is searched is too shallow, or the regions too thin, for discs to hold much of it.
constexpr std::size_t kLong = 10;
/// Beyond so many segments on lines that are known already, a cell is tried to be covered.
constexpr std::size_t kMostRepeated = 128;
/// A cell is decided by no more curves than these: fewer where gathering them costs as much as anything, unless it is
/// so small a part of what is searched that it may be one point they cross in.
constexpr std::size_t kMostInherited = 24, kMostGathered = 6;
constexpr double kSmall = 0x1p-8;
/// How far beyond a cell its segments are gathered, by the radius of its circumcircle, so that samples around a point
/// of it, or within the resolution of that, are understood: samples are of use from three of it on. And to where, from
/// its centre, they are cut.
constexpr double kSurroundings = 0x1p-5, kCut = 1 + 2 * kSurroundings;
static_assert(kSurroundings >= PartingLimits::kRoom * 4 / 3);

using MeetingEdges = TranslationSpace::MeetingEdges;

/// One of the search's segments, and the box around it: its middle and half its sides.
struct NearSegment {
  float x, y, wide, high;
  std::uint32_t number;
};
using Segments = std::vector<NearSegment>;

/// The sides are rounded up by more than what its place loses as floats: half a unit of 2^-23 in either coordinate.
NearSegment nearSegment(const BoundaryCurves::Line& line, std::size_t number) {
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
  std::uint32_t number;  ///< among the known ones
};
struct Farther {
  bool operator()(const Cell& c, const Cell& d) const { return c.least > d.least; }
};

Cell makeCell(const Vec2& center, double half, std::shared_ptr<const Legacy> legacy, std::uint32_t number) {
  return {std::hypot(std::max(std::abs(center.x()) - half, 0.0), std::max(std::abs(center.y()) - half, 0.0)), center,
          half, std::move(legacy), number};
}

class PartingSearch {
 public:
  PartingSearch(TranslationSpace& space, const Vec2& known, double error, std::size_t most, SearchHints* hints)
      : space_(space),
        enough_(1 / (1 + error)),
        most_(most),
        margin_(space.margin()),
        resolution_(16 * space.noise()),
        curves_(margin_, space.noise(), resolution_),
        known_(space, hints),
        probe_(space),
        limits_(space, resolution_),
        best_{{known, known, 0}, known.norm()} {}

  ShortestParting run() {
    auto all_sums = std::make_shared<const DiscSums>();
    bool are_covered = false;
    space_.prepareSearch(best_.length, known_.areMost());
    tryLast();
    begin();
    while (!cells_.empty() && cells_.top().least < enough_ * best_.length) {
      const Cell cell = cells_.top();
      best_.found.lower_bound = std::max(best_.found.lower_bound, cell.least);
      if (probe_.queries() >= most_) return finished();
      cells_.pop();
      if (known_.areFacts() && known_.isDivided(cell.number)) {
        divide(cell, inherited(cell));
        continue;
      }
      if (probe_.queries() > kLong && discs_overlap_ && !are_covered) {
        are_covered = true;
        all_sums = std::make_shared<const DiscSums>(space_.discSums());
      }
      auto sums = cell.legacy->sums != nullptr ? cell.legacy->sums : all_sums;
      held_by_ = {KnownCells::kNone, KnownCells::kNone};
      reach_ = 0;
      const Verdict verdict = decide(cell, *sums);
      if (verdict == Verdict::Held) known_.block(cell.number, held_by_);
      if (verdict == Verdict::Done && known_.areKept()) done_.push_back({cell, reach_ - 2 * resolution_});
      if (verdict != Verdict::Open) continue;
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
    return finished();
  }

 private:
  /// The last way out is the first to be tried; after a turn a little farther, too.
  void tryLast() {
    const auto last = known_.last();
    if (!last) return;
    if (known_.areFacts()) {
      Vec2 parting = last->parting;
      if (last->limit.norm() < best_.length && probe_.isFree(parting)) best_.improve(last->limit, parting);
      return;
    }
    for (const double farther : {1.0, 1.01, 1.05}) {
      Vec2 t = farther * last->parting;
      if (!(t.norm() < best_.length)) return;
      if (probe_.isFree(t)) return best_.improve(t, t);
    }
  }

  void begin() {
    const KnownCells::Square whole = known_.begin(best_.length);
    const bool knows_segments = space_.areFew();
    const auto legacy = std::make_shared<const Legacy>(
        Legacy{nullptr, {}, knows_segments ? segmentsAround(whole.half) : Segments(), knows_segments});
    constexpr double kAside[] = {0, 2, -2};
    for (std::uint32_t k = 0; k < (known_.areKept() ? 9 : 1); ++k)
      add(makeCell(whole.center + whole.half * Vec2(kAside[k % 3], kAside[k / 3]), whole.half, legacy,
                   known_.areKept() ? k : KnownCells::kNone));
  }

  void add(Cell cell) {
    if (cell.least < best_.length && !known_.isBlocked(cell.number) && !known_.isDone(cell.number, best_.length))
      cells_.push(std::move(cell));
  }

  /// Of a cell that is divided without a look.
  std::shared_ptr<const Legacy> inherited(const Cell& cell) {
    if (!cell.legacy->knows_segments || cell.legacy->segments.size() < 16) return cell.legacy;
    narrow(cell, cell.half * kDiagonal * (1 + 0x1p-40));
    return std::make_shared<const Legacy>(Legacy{cell.legacy->sums, {}, segments_, true});
  }

  void divide(const Cell& cell, const std::shared_ptr<const Legacy>& legacy) {
    const double half = cell.half / 2;
    std::uint32_t part = known_.divide(cell.number);
    for (const Vec2& way : {Vec2(-half, -half), Vec2(half, -half), Vec2(-half, half), Vec2(half, half)}) {
      add(makeCell(cell.center + way, half, legacy, part));
      if (part != KnownCells::kNone) ++part;
    }
  }

  ShortestParting finished() {
    // The search has shown that nothing shorter than the bound is free.
    const double bound = best_.found.lower_bound;
    for (const auto& [cell, reach] : done_) {
      const Vec2 farthest = cell.center.cwiseAbs() + Vec2::Constant(cell.half);
      if (farthest.norm() < bound)
        known_.block(cell.number);
      else
        known_.finish(cell.number, std::max(reach, bound));
    }
    known_.keep({best_.found.limit, best_.found.parting}, looks_);
    best_.found.looks = looks_;
    return best_.found;
  }

  /// Of a cell: nothing shorter than the best is left to be found in it; or even no free translation.
  enum class Verdict { Open, Done, Held };

  Verdict decide(const Cell& cell, const DiscSums& sums) {
    probe_.countQuery();
    const double radius = cell.half * kDiagonal * (1 + 0x1p-40);
    probe_.leave();
    if (const auto edges = known_.metOn(cell.number))
      if (see(space_.meetingOf(edges->first, edges->second), cell.center, radius)) return Verdict::Held;
    const bool is_divided = cell.half > resolution_ && known_.isDivided(cell.number);
    if (!is_divided && sums.hold(cell.center, radius)) return Verdict::Held;
    for (const MeetingEdges& meeting : cell.legacy->meetings)
      if (see(meeting, cell.center, radius)) return Verdict::Held;
    if (is_divided) {
      if (cell.legacy->knows_segments) narrow(cell, radius);
      return Verdict::Open;
    }
    if (cell.half <= resolution_) return Verdict::Done;
    ++looks_;
    // A cell that holds a free translation isn't covered.
    const bool holds_limit = (best_.found.limit - cell.center).lpNorm<Eigen::Infinity>() <= cell.half;
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    const bool knows_segments = cell.legacy->knows_segments;
    const auto curvesAround = [&](std::size_t most) {
      return knows_segments ? filter(cell, radius, most) : gather(cell, radius, most);
    };
    const std::size_t most = holds_limit ? kAll : kMostRepeated;
    Gathered gathered = knows_segments ? curvesAround(most) : Gathered::Many;
    // Among many segments what meets in the middle seldom decides.
    const bool passes = knows_segments && gathered == Gathered::Many && discs_overlap_;
    if (gathered != Gathered::Lines && !passes && !probe_.overlaps()) {
      const Verdict verdict = ask(cell.center, radius);
      if (verdict != Verdict::Open) return verdict;
    }
    if (!knows_segments) gathered = curvesAround(most);
    if (gathered == Gathered::Repeated) {
      switch (coverSquare(cell.center, cell.half, resolution_, space_, probe_)) {
        case Cover::Whole:
          return Verdict::Held;
        case Cover::Most:
          return Verdict::Open;
        case Cover::Little:
          gathered = curvesAround(kAll);
      }
    }
    if (gathered == Gathered::Deep) return Verdict::Held;
    if (gathered != Gathered::Lines) return Verdict::Open;
    // No line: the answer at the centre is that of the whole cell.
    if (curves_.isEmpty()) return Verdict::Done;
    double reach = best_.length + known_.lookahead();
    const bool looks_ahead = reach > best_.length;
    const bool is_done = limits_.find(curves_, cell.center, cell.half, radius, probe_, best_, reach);
    if (looks_ahead) reach_ = reach;
    return is_done ? Verdict::Done : Verdict::Open;
  }

  /// Whether two edges meet on all of a cell: these hold it.
  bool see(const MeetingEdges& meeting, const Vec2& center, double radius) {
    const bool holds = probe_.see(meeting, center, radius);
    if (holds) held_by_ = {meeting.edge_a, meeting.edge_b};
    return holds;
  }

  /// Whether the kernel's answer at a cell's centre is that of the whole cell.
  Verdict ask(const Vec2& center, double radius) {
    Vec2 t = center;
    const PosedPair pair = space_.at(t);
    radius += (t - center).norm() * (1 + 0x1p-40);
    const Outcome outcome = probe_.ask(pair, pair.reach(2 * radius * space_.unit()));
    if (outcome.collides) {
      discs_overlap_ = discs_overlap_ || (outcome.edge_a < 0 && outcome.clearance > 0);
      probe_.keep(outcome);
      if (!(probe_.depthOf(pair, t, outcome) >= radius)) return Verdict::Open;
      if (outcome.edge_a >= 0 && outcome.edge_b >= 0)
        held_by_ = {static_cast<std::uint32_t>(outcome.edge_a), static_cast<std::uint32_t>(outcome.edge_b)};
      return Verdict::Held;
    }
    const double clearance = probe_.inUnits(pair, outcome.clearance) - margin_, length = t.norm();
    const double back = std::clamp(clearance - space_.noise(), 0.0, length);
    const Vec2 nearest = length > 0 ? Vec2(t * (1 - back / length)) : t;
    best_.improve(nearest, nearest);
    return clearance >= radius ? Verdict::Done : Verdict::Open;
  }

  /// All segments that a search by squares of such a half side needs; of those that are to be known, wherever it goes
  /// on.
  void findSegments(double half) {
    const auto add = [&](const Vec2& v, const Vec2& w, bool both_sides) {
      all_segments_.emplace_back(BoundaryCurves::Ends{v, w}, both_sides, space_.noise());
    };
    if (known_.haveSegments()) return known_.forEachSegment(add);
    const bool are_kept = known_.keepSegments() && space_.areKept();
    const double farthest = best_.length + known_.lookahead() + kSurroundings * half;
    const double radius = are_kept ? std::numeric_limits<double>::infinity() : farthest + margin_;
    const std::vector<TranslationSpace::Segment> segments = space_.segmentsWithin(radius);
    all_segments_.reserve(segments.size());
    for (const TranslationSpace::Segment& segment : segments) {
      add(segment.v, segment.w, segment.both_sides);
      if (are_kept) known_.keepSegment(segment.v, segment.w, segment.both_sides);
    }
  }

  Segments segmentsAround(double half) {
    findSegments(half);
    Segments all;
    all.reserve(all_segments_.size());
    for (const BoundaryCurves::Line& line : all_segments_) all.push_back(nearSegment(line, all.size()));
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

  /// Of the segments that may come near a cell those that do.
  void narrow(const Cell& cell, double radius) {
    const double around = cell.half + kSurroundings * radius + margin_;
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
  Gathered filter(const Cell& cell, double radius, std::size_t most) {
    Tally tally{most};
    curves_.clear(kMostInherited);
    narrow(cell, radius);
    for (std::size_t k = 0; k < segments_.size() && tally.goesOn(); ++k)
      curves_.add(all_segments_[segments_[k].number], cell.center, kCut * radius, tally);
    return tally.result;
  }

  /// All lines around a cell; or why it is divided.
  Gathered gather(const Cell& cell, double radius, std::size_t most) {
    Tally tally{most};
    curves_.clear(cell.half < kSmall * best_.length ? kMostInherited : kMostGathered);
    Vec2 t = cell.center;
    const PosedPair pair = space_.at(t);
    const double off = (t - cell.center).norm(), around = kCut * radius + off;
    const double half = cell.half + kSurroundings * radius + margin_ + off;
    space_.forEachSegment(
        pair, t, half * kDiagonal * (1 + 0x1p-40),
        [&](const MeetingEdges& meeting) {
          if (see(meeting, cell.center, radius)) tally.result = Gathered::Deep;
          return tally.goesOn();
        },
        [&](const TranslationSpace::Segment& segment) {
          const BoundaryCurves::Line line({segment.v, segment.w}, segment.both_sides, space_.noise());
          if (line.boxMeets(t, half) && line.lineMeets(t, half)) curves_.add(line, t, around, tally);
          return tally.goesOn();
        });
    return tally.result;
  }

  TranslationSpace& space_;
  const double enough_;  ///< of the limit's length, as a lower bound
  const std::size_t most_;
  const double margin_;
  /// Segments nearer to each other than this are one; slits between them are not seen.
  const double resolution_;
  BoundaryCurves curves_;
  KnownCells known_;
  TranslationProbe probe_;
  PartingLimits limits_;
  BestParting best_;
  std::vector<BoundaryCurves::Line> all_segments_;
  Segments segments_;  ///< near the cell
  std::priority_queue<Cell, std::vector<Cell>, Farther> cells_;
  std::vector<std::pair<Cell, double>> done_;  ///< to be kept, with how far away from 0 nothing is free in them
  std::pair<std::uint32_t, std::uint32_t> held_by_;
  double reach_ = 0;  ///< the same of the cell, if the search has looked farther than it needs to
  std::uint32_t looks_ = 0;
  bool discs_overlap_ = false;  ///< after some translation that was asked for
};

}  // namespace

ShortestParting searchShortestParting(TranslationSpace& space, const Vec2& known, double error, std::size_t most,
                                      SearchHints* hints) {
  const bool are_used = hints != nullptr && KnownCells::areWorthIt(*hints);
  const ShortestParting found = PartingSearch(space, known, error, most, are_used ? hints : nullptr).run();
  if (hints != nullptr && !are_used) hints->looks = found.looks;
  return found;
}

}  // namespace tricover::detail
