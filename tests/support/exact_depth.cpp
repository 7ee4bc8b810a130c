// SPDX-License-Identifier: BSD-3-Clause
#include "exact_depth.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "exact_plane.h"

namespace tricover::exact {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
/// Of the size: what coordinates are off by, and where the search may end.
constexpr Real kRounding = 0x1p-61L, kEnough = 0x1p-59L;
constexpr int kMostSteps = 30000;
constexpr int kSectors = 12;

/// A triangle, or a piece of an edge, or a point: corners may be equal. Of the border, `near` are those that may be
/// nearest to a point of it.
struct Cell {
  std::array<Spot, 3> corner;
  std::vector<int> near;
  Real bound;
};
bool operator<(const Cell& p, const Cell& q) { return p.bound < q.bound; }

/// A border's segment as seen from a cell: its distance is convex, so no mean of distances is larger in the cell than
/// at a corner.
struct Feature {
  int segment;
  Real at_center;
  std::array<Real, 3> at_corner;
  Spot slope;  ///< The distance's gradient at the center, along the cell.
};

class Search {
 public:
  explicit Search(const RealOverlay& plane) : border_(plane.border) {
    std::vector<int> all;
    for (int i = 0; i < static_cast<int>(border_.size()); ++i) all.push_back(i);
    for (const auto& corner : plane.cells) push({corner, all, kInfinity});
  }

  Bracket run() {
    for (int steps = 0; !open_.empty() && open_.top().bound > low_ + kEnough * std::max(low_, 0x1p-3L); ++steps) {
      if (steps == kMostSteps) return {low_, open_.top().bound};
      const Cell cell = open_.top();
      open_.pop();
      halve(cell);
    }
    return {low_, open_.empty() ? low_ : std::max(low_, open_.top().bound)};
  }

 private:
  Real distanceAt(const Spot& p, const std::vector<int>& near) const {
    Real least = kInfinity;
    for (const int i : near) least = std::min(least, distanceFrom(border_[static_cast<std::size_t>(i)], p));
    return least;
  }
  Spot slopeAt(int segment, const Spot& p) const {
    const Spot off = p - nearestOn(border_[static_cast<std::size_t>(segment)], p);
    const Real length = norm(off);
    return length > 0 ? (1 / length) * off : Spot{0, 0};
  }

  void halve(const Cell& cell) {
    std::size_t longest = 0;
    Real most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real length = norm(cell.corner[(i + 1) % 3] - cell.corner[i]);
      if (length > most) most = length, longest = i;
    }
    const Spot p = cell.corner[longest], q = cell.corner[(longest + 1) % 3], r = cell.corner[(longest + 2) % 3],
               middle = 0.5L * (p + q);
    const bool is_flat = norm(r - q) == 0 || norm(r - p) == 0;
    push({is_flat ? std::array<Spot, 3>{p, middle, middle} : std::array<Spot, 3>{p, middle, r}, cell.near, cell.bound});
    push({is_flat ? std::array<Spot, 3>{middle, q, q} : std::array<Spot, 3>{middle, q, r}, cell.near, cell.bound});
  }

  /// Keeps of the border what may be nearest, and bounds the distance.
  void push(Cell cell) {
    const auto& c = cell.corner;
    const Spot center =
        (c[1].x == c[2].x && c[1].y == c[2].y) ? 0.5L * (c[0] + c[1]) : (1 / 3.0L) * (c[0] + c[1] + c[2]);
    Real radius = 0;
    for (const Spot& p : c)
      radius = std::max(radius, norm(p - center)), low_ = std::max(low_, distanceAt(p, cell.near));
    const Real here = distanceAt(center, cell.near);
    low_ = std::max(low_, here);
    cell.bound = std::min(cell.bound, here + radius);
    if (cell.bound <= low_) return;
    std::vector<int> near;
    std::vector<Feature> features;
    for (const int i : cell.near) {
      const Segment& s = border_[static_cast<std::size_t>(i)];
      const Real distance = distanceFrom(s, center);
      if (distance > here + 2 * radius + kRounding) continue;
      near.push_back(i);
      features.push_back({i, distance, {distanceFrom(s, c[0]), distanceFrom(s, c[1]), distanceFrom(s, c[2])}, {}});
      cell.bound = std::min(cell.bound, meanBound({&features.back()}, {1}));
    }
    cell.near = std::move(near);
    if (cell.bound > low_) boundByMeans(cell, center, facing(features, cell, center));
    if (cell.bound > low_) open_.push(std::move(cell));
  }

  static Real meanBound(const std::vector<const Feature*>& of, const std::vector<Real>& share) {
    Real most = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Real mean = 0;
      for (std::size_t i = 0; i < of.size(); ++i) mean += share[i] * of[i]->at_corner[corner];
      most = std::max(most, mean);
    }
    return most;
  }

  /// The nearest feature in each direction.
  std::vector<Feature> facing(const std::vector<Feature>& all, const Cell& cell, const Spot& center) const {
    const Spot along = cell.corner[1] - cell.corner[0];
    const bool is_flat = norm(cell.corner[2] - cell.corner[1]) == 0;
    std::optional<Feature> nearest[kSectors];
    for (Feature f : all) {
      f.slope = slopeAt(f.segment, center);
      if (is_flat) f.slope = norm(along) > 0 ? (dot(f.slope, along) / dot(along, along)) * along : Spot{0, 0};
      const Real turn = std::atan2(f.slope.y, f.slope.x) / (2 * 3.14159265358979323846L) + 0.5L;
      auto& slot = nearest[std::min(kSectors - 1, static_cast<int>(turn * kSectors))];
      if (!slot || f.at_center < slot->at_center) slot = f;
    }
    std::vector<Feature> result;
    for (const auto& f : nearest)
      if (f) result.push_back(*f);
    return result;
  }

  /// Means of two or three distances whose slopes cancel out: the cell's distances are hardly more than they are at the
  /// middle. There, or near there, lies the farthest point.
  void boundByMeans(Cell& cell, const Spot& center, const std::vector<Feature>& features) {
    for (std::size_t i = 0; i < features.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Feature &f = features[i], &g = features[j];
        const Spot turn = f.slope - g.slope;
        const Real square = dot(turn, turn);
        if (square == 0) continue;
        const Real share = std::clamp<Real>(-dot(g.slope, turn) / square, 0, 1);
        improve(cell, center, {&f, &g}, {share, 1 - share});
        for (std::size_t k = 0; k < j; ++k) {
          const Feature& h = features[k];
          const Real fg = cross(f.slope, g.slope), gh = cross(g.slope, h.slope), hf = cross(h.slope, f.slope);
          const Real sum = fg + gh + hf;
          if (sum == 0 || fg / sum < 0 || gh / sum < 0 || hf / sum < 0) continue;
          improve(cell, center, {&f, &g, &h}, {gh / sum, hf / sum, fg / sum});
        }
      }
  }

  void improve(Cell& cell, const Spot& center, const std::vector<const Feature*>& of, const std::vector<Real>& share) {
    const Real bound = meanBound(of, share);
    if (bound >= cell.bound) return;
    cell.bound = bound;
    if (bound > low_) climb(cell, center, of);
  }

  /// Newton's steps to where two or three are equally far.
  void climb(const Cell& cell, const Spot& center, const std::vector<const Feature*>& of) {
    Spot p = center;
    const Spot along = cell.corner[1] - cell.corner[0];
    const bool is_flat = norm(cell.corner[2] - cell.corner[1]) == 0;
    for (int step = 0; step < 6; ++step) {
      const auto distance = [&](std::size_t i) {
        return distanceFrom(border_[static_cast<std::size_t>(of[i]->segment)], p);
      };
      Spot slope[3];
      for (std::size_t i = 0; i < of.size(); ++i) slope[i] = slopeAt(of[i]->segment, p);
      const Spot s = slope[1] - slope[0];
      const Real left = distance(0) - distance(1);
      if (of.size() == 3 && !is_flat) {
        const Spot t = slope[2] - slope[0];
        const Real other = distance(0) - distance(2), determinant = cross(s, t);
        if (determinant == 0) return;
        p = p + (1 / determinant) * Spot{left * t.y - other * s.y, other * s.x - left * t.x};
      } else {
        const Spot way = is_flat ? along : s;
        if (dot(s, way) == 0) return;
        p = p + (left / dot(s, way)) * way;
      }
    }
    if (isIn(cell, p)) low_ = std::max(low_, distanceAt(p, cell.near));
  }

  static bool isIn(const Cell& cell, const Spot& p) {
    const auto& c = cell.corner;
    if (norm(c[2] - c[1]) == 0) return norm(nearestOn({c[0], c[1]}, p) - p) <= kRounding;
    const Real turn = cross(c[1] - c[0], c[2] - c[0]) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Spot side = c[(i + 1) % 3] - c[i];
      if (!(turn * cross(side, p - c[i]) >= 0)) return false;
    }
    return true;
  }

  const std::vector<Segment>& border_;
  std::priority_queue<Cell> open_;
  Real low_ = 0;
};

Bracket search(const Overlay& exact) {
  if (exact.is_infinite) return {kInfinity, kInfinity};
  if (exact.cells.empty()) return {0, 0};
  const RealOverlay plane(exact);
  const Bracket found = Search(plane).run();
  const Real low = std::max(std::ldexp(found.low, plane.exponent), std::numeric_limits<Real>::min());
  return {low, std::max(low, std::ldexp(found.high + kRounding, plane.exponent))};
}

Real toReal(const mpq_class& q) {
  const double high = q.get_d();
  const mpq_class rest = q - high;
  return Real{high} + rest.get_d();
}

mpq_class timesPower(const mpq_class& q, int exponent) {
  return exponent >= 0 ? mpq_class(q << static_cast<mp_bitcnt_t>(exponent))
                       : mpq_class(q >> static_cast<mp_bitcnt_t>(-exponent));
}

}  // namespace

RealOverlay::RealOverlay(const Overlay& exact) {
  const WorldPoint origin = exact.cells[0][0];
  mpq_class size = 0;
  const auto grow = [&](const WorldPoint& p) {
    size = std::max(size, std::max(mpq_class(abs(p.x - origin.x)), mpq_class(abs(p.y - origin.y))));
  };
  for (const auto& cell : exact.cells) std::for_each(cell.begin(), cell.end(), grow);
  for (const WorldSegment& s : exact.border) grow(s.v), grow(s.w);
  // A power of two between half the size and twice the size.
  exponent = static_cast<int>(mpz_sizeinbase(size.get_num_mpz_t(), 2)) -
             static_cast<int>(mpz_sizeinbase(size.get_den_mpz_t(), 2));
  const auto place = [&](const WorldPoint& p) {
    return Spot{toReal(timesPower(p.x - origin.x, -exponent)), toReal(timesPower(p.y - origin.y, -exponent))};
  };
  for (const auto& cell : exact.cells) cells.push_back({place(cell[0]), place(cell[1]), place(cell[2])});
  for (const WorldSegment& s : exact.border) border.push_back({place(s.v), place(s.w)});
}

Bracket excess(const Polygon& part, const Pose& pose_part, const Polygon& area, const Pose& pose_area) {
  return search(overlay(part, pose_part, area, pose_area, Target::Region));
}

Bracket depthIn(const Polygon& part, const Pose& pose_part, const Polygon& region, const Pose& pose_region) {
  return search(overlay(part, pose_part, region, pose_region, Target::Outside));
}

Bracket depth(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const Bracket of_a = depthIn(a, pose_a, b, pose_b), of_b = depthIn(b, pose_b, a, pose_a);
  return {std::max(of_a.low, of_b.low), std::max(of_a.high, of_b.high)};
}

bool reachInto(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const auto reaches = [](const Overlay& found) { return found.is_infinite || !found.cells.empty(); };
  return reaches(overlay(a, pose_a, b, pose_b, Target::Outside)) ||
         reaches(overlay(b, pose_b, a, pose_a, Target::Outside));
}

}  // namespace tricover::exact
