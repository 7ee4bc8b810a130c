// SPDX-License-Identifier: BSD-3-Clause
#include "posed_pair.h"

#include <limits>

#include "covering.h"

namespace tricover::detail {
namespace {

/// An upper bound of |singular value - 1| of a matrix with these columns: the eigenvalues of M^T M are within
/// max(|c0.c0 - 1|, |c1.c1 - 1|) + |c0.c1| of 1, and |s - 1| <= |s^2 - 1|. 16 kUlp cover the rounding here.
double rigidDefect(double xx, double yx, double xy, double yy) {
  return std::max(std::abs(xx * xx + yx * yx - 1), std::abs(xy * xy + yy * yy - 1)) + std::abs(xx * xy + yx * yy) +
         16 * kUlp;
}

}  // namespace

// Error of the mapping p -> M p + t. With d = 1 / det R_a, near +-1, the entries of adj(R_a) are those of R_a: exact.
// M = d adj(R_a) R_b: two products (U each, their magnitudes sum to at most 1 + 2e-6), a sum (U), the division (U),
// det's own error (3U): at most 8U an entry. t: the same 6U beside U for the rounded difference t_b - t_a, at most 10U
// |t_b - t_a|_1. Applying it: two products and two sums, at most 3U (|p|_1 + |t|_1). In all 13U (|p|_1 + |t_b -
// t_a|_1); 16U and kTiny are used, the latter for underflow. R^-1 is the true inverse, so a pose's defect from
// orthonormality is no error here; it enters `defect` and `scale_defect`.
PosedPair::PosedPair(const PolygonData& a_, const Pose& pose_a_, const PolygonData& b_, const Pose& pose_b_)
    : a(a_), b(b_), pose_a(pose_a_), pose_b(pose_b_) {
  const auto &ra = pose_a.matrix(), &rb = pose_b.matrix();
  const double det = ra(0, 0) * ra(1, 1) - ra(0, 1) * ra(1, 0);
  const double dx = rb(0, 2) - ra(0, 2), dy = rb(1, 2) - ra(1, 2);
  m00 = (ra(1, 1) * rb(0, 0) - ra(0, 1) * rb(1, 0)) / det;
  m01 = (ra(1, 1) * rb(0, 1) - ra(0, 1) * rb(1, 1)) / det;
  m10 = (ra(0, 0) * rb(1, 0) - ra(1, 0) * rb(0, 0)) / det;
  m11 = (ra(0, 0) * rb(1, 1) - ra(1, 0) * rb(0, 1)) / det;
  tx = (ra(1, 1) * dx - ra(0, 1) * dy) / det;
  ty = (ra(0, 0) * dy - ra(1, 0) * dx) / det;
  handed = det < 0 ? -1 : 1;
  error = 16 * kUlp * (b.extent + std::abs(dx) + std::abs(dy)) + kTiny;
  defect = rigidDefect(m00, m10, m01, m11);
  scale_defect = rigidDefect(ra(0, 0), ra(1, 0), ra(0, 1), ra(1, 1));
  const ApproxPoint center = fromB(b.origin);
  center_x = center.x;
  center_y = center.y;
  radius_b = b.radius * (1 + defect) * (1 + 4 * kUlp);
  // Mapping errs by `error` in both coordinates; a box of b is mapped as a rectangle of unchanged size, which misplaces
  // its corners by at most 3 defects of its diagonal; sums over boxes round by a few U of the lengths involved.
  const double apart = std::abs(center_x - a.origin.x()) + std::abs(center_y - a.origin.y());
  slack = 4 * error + 8 * defect * b.radius + 64 * kUlp * (a.radius + b.radius + apart) + kTiny;
}

namespace {

/// The four ends of two edges, as the filters see them and as they are.
struct EdgePair {
  EdgePair(const PosedPair& pair, std::size_t i, std::size_t j)
      : exact{{&pair.pose_a, pair.a.path[i]},
              {&pair.pose_a, pair.a.path[i + 1]},
              {&pair.pose_b, pair.b.path[j]},
              {&pair.pose_b, pair.b.path[j + 1]}},
        approx{PosedPair::fromA(pair.a.path[i]), PosedPair::fromA(pair.a.path[i + 1]), pair.fromB(pair.b.path[j]),
               pair.fromB(pair.b.path[j + 1])},
        handed(pair.handed) {}

  int filter(int p, int q, int r) const { return orientFilter(approx[p], approx[q], approx[r]); }
  int resolve(int sign, int p, int q, int r) const {
    return sign != kUncertain ? sign : handed * orientExact(exact[p], exact[q], exact[r]);
  }
  bool between(int p, int v, int w) const { return betweenExact(exact[p], exact[v], exact[w]); }

  PosedPoint exact[4];
  ApproxPoint approx[4];
  int handed;
};

bool sameSide(int s, int t) { return s == t && (s == 1 || s == -1); }

bool meet(const EdgePair& ends) {
  int p = ends.filter(0, 1, 2), q = ends.filter(0, 1, 3);
  if (sameSide(p, q)) return false;
  int v = ends.filter(2, 3, 0), w = ends.filter(2, 3, 1);
  if (sameSide(v, w)) return false;
  p = ends.resolve(p, 0, 1, 2);
  q = ends.resolve(q, 0, 1, 3);
  if (sameSide(p, q)) return false;
  v = ends.resolve(v, 2, 3, 0);
  w = ends.resolve(w, 2, 3, 1);
  if (sameSide(v, w)) return false;
  if (p != 0 || q != 0 || v != 0 || w != 0) return true;
  // Collinear, or a single point on the other's line (repair 6): they meet where an end of one lies between the
  // other's.
  return ends.between(0, 2, 3) || ends.between(1, 2, 3) || ends.between(2, 0, 1) || ends.between(3, 0, 1);
}

/// Distance from a point to a segment in plain doubles; NaN where squares leave the range of doubles.
double pointSegmentDistance(const ApproxPoint& p, const ApproxPoint& v, const ApproxPoint& w) {
  const double ux = w.x - v.x, uy = w.y - v.y, dx = p.x - v.x, dy = p.y - v.y;
  const double square = ux * ux + uy * uy, along = dx * ux + dy * uy;
  if (!(square > 0x1p-960 && square < 0x1p1000 && std::abs(along) < 0x1p1000))
    return ux == 0 && uy == 0 ? std::hypot(dx, dy) : std::numeric_limits<double>::quiet_NaN();
  const double s = std::clamp(along / square, 0.0, 1.0);
  return std::hypot(dx - s * ux, dy - s * uy);
}

}  // namespace

bool edgesMeet(const PosedPair& pair, std::size_t i, std::size_t j) { return meet(EdgePair(pair, i, j)); }

bool edgesWithin(const PosedPair& pair, std::size_t i, std::size_t j, double reach, double tolerance) {
  const EdgePair ends(pair, i, j);
  if (reach == 0 && tolerance == 0) return meet(ends);
  // The rounded distance d between an end and the other edge. An upper bound always holds; as a lower bound it holds
  // unless the edges cross, so that is asked first. NaN decides nothing.
  const ApproxPoint* e = ends.approx;
  const double ends_apart[] = {pointSegmentDistance(e[0], e[2], e[3]), pointSegmentDistance(e[1], e[2], e[3]),
                               pointSegmentDistance(e[2], e[0], e[1]), pointSegmentDistance(e[3], e[0], e[1])};
  double d = ends_apart[0];
  for (double apart : ends_apart) d = std::isnan(apart) || apart < d ? apart : d;
  const double length =
      std::max(std::hypot(e[1].x - e[0].x, e[1].y - e[0].y), std::hypot(e[3].x - e[2].x, e[3].y - e[2].y));
  const double err = 8 * pair.error + 64 * kUlp * (length + d) + kTiny;
  if ((d + err) * (1 + pair.scale_defect) <= reach + tolerance) return true;
  if (meet(ends)) return true;
  if ((d - err) * (1 - pair.scale_defect) > reach) return false;
  const PosedPoint* x = ends.exact;
  return withinExact(x[0], x[2], x[3], reach) || withinExact(x[1], x[2], x[3], reach) ||
         withinExact(x[2], x[0], x[1], reach) || withinExact(x[3], x[0], x[1], reach);
}

Location locate(const PosedPair& pair, const Vec2& local) {
  return locateInCovering(pair.a, &pair.pose_a, pair.fromB(local), {&pair.pose_b, local}, pair.handed);
}

}  // namespace tricover::detail
