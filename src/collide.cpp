// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/collide.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "strategy.h"

namespace tricover {
namespace detail {
namespace {

void checkLength(double length, const char* message) {
  if (!(length >= 0 && std::isfinite(length))) throw std::invalid_argument(message);
}

/// The kernel's own order, so that neither answers nor facts depend on the caller's: the smaller polygon moves.
bool inOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b) {
  if (a.id != b.id) return a.radius != b.radius ? a.radius > b.radius : a.id < b.id;
  const double *p = pose_a.data(), *q = pose_b.data();
  return !std::lexicographical_compare(p, p + 9, q, q + 9);
}

/// At most how far any point of b has moved in a's frame since the fact was found: |M - M0|_F r + |c - c0|, c being b's
/// origin, and rounding. It bounds the way of every point along the straight path between the two relative poses, too:
/// edges whose gap outlasts it never touch on that way, and no ring passes from inside to outside.
double motionSince(const PairCache& fact, const PosedPair& pair) {
  const double* p = fact.pose;
  const double m00 = pair.m00 - p[0], m10 = pair.m10 - p[1], m01 = pair.m01 - p[2], m11 = pair.m11 - p[3];
  const double x = pair.b.origin.x(), y = pair.b.origin.y();
  const double cx = m00 * x + m01 * y + (pair.tx - p[4]), cy = m10 * x + m11 * y + (pair.ty - p[5]);
  const double turn = std::sqrt(m00 * m00 + m10 * m10 + m01 * m01 + m11 * m11) + 0x1p-500;
  return (turn * pair.b.radius + std::sqrt(cx * cx + cy * cy)) * (1 + 16 * kUlp) + pair.slack + 0x1p-500;
}

void remember(PairCache& cache, const PosedPair& pair, const Outcome& outcome) {
  const double pose[6] = {pair.m00, pair.m10, pair.m01, pair.m11, pair.tx, pair.ty};
  std::copy(pose, pose + 6, cache.pose);
  cache.clearance = outcome.clearance - pair.slack;  // the slack pays for the rounding of the pose kept here
  cache.overlapping = outcome.collides && cache.clearance > 0;
  cache.uses = 0;
}

bool collideInOrder(const PosedPair& pair, PairCache* cache, const CollideOptions& options) {
  if (pair.discGap() * (1 - pair.scale_defect) > options.margin) return false;
  if (options.strategy == Strategy::Paper) return collideByPaper(pair, cache, options);
  if (cache == nullptr) return collideByHierarchy(pair, options, 0).collides;

  double lookahead = 0;
  if (recall(*cache, pair)) {
    const double motion = motionSince(*cache, pair);
    const double left = (cache->clearance - motion) * (1 - pair.scale_defect);
    if (left > 0 && (cache->overlapping || left > options.margin)) {
      ++cache->uses;
      return cache->overlapping;
    }
    if (cache->first_edge >= 0 && cache->second_edge >= 0 &&
        edgesWithin(pair, static_cast<std::size_t>(cache->first_edge), static_cast<std::size_t>(cache->second_edge),
                    options.margin, options.tolerance)) {
      ++cache->uses;
      return true;
    }
    // Look ahead so that the next fact pays for a good many steps like those since the last one; after a jump no fact
    // would.
    constexpr double kStepsAhead = 32;
    const double ahead = kStepsAhead * motion / (cache->uses + 1.0);
    if (ahead <= 0.25 * pair.b.radius) lookahead = ahead;
  }
  const Outcome outcome = collideByHierarchy(pair, options, lookahead);
  remember(*cache, pair, outcome);
  cache->first_edge = outcome.edge_a;
  cache->second_edge = outcome.edge_b;
  return outcome.collides;
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache* cache,
             const CollideOptions& options) {
  checkPose(pose_a, "pose_a");
  checkPose(pose_b, "pose_b");
  checkLength(options.margin, "margin: it must be finite and not negative");
  checkLength(options.tolerance, "tolerance: it must be finite and not negative");
  if (inOrder(a.data(), pose_a, b.data(), pose_b))
    return collideInOrder(PosedPair(a.data(), pose_a, b.data(), pose_b), cache, options);
  return collideInOrder(PosedPair(b.data(), pose_b, a.data(), pose_a), cache, options);
}

}  // namespace

bool recall(PairCache& cache, const PosedPair& pair) {
  if (cache.first_id == pair.a.id && cache.second_id == pair.b.id) return true;
  cache = PairCache();
  cache.first_id = pair.a.id;
  cache.second_id = pair.b.id;
  return false;
}

}  // namespace detail

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
             const CollideOptions& options) {
  return detail::collide(a, pose_a, b, pose_b, nullptr, options);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
             const CollideOptions& options) {
  return detail::collide(a, pose_a, b, pose_b, &cache, options);
}

}  // namespace tricover
