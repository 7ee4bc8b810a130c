// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "contact/translation_space.h"
#include "pair/collide_by_hierarchy.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// What the kernel tells about translations, and the edges that met after those that were asked for last: who asks next
/// asks nearby.
class TranslationProbe {
 public:
  using MeetingEdges = TranslationSpace::MeetingEdges;

  explicit TranslationProbe(TranslationSpace& space) : space_(space) {}

  /// Forgets the edges that met, to look elsewhere.
  void leave() {
    near_.clear();
    overlaps_ = false;
  }

  /// Whether two edges meet after all translations within `radius` of t; if they may after some, they are kept.
  bool see(const MeetingEdges& meeting, const Vec2& t, double radius);
  /// Whether a meeting that is kept holds all within `radius` of t.
  bool overlapAround(const Vec2& t, double radius);

  /// The kernel's answer for a pair of space.at(), with a clearance up to `lookahead`.
  Outcome ask(const PosedPair& pair, double lookahead) const {
    return collideByHierarchy(pair, {}, lookahead, Wanted::Clearance);
  }
  /// Its edges, if these meet, are kept.
  void keep(const Outcome& outcome);
  /// Whether the regions are apart after a translation; t becomes the one that was asked for.
  bool isFree(Vec2& t);

  /// A lower bound on how far the translation may change while the regions overlap, by the kernel's answer after it.
  double depthOf(const PosedPair& pair, const Outcome& outcome) const;
  double inUnits(double length) const { return length / space_.unit(); }

  const std::vector<MeetingEdges>& meetings() const { return near_; }
  /// Whether edges were seen, since leave(), that meet at the translation they were seen at.
  bool overlaps() const { return overlaps_; }
  std::size_t queries() const { return queries_; }
  /// Something else was done that took about as long.
  void countQuery() { ++queries_; }

 private:
  double depthOf(const MeetingEdges& meeting, const Vec2& t) const { return meeting.depth(t) - 4 * space_.noise(); }

  TranslationSpace& space_;
  std::vector<MeetingEdges> near_;
  std::size_t queries_ = 0;
  bool overlaps_ = false;
};

}  // namespace tricover::detail
