// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "contact/translation_space.h"
#include "tricover/penetration.h"

namespace tricover::detail {

/// What the last searches of a pair knew about squares of the plane of translations, and where they are now. That there
/// is no free translation in one is a fact as long as neither polygon turns. After a turn it becomes what to prove
/// first: that two edges meet on all of it, or that it has to be divided.
class KnownCells {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Square {
    Vec2 center;
    double half;
  };

  /// hints: null, or what a cache keeps.
  KnownCells(TranslationSpace& space, SearchHints* hints);

  /// Whether the next search is to use hints: not if little had to be looked at without them, nor while they rest.
  static bool areWorthIt(SearchHints& hints);

  bool areKept() const { return hints_ != nullptr; }
  /// Whether they are known as well as then.
  bool areFacts() const { return hints_ != nullptr && !has_turned_ && !is_new_; }
  /// Whether that is most of what there is to know here: they haven't moved far.
  bool areMost() const { return areFacts() && !has_moved_far_; }
  /// Where the last search's end is now: a free translation, unless the polygons have turned.
  struct Ends {
    Vec2 limit, parting;
  };
  std::optional<Ends> last() const;
  /// The end of this one, and how many cells had to be looked at.
  void keep(const Ends& ends, std::uint32_t looks);
  /// So much farther away than it needs to a search looks for the next ones.
  double lookahead() const { return ahead_; }

  /// The segments that bound what overlaps, once they have been kept.
  bool haveSegments() const { return areFacts() && !hints_->segments.empty(); }
  /// Whether they are to be kept: after a turn they are others, and who moves far doesn't stay where they are.
  bool keepSegments() const { return hints_ != nullptr && !has_turned_ && !has_moved_far_; }
  template <typename Visit>
  void forEachSegment(Visit visit) const {
    for (const SearchHints::Segment& s : hints_->segments)
      visit(Vec2(s.from[0], s.from[1]) - between_, Vec2(s.to[0], s.to[1]) - between_, s.both_sides);
  }
  void keepSegment(const Vec2& from, const Vec2& to, bool both_sides) {
    const Vec2 v = from + between_, w = to + between_;
    hints_->segments.push_back({{v.x(), v.y()}, {w.x(), w.y()}, both_sides});
  }

  /// The square to begin with. Its number is 0; 1 to 8 are around it, and with them it holds all that is shorter than
  /// `upper`.
  Square begin(double upper);

  /// Whether no translation in the cell is free.
  bool isBlocked(std::uint32_t cell) const { return kindOf(cell) == SearchHints::Blocked; }
  /// Two edges that met on all of it, before a turn.
  std::optional<std::pair<std::size_t, std::size_t>> metOn(std::uint32_t cell) const;
  /// Whether it has to be divided. After turns one in some is looked at all the same, lest divisions go on for ever.
  bool isDivided(std::uint32_t cell) const;

  /// Whether nothing in it is free within `reach` of 0.
  bool isDone(std::uint32_t cell, double reach) const {
    return kindOf(cell) == SearchHints::Done && reach + hints_->moved < static_cast<double>(hints_->cells[cell].until);
  }
  void finish(std::uint32_t cell, double reach);
  /// From now on; the edges, if there are any, meet on all of it.
  void block(std::uint32_t cell, std::pair<std::uint32_t, std::uint32_t> edges = {kNone, kNone});
  /// The first of its four parts.
  std::uint32_t divide(std::uint32_t cell);

 private:
  SearchHints::Kind kindOf(std::uint32_t cell) const {
    return cell == kNone ? SearchHints::Unknown : hints_->cells[cell].kind;
  }

  SearchHints* const hints_;
  const Vec2 between_;
  bool has_turned_ = false, has_moved_far_ = false, is_new_ = true;
  double ahead_ = 0;
};

}  // namespace tricover::detail
