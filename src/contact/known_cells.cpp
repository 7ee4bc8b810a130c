// SPDX-License-Identifier: BSD-3-Clause
#include "contact/known_cells.h"

#include <algorithm>
#include <limits>

#include "polygon/fact_balance.h"

namespace tricover::detail {
namespace {

/// With more, all are forgotten: 16 bytes each.
constexpr std::size_t kMostCells = 8192;
constexpr double kOutwards = 1 + 0x1p-20;
/// So many steps like the last one are provided for.
constexpr double kStepsAhead = 8;

}  // namespace

bool KnownCells::areWorthIt(SearchHints& hints) {
  constexpr std::uint32_t kFewLooks = 4;
  if (hints.balance.resting > 0) {
    --hints.balance.resting;
    return false;
  }
  return hints.looks >= kFewLooks;
}

KnownCells::KnownCells(TranslationSpace& space, SearchHints* hints) : hints_(hints), between_(space.between()) {
  if (hints_ == nullptr) return;
  SearchHints& known = *hints_;
  Vec2 still = Vec2::Zero();
  const PosedPair pair = space.at(still);
  Eigen::Map<Eigen::Matrix2d> first_turn(known.first_turn), second_turn(known.second_turn);
  Eigen::Map<Vec2> center(known.center), place(known.place), limit(known.limit), parting(known.parting);
  const bool is_same = known.first_id == pair.a.id && known.second_id == pair.b.id && known.margin == space.margin() &&
                       known.noise <= 2 * space.noise();
  if (!is_same || known.cells.size() > kMostCells) known.cells.clear();
  if (!is_same) limit = parting = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  has_turned_ = first_turn != pair.pose_a.linear() || second_turn != pair.pose_b.linear();
  if (has_turned_) {
    constexpr double kSmallTurn = 0.1;
    const Eigen::Matrix2d turned = pair.pose_a.linear() * first_turn.transpose();
    const double moved = pair.b.radius / space.unit() * (turned * second_turn - pair.pose_b.linear()).norm();
    if (!(moved <= kSmallTurn * known.half)) known.cells.clear();
    for (SearchHints::Cell& cell : known.cells)
      if (cell.kind == SearchHints::Blocked && cell.first != kNone)
        cell.kind = SearchHints::Met;
      else if (cell.kind != SearchHints::Divided)
        cell.kind = SearchHints::Unknown;
    known.segments.clear();
    center = (turned * center).eval();
    limit = (turned * limit).eval();
    parting = (turned * parting).eval();
  }
  known.first_id = pair.a.id;
  known.second_id = pair.b.id;
  known.margin = space.margin();
  first_turn = pair.pose_a.linear();
  second_turn = pair.pose_b.linear();
  ++known.searches;
  is_new_ = known.cells.empty();
  if (is_new_) {
    known.segments.clear();
    known.moved = known.noise = 0;
  } else {
    const double step = (between_ - place).norm();
    known.moved += step * kOutwards;
    has_moved_far_ = step > 0.05 * known.half;
    ahead_ = has_turned_ || kStepsAhead * step > 0.25 * known.half ? 0 : kStepsAhead * step;
  }
  place = between_;
  known.noise = std::max(known.noise, space.noise());
}

std::optional<KnownCells::Ends> KnownCells::last() const {
  if (hints_ == nullptr) return std::nullopt;
  return Ends{Eigen::Map<const Vec2>(hints_->limit) - between_, Eigen::Map<const Vec2>(hints_->parting) - between_};
}

void KnownCells::keep(const Ends& ends, std::uint32_t looks) {
  if (hints_ == nullptr) return;
  Eigen::Map<Vec2> limit(hints_->limit), parting(hints_->parting);
  // What stays is not rounded again and again.
  if (limit - between_ != ends.limit) limit = between_ + ends.limit;
  if (parting - between_ != ends.parting) parting = between_ + ends.parting;
  if (is_new_) hints_->looks = looks;
  // Keeping them costs some of a quarter of a search.
  const int left =
      static_cast<int>(kQuery * std::min(looks, hints_->looks) / std::max(hints_->looks, std::uint32_t{1}));
  isWorthIt(hints_->balance, kQuery - left - 1);
}

KnownCells::Square KnownCells::begin(double upper) {
  const Square all{Vec2::Zero(), upper * kOutwards};
  if (hints_ == nullptr) return all;
  Eigen::Map<Vec2> center(hints_->center);
  if (!hints_->cells.empty()) {
    const Square last{center - between_, hints_->half};
    const double reach = last.center.lpNorm<Eigen::Infinity>() + all.half;
    if (reach * kOutwards <= 3 * last.half && last.half < 4 * all.half) return last;
  }
  is_new_ = true;
  hints_->segments.clear();
  center = between_;
  hints_->half = all.half;
  hints_->cells.assign(9, {});
  return all;
}

std::optional<std::pair<std::size_t, std::size_t>> KnownCells::metOn(std::uint32_t cell) const {
  if (kindOf(cell) != SearchHints::Met) return std::nullopt;
  return std::pair<std::size_t, std::size_t>(hints_->cells[cell].first, hints_->cells[cell].second);
}

bool KnownCells::isDivided(std::uint32_t cell) const {
  constexpr std::uint32_t kForget = 8;
  if (kindOf(cell) != SearchHints::Divided) return false;
  return !has_turned_ || (cell + hints_->searches) % kForget != 0;
}

void KnownCells::block(std::uint32_t cell, std::pair<std::uint32_t, std::uint32_t> edges) {
  if (cell != kNone) hints_->cells[cell] = {edges.first, edges.second, 0, SearchHints::Blocked};
}

void KnownCells::finish(std::uint32_t cell, double reach) {
  if (cell == kNone) return;
  const double until = (reach + hints_->moved) * (1 - 0x1p-20);
  hints_->cells[cell] = {0, 0, static_cast<float>(until), SearchHints::Done};
}

std::uint32_t KnownCells::divide(std::uint32_t cell) {
  if (cell == kNone || hints_->cells.size() > kMostCells) return kNone;
  const SearchHints::Cell& known = hints_->cells[cell];
  if (known.kind == SearchHints::Divided) return known.first;
  const auto parts = static_cast<std::uint32_t>(hints_->cells.size());
  hints_->cells[cell] = {parts, 0, 0, SearchHints::Divided};
  hints_->cells.resize(hints_->cells.size() + 4);
  return parts;
}

}  // namespace tricover::detail
