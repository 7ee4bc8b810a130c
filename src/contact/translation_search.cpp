// SPDX-License-Identifier: BSD-3-Clause
// The shortest parting translation is the nearest point of the closure of the free ones. That is 0's projection on a
// convolution segment, an end of one or a crossing of two (on the boundary of a free face of the segments' arrangement
// no other point is nearest), and which of these are limits of free translations the kernel tells, by samples beside
// them. Looking at all would cost (n m)^2, so the plane is searched from 0 outwards by square cells. A cell is done
// with where the kernel's clearance or depth at its centre reaches beyond it, where no segment comes near it, and where
// few enough do for all their candidates to be tried; otherwise it is split in four. Nearer cells are done with before
// farther ones, so the least distance of those left is a lower bound.
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
// other are, need cells as small as their gaps are narrow; only the budget ends that.
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
/// A search of more queries than this begins again with both regions covered by discs.
constexpr std::size_t kLong = 24;
/// Beyond so many segments on lines that are known already, a cell is tried to be covered; by about so many
/// parallelograms.
constexpr std::size_t kMostRepeated = 128;
constexpr int kMostTries = 24;
/// How far beyond a cell's circumcircle its segments are gathered, so that samples around a point of it are understood.
constexpr double kSurroundings = 1.25;

struct Cell {
  double least;  ///< distance of 0
  Vec2 center;
  double half;
  std::shared_ptr<const DiscSums> sums;  ///< that may hold parts of it
};
struct Farther {
  bool operator()(const Cell& c, const Cell& d) const { return c.least > d.least; }
};

Cell makeCell(const Vec2& center, double half, std::shared_ptr<const DiscSums> sums) {
  return {std::hypot(std::max(std::abs(center.x()) - half, 0.0), std::max(std::abs(center.y()) - half, 0.0)), center,
          half, std::move(sums)};
}

/// Where a free face of the lines' arrangement may be nearest to 0.
struct PossibleLimit {
  Vec2 p;
  double error;  ///< of p, along the lines that cross there
};

class PartingSearch {
 public:
  PartingSearch(TranslationSpace& space, const Vec2& known, std::size_t budget)
      : space_(space),
        budget_(budget),
        margin_(space.margin()),
        options_{margin_ * space.unit(), 0},
        resolution_(16 * space.noise()),
        curves_(margin_, space.noise(), resolution_),
        found_{known, known, 0},
        upper_(known.norm()) {}

  ShortestParting run() {
    std::priority_queue<Cell, std::vector<Cell>, Farther> cells;
    auto sums = std::make_shared<const DiscSums>();
    const auto begin = [&] {
      cells = {};
      cells.push(makeCell(Vec2::Zero(), upper_ * (1 + 0x1p-20), sums));
    };
    begin();
    bool covered = false;
    while (!cells.empty() && cells.top().least < upper_) {
      if (queries_ > kLong && !covered) {
        covered = true;
        sums = std::make_shared<const DiscSums>(space_.discSums());
        coarse_ = upper_ / 8;
        begin();
      }
      const Cell cell = cells.top();
      found_.lower_bound = std::max(found_.lower_bound, cell.least);
      if (queries_ >= budget_) return found_;
      cells.pop();
      if (decide(cell)) continue;
      const double half = cell.half / 2, radius = cell.half * kDiagonal;
      const auto near =
          cell.sums->areMany() ? std::make_shared<const DiscSums>(cell.sums->near(cell.center, radius)) : cell.sums;
      for (const Vec2& way : {Vec2(-half, -half), Vec2(half, -half), Vec2(-half, half), Vec2(half, half)})
        cells.push(makeCell(cell.center + way, half, near));
    }
    found_.lower_bound = std::max(0.0, upper_ - resolution_ - error_);
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

  bool isFree(Vec2& t) {
    ++queries_;
    return !collideByHierarchy(space_.at(t), options_, 0, Wanted::Answer).collides;
  }

  /// Whether nothing shorter than the best is left to be found in the cell.
  bool decide(const Cell& cell) {
    ++queries_;
    Vec2 t = cell.center;
    const PosedPair pair = space_.at(t);
    const double radius = (cell.half * kDiagonal + (t - cell.center).norm()) * (1 + 0x1p-40);
    if (cell.sums->hold(t, radius)) return true;
    if (cell.half > coarse_) return false;
    const Outcome outcome =
        collideByHierarchy(pair, options_, pair.reach(2 * radius * space_.unit()), Wanted::Clearance);
    if (outcome.collides) {
      if (depthOf(pair, t, outcome) >= radius) return true;
    } else {
      const double clearance = inUnits(pair, outcome.clearance) - margin_, length = t.norm();
      const double back = std::clamp(clearance - space_.noise(), 0.0, length);
      const Vec2 nearest = length > 0 ? Vec2(t * (1 - back / length)) : t;
      improve(nearest, nearest);
      if (clearance >= radius) return true;
    }
    if (cell.half <= resolution_) return true;

    Gathered gathered = gather(pair, t, radius, kMostRepeated);
    if (gathered == Gathered::Repeated) {
      switch (cover(cell)) {
        case Cover::Whole:
          return true;
        case Cover::Most:
          return false;
        case Cover::Little:
          gathered = gather(space_.at(t), t, radius, std::numeric_limits<std::size_t>::max());
      }
    }
    if (gathered != Gathered::Lines) return gathered == Gathered::Deep;
    // No line: the answer at the centre is that of the whole cell.
    return curves_.isEmpty() || decideByCurves(cell, radius);
  }

  /// All lines around a cell; or why it needs no more: edges cross deeper than the cell reaches, the lines are too
  /// many, or more segments than `most` have been on lines that were known.
  enum class Gathered { Lines, Deep, Many, Repeated };
  Gathered gather(const PosedPair& pair, const Vec2& t, double radius, std::size_t most) {
    Gathered result = Gathered::Lines;
    std::size_t repeated = 0;
    curves_.clear();
    const double around = kSurroundings * radius;
    const auto note = [&](BoundaryCurves::Added added) {
      if (added == BoundaryCurves::Repeated && ++repeated > most) result = Gathered::Repeated;
      if (added == BoundaryCurves::TooMany) result = Gathered::Many;
    };
    space_.forEachSegment(
        pair, t, around + margin_,
        [&](std::size_t i, std::size_t j) {
          if (depthOf(pair, t, i, j) >= radius) result = Gathered::Deep;
          return result == Gathered::Lines;
        },
        [&](const TranslationSpace::Segment& segment) {
          curves_.add({segment.v, segment.w}, t, around, note);
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
    if (rays_.empty()) rays_.push_back(std::atan2(-p.y(), -p.x()));
    std::sort(rays_.begin(), rays_.end());
    bool resolved = true;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const double gap = i + 1 < rays_.size() ? rays_[i + 1] - rays_[i] : rays_[0] + 2 * kPi - rays_[i];
      const double middle = rays_[i] + gap / 2, width = std::sin(std::min(gap, kPi) / 2);
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
  const std::size_t budget_;
  const double margin_;
  const CollideOptions options_;
  /// Segments nearer to each other than this are one; slits between them are not seen.
  const double resolution_;
  BoundaryCurves curves_;
  ShortestParting found_;
  double upper_, error_ = 0;
  std::size_t queries_ = 0;
  /// In a long search cells larger than this are divided without a query.
  double coarse_ = std::numeric_limits<double>::infinity();
  std::vector<PossibleLimit> limits_;
  std::vector<double> rays_;
};

}  // namespace

ShortestParting searchShortestParting(TranslationSpace& space, const Vec2& known, std::size_t budget) {
  return PartingSearch(space, known, budget).run();
}

}  // namespace tricover::detail
