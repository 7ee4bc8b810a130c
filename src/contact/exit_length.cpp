// SPDX-License-Identifier: BSD-3-Clause
#include "contact/exit_length.h"

#include <algorithm>
#include <cmath>
#include <limits>
namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

void ExitLength::see(const Vec2& direction) {
  const Vec2 aside(-direction.y(), direction.x());
  seen_.clear();
  order_.clear();
  places_.clear();
  highest_ = direction.dot(a_.centre) + a_.radius;
  lowest_ = direction.dot(b_.centre) - b_.radius;
  for (const OutlinePiece& piece : pieces_) {
    const Ends known = piece.knownEnds();
    const double v = aside.dot(known.v), w = aside.dot(known.w);
    const double height_v = direction.dot(known.v), height_w = direction.dot(known.w);
    if (!(std::abs(w - v) > error_)) continue;
    const bool goes_up = v < w;  // its left is below
    const bool above = goes_up ? piece.right : piece.left, below = goes_up ? piece.left : piece.right;
    const double start = aside.dot(piece.edge.v), way = aside.dot(piece.way());
    const double from = start + piece.on.low * way, to = start + piece.on.high * way;
    const double rise = goes_up ? height_w - height_v : height_v - height_w;
    seen_.push_back({&piece, std::min(v, w), std::max(v, w), goes_up ? height_v : height_w,
                     goes_up ? height_w : height_v, rise / std::abs(w - v), std::min(from, to), std::max(from, to),
                     piece.side == 0 && !above, piece.side == 1 && !below,
                     std::abs(rise) <= kSameAngle * std::abs(w - v) + error_, 0});
    const Seen& seen = seen_.back();
    order_.emplace_back(seen.low, seen_.size() - 1);
    places_.push_back(seen.high);
    if (seen.piece_low > seen.low + error_) places_.push_back(seen.piece_low);
    if (seen.piece_high < seen.high - error_) places_.push_back(seen.piece_high);
  }
  std::sort(order_.begin(), order_.end());
  std::sort(places_.begin(), places_.end());
}

/// By height at a place. From place to place few change their order.
void ExitLength::sortActive(double place) {
  std::size_t moves = 0;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    Seen* const seen = active_[i];
    seen->height = seen->heightAt(place);
    std::size_t k = i;
    for (; k > 0 && active_[k - 1]->height > seen->height; --k) active_[k] = active_[k - 1];
    active_[k] = seen;
    moves += i - k;
  }
  spend(kStepsToLook * active_.size() + moves);
}

/// On all lines between two places: no edge begins or ends there.
void ExitLength::look(double from, double to, Result& result) {
  const double middle = 0.5 * from + 0.5 * to, same = 4 * error_;
  sortActive(middle);
  for (std::size_t i = 0; i < active_.size(); ++i) {
    const Seen* seen = active_[i];
    if (!seen->isPiece(from, to, thin_ / 2)) continue;
    const double rounding = same * (1 + std::abs(seen->slope));
    std::size_t above = i, below = i + 1;
    while (above > 0 && active_[above - 1]->height >= seen->height - rounding) --above;
    while (above < active_.size() && !active_[above]->is_exit) ++above;
    while (below < active_.size() && active_[below]->height <= seen->height + rounding) ++below;
    while (below > 0 && !active_[below - 1]->is_entry) --below;
    const Seen *const top = above < active_.size() ? active_[above] : nullptr, *const bottom = below > 0
                                                                                                   ? active_[below - 1]
                                                                                                   : nullptr;
    const Seen* const ends[2] = {top, bottom};
    for (const double place : {from, to}) {
      const double length =
          (top != nullptr ? top->heightAt(place) : highest_) - (bottom != nullptr ? bottom->heightAt(place) : lowest_);
      for (const int side : {0, 1})
        if (ends[side] != nullptr && ends[side]->is_across) result.own[side] = std::max(result.own[side], length);
      // Among lines that are equally long but for rounding, one where many are.
      const double width = to - from;
      if (!(length > result.length + same || (length >= result.length - same && width > result.width))) continue;
      const auto endsThere = [&](const Seen* edge) {
        return edge == nullptr || std::abs(place - edge->low) <= thin_ || std::abs(place - edge->high) <= thin_;
      };
      result.length = std::max(length, result.length);
      result.width = width;
      result.top = top != nullptr ? top->piece : nullptr;
      result.bottom = bottom != nullptr ? bottom->piece : nullptr;
      result.place = place;
      result.is_top_corner = endsThere(top) && bottom != nullptr;
      const auto isBeside = [&](const Seen* edge) { return edge != nullptr && edge->isPiece(from, to, thin_ / 2); };
      const double height = isBeside(top) && isBeside(bottom) ? 0.5 * top->height + 0.5 * bottom->height : seen->height;
      result.inside = Vec2(middle, height);
    }
  }
}

ExitLength::Result ExitLength::atMost(const Vec2& direction) const {
  const Vec2 aside(-direction.y(), direction.x());
  Result result;
  double top = -kInfinity, bottom = kInfinity;
  bool a_goes_on = false, b_goes_on = false;
  for (const OutlinePiece& piece : pieces_) {
    const Vec2 way = piece.way();
    const double turn = aside.dot(way);
    if (!(std::abs(turn) > error_ && piece.on.high > piece.on.low)) continue;
    const bool ends_above = !piece.isInside(-turn), ends_below = !piece.isInside(turn), is_of_a = piece.side == 0;
    a_goes_on = a_goes_on || (ends_above && !is_of_a);
    b_goes_on = b_goes_on || (ends_below && is_of_a);
    if (a_goes_on && b_goes_on) break;
    if (!(is_of_a ? ends_above && !a_goes_on : ends_below && !b_goes_on)) continue;
    const double start = direction.dot(piece.edge.v), rise = direction.dot(way);
    const double from = start + piece.on.low * rise, to = start + piece.on.high * rise;
    if (is_of_a && std::max(from, to) > top) top = std::max(from, to), result.top = &piece;
    if (!is_of_a && std::min(from, to) < bottom) bottom = std::min(from, to), result.bottom = &piece;
  }
  // No wider than rounding.
  if (result.top == nullptr && result.bottom == nullptr && !a_goes_on && !b_goes_on) return result;
  if (a_goes_on || result.top == nullptr) top = direction.dot(a_.centre) + a_.radius, result.top = nullptr;
  if (b_goes_on || result.bottom == nullptr) bottom = direction.dot(b_.centre) - b_.radius, result.bottom = nullptr;
  result.length = top - bottom;
  return result;
}

ExitLength::Through ExitLength::throughPoint(const Vec2& point, const Vec2& direction) const {
  const Vec2 aside(-direction.y(), direction.x());
  const double rounding = 4 * error_;
  double top = kInfinity, bottom = -kInfinity;
  for (const OutlinePiece& piece : pieces_) {
    const Ends known = piece.knownEnds();
    const Vec2 from = known.v - point, to = known.w - point;
    const double v = aside.dot(from), w = aside.dot(to);
    if ((v > 0) == (w > 0)) continue;
    const double turn = w - v, height = (direction.dot(from) * w - direction.dot(to) * v) / turn;
    if (piece.side == 0 && height >= -rounding && !piece.isInside(-turn)) top = std::min(top, height);
    if (piece.side == 1 && height <= rounding && !piece.isInside(turn)) bottom = std::max(bottom, height);
  }
  const double thickness = (std::isfinite(top) ? top : 0) - (std::isfinite(bottom) ? bottom : 0);
  if (!std::isfinite(top)) top = direction.dot(a_.centre - point) + a_.radius;
  if (!std::isfinite(bottom)) bottom = direction.dot(b_.centre - point) - b_.radius;
  return {top - bottom, thickness};
}

void ExitLength::spend(std::size_t steps) {
  is_spent_ = is_spent_ || steps_left_ < steps;
  steps_left_ -= is_spent_ ? 0 : steps;
}

ExitLength::Result ExitLength::along(const Vec2& direction, double enough) {
  const auto unknown = [] {
    Result none;
    none.length = kInfinity;
    return none;
  };
  spend(kStepsToSee * pieces_.size());
  if (is_spent_) return unknown();
  Result result;
  see(direction);
  active_.clear();
  auto next = order_.begin();
  auto place = places_.begin();
  double from = -kInfinity;
  while (place != places_.end() && !is_spent_ && !(result.length > enough)) {
    active_.erase(std::remove_if(active_.begin(), active_.end(),
                                 [&](const Seen* seen) { return seen->high <= from + thin_ / 2; }),
                  active_.end());
    for (; next != order_.end() && next->first <= from + thin_ / 2; ++next) active_.push_back(&seen_[next->second]);
    while (place != places_.end() && !(*place > from + thin_)) ++place;
    if (place == places_.end()) break;
    const double to = next != order_.end() ? std::min(*place, next->first) : *place;
    look(from, to, result);
    from = to;
  }
  if (is_spent_) return unknown();
  result.inside = result.inside.x() * Vec2(-direction.y(), direction.x()) + result.inside.y() * direction;
  return result;
}

}  // namespace tricover::detail
