// SPDX-License-Identifier: BSD-3-Clause
#include "contact/shortest_exit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

/// One of twelve, with the axes' directions in the middles of four.
std::size_t sectorOf(const Vec2& normal) {
  const bool is_flat = std::abs(normal.x()) > std::abs(normal.y());
  const double along = is_flat ? normal.x() : normal.y(), aside = is_flat ? normal.y() : normal.x();
  const auto third = static_cast<std::size_t>(std::clamp(1.5 + 1.5 * aside / std::abs(along), 0.0, 2.0));
  return (is_flat ? 0u : 6u) + (along > 0 ? 0u : 3u) + third;
}

/// Two edges are passed at once, and more edges are looked at, where a component has no more pieces.
constexpr std::size_t kMostPiecesOfCorners = 48;

class ExitSearch {
 public:
  ExitSearch(const std::vector<OutlinePiece>& pieces, const ExitLength::Disc& a, const ExitLength::Disc& b,
             double error)
      : pieces_(pieces), towards_b_(b.centre - a.centre), same_(4 * error), lengths_(pieces, a, b, error) {}

  OutlineExit find() {
    findNormals();
    if (sum_.norm() > 0x1p-20 * total_) descend(sum_.normalized());
    double thinnest = kInfinity;
    for (const Vec2& normal : normals_) {
      if (lengths_.isSpent()) break;
      const ExitLength::Through through =
          is_inside_known_ ? lengths_.throughPoint(inside_, normal) : ExitLength::Through{0, kInfinity};
      thinnest = std::min(thinnest, through.thickness);
      if (!(through.length > best_.length + same_)) descend(normal);
    }
    // Where the component is much thinner somewhere, more than one edge is in the way.
    const bool is_small = pieces_.size() <= kMostPiecesOfCorners;
    if (is_small && thinnest < (best_.is_across ? 0.5 : 0.9) * best_.length) tryPairs();
    const bool has_ends = best_.found.top != nullptr && best_.found.bottom != nullptr;
    const bool is_doubtful = is_small && (thinnest < 0.5 * best_.length || !has_ends);
    if (!has_ends) {
      if (!towards_b_.isZero(0)) normals_.push_back(towards_b_.stableNormalized());
      for (const Vec2& normal : normals_) offer(normal, lengths_.atMost(normal));
    }
    best_.is_doubtful = is_doubtful;
    return best_;
  }

 private:
  /// The normals along which b leaves a: those of the longest piece of each sector. And the sum of all.
  void findNormals() {
    constexpr std::size_t kSectors = 12;
    double longest[kSectors] = {};
    Vec2 normals[kSectors];
    const auto add = [&](const Vec2& normal, double length) {
      total_ += length;
      sum_ += length * normal;
      const std::size_t k = sectorOf(normal);
      if (length > longest[k]) longest[k] = length, normals[k] = normal;
    };
    for (const OutlinePiece& piece : pieces_) {
      const Vec2 way = piece.way();
      const double size = way.norm(), length = size * (piece.on.high - piece.on.low);
      const Vec2 left = Vec2(-way.y(), way.x()) / size;
      if (piece.side == 0 ? !piece.left : !piece.right) add(left, length);
      if (piece.side == 0 ? !piece.right : !piece.left) add(-left, length);
    }
    for (std::size_t k = 0; k < kSectors; ++k)
      if (longest[k] > 0) normals_.push_back(normals[k]);
  }

  /// Follows the outlines from a direction to where the exit is shortest around there: beyond the edges that the exits
  /// so far must pass.
  void descend(const Vec2& first) {
    constexpr int kMostSteps = 5;
    Vec2 direction = first;
    std::vector<Wall> walls;
    for (int step = 0; step < kMostSteps; ++step) {
      const ExitLength::Result found = lengths_.along(direction, best_.length + same_);
      const OutlinePiece* passed = found.is_top_corner ? found.bottom : found.top != nullptr ? found.top : found.bottom;
      if (passed == nullptr || found.length > best_.length + same_) return;
      inside_ = found.inside;
      is_inside_known_ = true;
      offer(direction, found);
      const Vec2 way = passed->way();
      Vec2 normal = Vec2(-way.y(), way.x()).stableNormalized();
      if (normal.dot(direction) < 0) normal = -normal;
      walls.push_back({normal, found.length * normal.dot(direction)});
      const std::optional<Vec2> next = beyondAll(walls, same_ / 4);
      if (!next || !(next->norm() < found.length - same_)) return;
      direction = next->stableNormalized();
    }
  }

  /// Beyond two walls at once, each as far as an edge of one region reaches into the other one across it.
  void tryPairs() {
    std::vector<Wall> walls;
    for (const Vec2& normal : normals_) {
      const ExitLength::Result found = lengths_.along(normal, kInfinity);
      for (const double own : found.own)
        if (own > 0 && !lengths_.isSpent()) walls.push_back({normal, own});
    }
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < walls.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Vec2 corner = whereTheyMeet(walls[i], walls[j]);
        if (corner.allFinite() && corner.norm() < best_.length) corners.push_back(corner);
      }
    std::sort(corners.begin(), corners.end(),
              [](const Vec2& v, const Vec2& w) { return v.squaredNorm() < w.squaredNorm(); });
    constexpr std::size_t kMost = 8;
    for (std::size_t k = 0; k < std::min(corners.size(), kMost); ++k)
      if (corners[k].norm() < best_.length - same_) descend(corners[k].stableNormalized());
  }

  void offer(const Vec2& direction, const ExitLength::Result& found) {
    if (!(found.length > -kInfinity)) return;
    const bool leads_away = direction.dot(towards_b_) > best_.normal.dot(towards_b_);
    const bool is_known = best_.length < kInfinity && direction == best_.normal;
    if (!(found.length < best_.length - same_ || (found.length <= best_.length + same_ && (leads_away || is_known))))
      return;
    const auto isAcross = [&](const OutlinePiece* piece) {
      return piece != nullptr && std::abs(piece->way().dot(direction)) <= ExitLength::kSameAngle * piece->way().norm();
    };
    const bool of_a = isAcross(found.top);
    best_ = {direction, found.length, found, of_a || isAcross(found.bottom), of_a || !isAcross(found.bottom), false};
  }

  const std::vector<OutlinePiece>& pieces_;
  const Vec2 towards_b_;
  const double same_;  ///< lengths that are no farther apart are equal
  ExitLength lengths_;
  std::vector<Vec2> normals_;
  Vec2 sum_ = Vec2::Zero(), inside_ = Vec2::Zero();
  double total_ = 0;
  bool is_inside_known_ = false;
  OutlineExit best_;
};

}  // namespace

OutlineExit shortestExit(const std::vector<OutlinePiece>& pieces, const ExitLength::Disc& a, const ExitLength::Disc& b,
                         double error) {
  return ExitSearch(pieces, a, b, error).find();
}

}  // namespace tricover::detail
