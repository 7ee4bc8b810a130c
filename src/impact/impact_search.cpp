// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "impact/impact_solvers.h"
#include "impact/interval_cutter.h"
#include "impact/vertex_paths.h"
#include "numbers/best_first.h"

namespace tricover::detail {
namespace {

/// An interval of time in which two nodes may meet: they certainly don't from time 0 to its begin.
struct Encounter {
  double least, end;  ///< the time of its begin and end
  std::uint32_t a, b;
  int depth;

  /// Of those that begin together, the deepest leads to an impact soonest.
  bool operator<(const Encounter& other) const {
    return least != other.least ? least > other.least : depth < other.depth;
  }
};

/// The encounter that begins first is divided, its nodes or its interval, and what is left of the parts are encounters
/// again. The upper bound is the earliest time at which two edges were seen to touch. Divisions and encounters have a
/// budget, at whose end the lower bound is the result.
class ImpactSearch {
 public:
  ImpactSearch(const MovingPair& pair, double time_error)
      : pair_(pair),
        time_error_(time_error),
        touch_distance_(pair.margin + 4 * pair.error),
        is_in_range_(pair.isInRange()),
        most_encounters_(mostEncounters(pair)),
        most_divisions_(mostDivisions(pair)) {}

  FirstContact run(double begin) {
    offerAnew({begin, 1, kRootNode, kRootNode, 0});
    const bool lasted = search_.run(
        time_error_, [&] { return divided_ >= most_divisions_ || search_.size() > most_encounters_; },
        [&](Encounter encounter) {
          encounter.end = std::min(encounter.end, search_.upper);
          ++divided_;
          divide(encounter);
        });
    if (!lasted) return provenSoFar();
    const double time = search_.lower();
    return time <= 1 ? FirstContact::touch(time, edge_a_, edge_b_) : FirstContact::never();
  }

 private:
  /// An encounter takes 32 bytes.
  static constexpr std::size_t kLeastEncounters = std::size_t{1} << 14, kEncountersPerEdge = 512;
  static constexpr std::size_t kDivisionsPerEncounter = 4;
  static std::size_t mostEncounters(const MovingPair& pair) {
    return kLeastEncounters + kEncountersPerEdge * (pair.a.polygon->path.size() + pair.b.polygon->path.size());
  }
  /// Each radian is a search of its own, up to a limit.
  static std::size_t mostDivisions(const MovingPair& pair) {
    const double radians = std::min(pair.a.rotation.size() + pair.b.rotation.size(), 8.0);
    return kDivisionsPerEncounter * mostEncounters(pair) * (1 + static_cast<std::size_t>(radians));
  }

  /// The budget ended: no contact before the lower bound. Unless edges were seen to touch, it names some that may.
  FirstContact provenSoFar() const {
    const Encounter& best = search_.best();
    FirstContact contact =
        search_.upper <= 1 ? FirstContact::touch(best.least, edge_a_, edge_b_)
                           : FirstContact::touch(best.least, edgeBelow(pair_.a, best.a), edgeBelow(pair_.b, best.b));
    contact.budget_ended = true;
    return contact;
  }
  static EdgePosition edgeBelow(const Mover& mover, std::uint32_t index) {
    BoxOrEdge node = mover.node(index);
    while (!node.edge) node = mover.node(node.child * kLanes);
    return node.child;
  }

  static Encounter cut(Encounter encounter, const Rest& rest) {
    const double begin = encounter.least, length = encounter.end - begin;
    encounter.least = std::min(begin + rest.low * length, encounter.end);
    if (rest.high < 1) encounter.end = std::max(begin + rest.high * length, encounter.least);
    return encounter;
  }

  void offer(const TimeInterval& interval, const Encounter& encounter) {
    const MovingBox a = pair_.a.box(interval.a, pair_.a.node(encounter.a));
    const MovingBox b = pair_.b.box(interval.b, pair_.b.node(encounter.b));
    IntervalCutter cutter(interval, a, b);
    if (cutter.cutByAxesOfA() || cutter.cutByAxesOfB()) return;
    const Rest rest = cutter.rest();
    if (rest.low <= rest.high) search_.push(cut(encounter, rest));
  }

  void offerAnew(const Encounter& encounter) { offer(TimeInterval(pair_, encounter.least, encounter.end), encounter); }

  void divide(const Encounter& encounter) {
    const TimeInterval interval(pair_, encounter.least, encounter.end);
    const BoxOrEdge node_a = pair_.a.node(encounter.a), node_b = pair_.b.node(encounter.b);
    if (node_a.edge && node_b.edge) return divideEdges(interval, encounter, node_a.child, node_b.child);
    const MovingBox a = pair_.a.box(interval.a, node_a), b = pair_.b.box(interval.b, node_b);
    const double size_a = a.along + a.across, size_b = b.along + b.across;
    const IntervalCutter cutter(interval, a, b);
    // Smaller boxes don't help where paths bend by more than the boxes' size, nor shorter intervals once they bend by
    // less than what boxes' axes don't see around their corners: rounding, and a part of the margin.
    if (cutter.bend() > std::max({size_a + size_b, pair_.error, pair_.margin / 16})) return halve(encounter);
    Encounter part = encounter;
    ++part.depth;
    const bool divides_a = !node_a.edge && (node_b.edge || size_a >= size_b);
    const std::uint32_t block = divides_a ? node_a.child : node_b.child;
    if (offerEight(interval, cutter, divides_a, block, divides_a ? node_b : node_a, part)) return;
    const std::uint32_t count = (divides_a ? pair_.a : pair_.b).tree->blocks[block].count;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      (divides_a ? part.a : part.b) = block * kLanes + lane;
      offer(interval, part);
    }
  }

  /// Offers all boxes of a block together with the other mover's box, if floats tell enough. The edges in them are in
  /// the box that is divided, too: so its chord errors bound theirs.
  bool offerEight(const TimeInterval& interval, const IntervalCutter& cutter, bool divides_a, std::uint32_t index,
                  const BoxOrEdge& node, Encounter part) {
    const Mover &mover = divides_a ? pair_.a : pair_.b, &other = divides_a ? pair_.b : pair_.a;
    const Block& block = mover.tree->blocks[index];
    const double inverse = block.inverse / mover.scale;
    const double chord_error_a = cutter.chordErrorWithA() * inverse, chord_error_b = cutter.chordErrorWithB() * inverse;
    const Places seen = divides_a ? interval.a.seen(interval.b, inverse) : interval.b.seen(interval.a, inverse);
    MovingBox box = other.box(seen, node, inverse);
    box.x -= block.origin_x * block.inverse;
    box.y -= block.origin_y * block.inverse;
    const Double2 sizes = absolute(box.x) + absolute(box.y);
    const double sum = std::max(sizes[0], sizes[1]) + box.along + box.across + 4;
    // Lengths are kept to 2^-47 in rotating differences back: as much as the error is once more.
    const double slack = kMovingGapRounding * sum + (pair_.margin * (1 + 0x1p-20) + 2 * pair_.error) * inverse;
    if (!is_in_range_ || mover.stretched > 0 || !(sum + slack + chord_error_a + chord_error_b < 0x1p30)) return false;
    float from_begin[kLanes], from_end[kLanes];
    for (unsigned left = cutIntervals(block, box, divides_a ? chord_error_a : chord_error_b,
                                      divides_a ? chord_error_b : chord_error_a, slack, from_begin, from_end);
         left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      (divides_a ? part.a : part.b) = index * kLanes + static_cast<std::uint32_t>(lane);
      search_.push(cut(part, {static_cast<double>(from_begin[lane]), 1 - static_cast<double>(from_end[lane]), 0}));
    }
    return true;
  }

  void halve(const Encounter& encounter) {
    const double middle = 0.5 * (encounter.least + encounter.end);
    for (const bool later : {false, true}) {
      Encounter part = encounter;
      (later ? part.least : part.end) = middle;
      offerAnew(part);
    }
  }

  /// Where so small a share of an interval is cut off two edges, their ends are looked at one by one: in a search that
  /// takes long, as most don't.
  static constexpr double kLittle = 1.0 / 64;
  static constexpr std::size_t kWithoutEnds = 64;

  void touch(double when, EdgePosition position_a, EdgePosition position_b) {
    if (!(when < search_.upper)) return;
    search_.upper = when;
    edge_a_ = position_a;
    edge_b_ = position_b;
  }

  void divideEdges(const TimeInterval& interval, const Encounter& encounter, EdgePosition position_a,
                   EdgePosition position_b) {
    const MovingBox a = pair_.a.edge(interval.a, position_a), b = pair_.b.edge(interval.b, position_b);
    const auto nearest = [&](int lane) {
      return NearestPoints(pair_.a.ends(interval.a, lane, position_a), pair_.b.ends(interval.b, lane, position_b),
                           pair_.error);
    };
    const NearestPoints at_begin = nearest(0);
    // Written so that NaN, as where bounds overflow, is a touch.
    if (!(at_begin.distance > touch_distance_)) return touch(encounter.least, position_a, position_b);
    if (!(nearest(1).distance > touch_distance_)) touch(encounter.end, position_a, position_b);

    // Some axis separates the edges at the interval's begin by nearly their distance: an edge's normal or, vertex to
    // vertex, that between the nearest points. So it is cut there, once it is short enough for the chord error to be.
    IntervalCutter cutter(interval, a, b);
    if (cutter.cutByAxis((at_begin.on_b - at_begin.on_a) / at_begin.distance) || cutter.cutByNormals()) return;
    Rest rest = cutter.rest();
    if (rest.low < kLittle && divided_ > kWithoutEnds && cutter.bend() > 0 && is_in_range_)
      rest = restOfEdges(interval, position_a, position_b);
    if (rest.low > rest.high) return;

    // Contact is likely about as far beyond the aim as that is beyond the proven bound, if not before: a time interval
    // up to there is shorter by an order.
    const double aimed = rest.low + 3 * (rest.aim - rest.low) + 0.5 * time_error_ / interval.length;
    const double middle = 0.5 * (rest.low + rest.high), share = rest.aim > rest.low ? std::min(aimed, middle) : middle;
    const double split = encounter.least + share * interval.length;
    const Encounter part = cut(encounter, rest);
    if (split > part.least && split < part.end) {
      search_.push({part.least, split, part.a, part.b, part.depth + 1});
      search_.push({split, part.end, part.a, part.b, part.depth + 1});
    } else if (part.least > encounter.least) {
      search_.push(part);
    } else {
      touch(encounter.least, position_a, position_b);  // no time between the interval's ends
    }
  }

  const MovingPair& pair_;
  double time_error_, touch_distance_;
  bool is_in_range_;
  std::size_t most_encounters_, most_divisions_;  ///< the budget
  BestFirst<Encounter> search_{std::numeric_limits<double>::infinity()};
  EdgePosition edge_a_ = 0, edge_b_ = 0;  ///< positions of those that touch at the upper bound
  std::size_t divided_ = 0;
};

}  // namespace

FirstContact searchBoxes(const MovingPair& pair, double begin, double time_error) {
  return ImpactSearch(pair, time_error).run(begin);
}

}  // namespace tricover::detail
