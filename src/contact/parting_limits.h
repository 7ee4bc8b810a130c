// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/boundary_curves.h"
#include "contact/translation_probe.h"
#include "contact/translation_search.h"

namespace tricover::detail {

/// The shortest translation known so far.
struct BestParting {
  ShortestParting found;
  double length;     ///< of its limit
  double error = 0;  ///< what the limit may be off by

  void improve(const Vec2& limit, const Vec2& parting, double limit_error = 0) {
    if (!(limit.norm() < length)) return;
    length = limit.norm();
    error = limit_error;
    found.limit = limit;
    found.parting = parting;
  }
};

/// Which points of an arrangement of curves free translations come near to, by samples beside them.
class PartingLimits {
 public:
  /// How far beside a point it looks for samples, by the radius of the square's circumcircle: curves beyond the square
  /// matter so far.
  static constexpr double kRoom = 0.02;

  /// Curves nearer to each other than `resolution` are one.
  PartingLimits(const TranslationSpace& space, double resolution)
      : margin_(space.margin()), noise_(space.noise()), resolution_(resolution) {}

  /// Looks at all that may be the nearest limit in a square, of a circumcircle of that radius, if the curves are all
  /// that come near it: the nearest point of a free face of the curves' arrangement is the nearest point, an end or a
  /// crossing of them. False if some are yet to be found in its parts.
  ///
  /// reach: how far away from 0 it looks, at least as far as the best is; then, how far away nothing is free.
  bool find(const BoundaryCurves& curves, const Vec2& center, double half, double radius, TranslationProbe& probe,
            BestParting& best, double& reach);

 private:
  struct PossibleLimit {
    Vec2 p;
    double error;  ///< of p, along the lines that cross there
  };

  bool decideTouch(const Vec2& p, const Vec2& along, double radius, TranslationProbe& probe, BestParting& best) const;
  bool decide(const PossibleLimit& limit, const BoundaryCurves& curves, double radius, TranslationProbe& probe,
              BestParting& best, double& reach);

  const double margin_, noise_, resolution_;
  std::vector<PossibleLimit> limits_;
  std::vector<BoundaryCurves::Ray> rays_;
};

}  // namespace tricover::detail
