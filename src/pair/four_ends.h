// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/predicates.h"

namespace tricover::detail {

inline bool sameSide(int s, int t) { return s == t && (s == 1 || s == -1); }

/// Two segments. Their ends are 0 and 1 of the first, 2 and 3 of the second: as filters see them, and as they are.
struct FourEnds {
  PosedPoint exact(int p) const { return p < 2 ? first[p] : second[p - 2]; }
  int filter(int p, int q, int r) const { return orientFilter(approx[p], approx[q], approx[r]); }
  int resolve(int sign, int p, int q, int r) const {
    return sign != kUncertain ? sign : orientExact(exact(p), exact(q), exact(r));
  }
  /// The sign of the signed area |p q r|. Exact.
  int sign(int p, int q, int r) const { return resolve(filter(p, q, r), p, q, r); }
  bool between(int p, int v, int w) const { return betweenExact(exact(p), exact(v), exact(w)); }

  /// Whether the two segments share a point. Exact.
  bool meet() const {
    int p = filter(0, 1, 2), q = filter(0, 1, 3);
    if (sameSide(p, q)) return false;
    int v = filter(2, 3, 0), w = filter(2, 3, 1);
    if (sameSide(v, w)) return false;
    p = resolve(p, 0, 1, 2);
    q = resolve(q, 0, 1, 3);
    if (sameSide(p, q)) return false;
    v = resolve(v, 2, 3, 0);
    w = resolve(w, 2, 3, 1);
    if (sameSide(v, w)) return false;
    if (p != 0 || q != 0 || v != 0 || w != 0) return true;
    // Collinear, or a single point on the other's line (repair 6): they meet where an end of one lies between the
    // other's.
    return between(0, 2, 3) || between(1, 2, 3) || between(2, 0, 1) || between(3, 0, 1);
  }

  ApproxPoint approx[4];
  PosedSegment first, second;
};

}  // namespace tricover::detail
