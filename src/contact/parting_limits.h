// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/boundary_lines.h"
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

/// Which points of an arrangement of lines free translations come near to, by samples beside them.
class PartingLimits {
 public:
  /// Lines nearer to each other than `resolution` count as one.
  PartingLimits(const TranslationSpace& space, double resolution) : noise_(space.noise()), resolution_(resolution) {}

  /// Looks at all points that may be the nearest limit in a square, if the lines are all that come within
  /// `surroundings` of it. The nearest point of a free face of the lines' arrangement is the nearest point, an end or a
  /// crossing of them. False if the square's quarters have to be searched.
  bool find(const BoundaryLines& lines, const Vec2& center, double half, double surroundings, TranslationProbe& probe,
            BestParting& best);

 private:
  /// How far beside a point it looks for samples: the rest is for lines that count as one with others.
  static constexpr double kRoom = 0.64;

  struct PossibleLimit {
    Vec2 p;
    double error;  ///< of p, along the lines that cross there
  };

  bool decide(const PossibleLimit& limit, const BoundaryLines& lines, double room, TranslationProbe& probe,
              BestParting& best);

  const double noise_, resolution_;
  std::vector<PossibleLimit> limits_;
  std::vector<BoundaryLines::Ray> rays_;
};

}  // namespace tricover::detail
