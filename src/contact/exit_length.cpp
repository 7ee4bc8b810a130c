// SPDX-License-Identifier: BSD-3-Clause
#include "contact/exit_length.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "numbers/angle.h"

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Edges that lean by less are across.
constexpr double kSameAngle = 0x1p-40;

}  // namespace

double ExitLength::Seen::heightAt(double place) const {
  const double t = std::clamp((place - low) / (high - low), 0.0, 1.0);
  return t < 0.5 ? low_height + t * rise : low_height + rise + (t - 1) * rise;
}

void ExitLength::see(const Vec2& direction) {
  const Vec2 aside(-direction.y(), direction.x());
  seen_.clear();
  places_.clear();
  highest_ = direction.dot(a_.centre) + a_.radius;
  lowest_ = direction.dot(b_.centre) - b_.radius;
  for (const OutlinePiece& piece : pieces_) {
    const double v = aside.dot(piece.edge.v), w = aside.dot(piece.edge.w);
    const double height_v = direction.dot(piece.edge.v), height_w = direction.dot(piece.edge.w);
    if (!(std::abs(w - v) > error_)) continue;
    const bool goes_up = v < w;  // its left is below
    const bool above = goes_up ? piece.right : piece.left, below = goes_up ? piece.left : piece.right;
    const double from = v + piece.on.low * (w - v), to = v + piece.on.high * (w - v);
    const double rise = goes_up ? height_w - height_v : height_v - height_w;
    seen_.push_back({&piece, std::min(v, w), std::max(v, w), goes_up ? height_v : height_w, rise, std::min(from, to),
                     std::max(from, to), piece.side == 0 && !above, piece.side == 1 && !below,
                     std::abs(rise) <= kSameAngle * std::abs(w - v) + error_});
    const Seen& seen = seen_.back();
    places_.insert(places_.end(), {seen.low, seen.high});
    if (seen.piece_low > seen.low + error_) places_.push_back(seen.piece_low);
    if (seen.piece_high < seen.high - error_) places_.push_back(seen.piece_high);
  }
  std::sort(seen_.begin(), seen_.end(), [](const Seen& p, const Seen& q) { return p.low < q.low; });
  std::sort(places_.begin(), places_.end());
}

/// On all lines between two places: no edge begins or ends there.
void ExitLength::look(double from, double to, Result& result) const {
  const double middle = 0.5 * from + 0.5 * to;
  for (const Seen* seen : active_) {
    if (!(seen->piece_low <= from + error_ && seen->piece_high >= to - error_)) continue;
    const double height = seen->heightAt(middle);
    const double rounding = 4 * error_ * (1 + std::abs(seen->rise) / (seen->high - seen->low));
    const Seen *top = nullptr, *bottom = nullptr;
    double top_height = kInfinity, bottom_height = -kInfinity;
    for (const Seen* edge : active_) {
      if (!(edge->is_exit || edge->is_entry) || !edge->spans(from, to, error_)) continue;
      const double at = edge->heightAt(middle);
      if (edge->is_exit && at >= height - rounding && at < top_height) top = edge, top_height = at;
      if (edge->is_entry && at <= height + rounding && at > bottom_height) bottom = edge, bottom_height = at;
    }
    const Seen* const ends[2] = {top, bottom};
    for (const double place : {from, to}) {
      const double length = (top != nullptr ? top->heightAt(place) : highest_) -
                            (bottom != nullptr ? bottom->heightAt(place) : lowest_);
      for (const int side : {0, 1})
        if (ends[side] != nullptr && ends[side]->is_across) result.own[side] = std::max(result.own[side], length);
      // Among lines that are equally long but for rounding, one where many are.
      const double width = to - from, same = 4 * error_;
      if (!(length > result.length + same || (length >= result.length - same && width > result.width))) continue;
      const auto endsThere = [&](const Seen* edge) {
        return edge == nullptr || std::abs(place - edge->low) <= 2 * error_ || std::abs(place - edge->high) <= 2 * error_;
      };
      result.length = std::max(length, result.length);
      result.width = width;
      result.top = top != nullptr ? top->piece : nullptr;
      result.bottom = bottom != nullptr ? bottom->piece : nullptr;
      result.place = place;
      result.is_top_corner = endsThere(top) && bottom != nullptr;
    }
  }
}

ExitLength::Result ExitLength::along(const Vec2& direction, double enough) {
  see(direction);
  Result result;
  active_.clear();
  auto next = seen_.begin();
  for (std::size_t k = 0; k < places_.size();) {
    const double from = places_[k];
    while (k < places_.size() && !(places_[k] > from + 2 * error_)) ++k;
    if (k == places_.size()) break;
    active_.erase(std::remove_if(active_.begin(), active_.end(),
                                 [&](const Seen* seen) { return seen->high <= from + error_; }),
                  active_.end());
    for (; next != seen_.end() && next->low <= from + error_; ++next) active_.push_back(&*next);
    look(from, places_[k], result);
    if (result.length > enough) break;
  }
  return result;
}

namespace {

/// Where normal.dot(v) is at least `length`.
struct Wall {
  Vec2 normal;
  double length;
};

Vec2 whereTheyMeet(const Wall& v, const Wall& w) {
  const double turn = cross(v.normal, w.normal);
  return Vec2(v.length * w.normal.y() - w.length * v.normal.y(), w.length * v.normal.x() - v.length * w.normal.x()) /
         turn;
}

/// The shortest translation beyond all walls; nothing if there is none.
std::optional<Vec2> beyondAll(const std::vector<Wall>& walls, double error) {
  std::optional<Vec2> best;
  const auto offer = [&](const Vec2& v) {
    if (!v.allFinite() || (best && best->norm() <= v.norm())) return;
    for (const Wall& wall : walls)
      if (wall.normal.dot(v) < wall.length - error) return;
    best = v;
  };
  for (std::size_t i = 0; i < walls.size(); ++i) {
    offer(walls[i].length * walls[i].normal);
    for (std::size_t j = 0; j < i; ++j) offer(whereTheyMeet(walls[i], walls[j]));
  }
  return best;
}

class ExitSearch {
 public:
  ExitSearch(const std::vector<OutlinePiece>& pieces, const ExitLength::Disc& a, const ExitLength::Disc& b,
             double error)
      : pieces_(pieces), towards_b_(b.centre - a.centre), error_(error), lengths_(pieces, a, b, error) {}

  ShortestExit find() {
    const std::vector<Wall> walls = normals();
    if (sum_.norm() > 0x1p-20 * total_) descend(sum_.normalized());
    double least = kInfinity;
    std::vector<Wall> own;
    for (const Wall& wall : walls) {
      const double length = descend(wall.normal);
      own.push_back({wall.normal, length});
      least = std::min(least, length);
    }
    if (best_.length > least + 4 * error_) tryPairs(own);
    return best_;
  }

 private:
  /// The normals of the pieces, one for each of some sectors, with the pieces' lengths. b leaves a along each of them.
  std::vector<Wall> normals() {
    constexpr int kSectors = 16;
    Wall longest[kSectors], all[kSectors];
    for (int k = 0; k < kSectors; ++k) longest[k] = all[k] = {Vec2::Zero(), 0};
    const auto add = [&](const Vec2& normal, double length) {
      const double turn = std::atan2(normal.y(), normal.x()) / (2 * kPi) + 0.5;
      const int k = static_cast<int>(turn * kSectors + 0.5) % kSectors;
      if (length > longest[k].length) longest[k] = {normal, length};
      all[k].length += length;
    };
    for (const OutlinePiece& piece : pieces_) {
      const Vec2 way = piece.way();
      const Vec2 left = Vec2(-way.y(), way.x()).stableNormalized();
      const double length = piece.length();
      const bool leaves_left = piece.side == 0 ? !piece.left : !piece.right,
                 leaves_right = piece.side == 0 ? !piece.right : !piece.left;
      if (leaves_left) add(left, length);
      if (leaves_right) add(-left, length);
      total_ += length;
      sum_ += ((leaves_left ? length : 0) - (leaves_right ? length : 0)) * left;
    }
    std::vector<Wall> result;
    for (int k = 0; k < kSectors; ++k)
      if (all[k].length > 0) result.push_back({longest[k].normal, all[k].length});
    std::sort(result.begin(), result.end(), [](const Wall& v, const Wall& w) { return v.length > w.length; });
    return result;
  }

  /// Follows the outlines from a direction to where the exit is shortest around there: beyond the edges that the exits
  /// so far have to pass. Returns the first direction's own length.
  double descend(const Vec2& first) {
    constexpr int kMostSteps = 5;
    Vec2 direction = first;
    std::vector<Wall> walls;
    double own = kInfinity;
    for (int step = 0; step < kMostSteps; ++step) {
      const ExitLength::Result found = lengths_.along(direction, step == 0 ? kInfinity : best_.length + 4 * error_);
        for (const double length : found.own)
        if (step == 0 && length > 0) own = std::min(own, length);
      offer(direction, found);
      const OutlinePiece* passed = found.is_top_corner ? found.bottom : found.top != nullptr ? found.top : found.bottom;
      if (passed == nullptr || found.length > best_.length + 4 * error_) break;
      const Vec2 way = passed->way();
      Vec2 normal = Vec2(-way.y(), way.x()).stableNormalized();
      if (normal.dot(direction) < 0) normal = -normal;
      walls.push_back({normal, found.length * normal.dot(direction)});
      const std::optional<Vec2> next = beyondAll(walls, error_);
      if (!next || !(next->norm() < found.length - 4 * error_)) break;
      direction = next->stableNormalized();
    }
    return own;
  }

  void tryPairs(const std::vector<Wall>& walls) {
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < walls.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Wall &v = walls[i], &w = walls[j];
        if (!std::isfinite(v.length + w.length)) continue;
        const Vec2 corner = whereTheyMeet(v, w);
        if (corner.allFinite() && corner.norm() < best_.length) corners.push_back(corner);
      }
    std::sort(corners.begin(), corners.end(), [](const Vec2& v, const Vec2& w) { return v.norm() < w.norm(); });
    constexpr std::size_t kMost = 8;
    for (std::size_t k = 0; k < std::min(corners.size(), kMost) && corners[k].norm() < best_.length - 4 * error_; ++k)
      descend(corners[k].stableNormalized());
  }

  void offer(const Vec2& direction, const ExitLength::Result& found) {
    if (!(found.length > -kInfinity)) return;
    const double same = 4 * error_;
    const bool leads_away = direction.dot(towards_b_) > best_.normal.dot(towards_b_);
    if (!(found.length < best_.length - same || (found.length <= best_.length + same && leads_away))) return;
    const auto isAcross = [&](const OutlinePiece* piece) {
      return piece != nullptr && std::abs(piece->way().stableNormalized().dot(direction)) <= kSameAngle;
    };
    best_ = {direction, found.length, found.top, found.bottom, found.place,
             isAcross(found.top) || !isAcross(found.bottom)};
  }

  const std::vector<OutlinePiece>& pieces_;
  const Vec2 towards_b_;
  const double error_;
  ExitLength lengths_;
  ShortestExit best_;
  Vec2 sum_ = Vec2::Zero();
  double total_ = 0;
};

}  // namespace

ShortestExit shortestExit(const std::vector<OutlinePiece>& pieces, const ExitLength::Disc& a, const ExitLength::Disc& b,
                          double error) {
  return ExitSearch(pieces, a, b, error).find();
}

}  // namespace tricover::detail
