// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "contact/translation_probe.h"

namespace tricover::detail {

/// What is left of a square once parallelograms have been taken away: convex parts.
class Uncovered {
 public:
  /// What is nowhere wider than `thin` doesn't count as left, nor what is within half of that of a parallelogram.
  Uncovered(const Vec2& center, double half, double thin);

  bool isEmpty() const { return parts_.empty(); }
  double area() const { return area_; }
  /// Inside one of the parts.
  Vec2 point() const;

  /// The one with these corners, in order.
  void takeAway(const std::array<Vec2, 4>& corners);

 private:
  using Part = std::vector<Vec2>;

  void keep(Part part);

  std::vector<Part> parts_;
  double thin_, area_ = 0;
};

/// Whether parallelograms, each of the translations that let two edges meet, cover a square of translations to within
/// the resolution: for where many pairs of edges make few lines, as outlines with repeated parts do. One query each; it
/// is given up where they cover too little for that.
enum class Cover { Whole, Most, Little };
Cover coverSquare(const Vec2& center, double half, double resolution, TranslationSpace& space, TranslationProbe& probe);

}  // namespace tricover::detail
