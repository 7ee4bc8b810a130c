// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hierarchy/influence_field.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// Between squares of lengths: the products and the sum of one, the product of the other and that of a length with a
/// last rounding by itself. What the sum of radii rounds by isn't counted: kWayError, of which half would do, and
/// kLargestDefect pay for it.
constexpr int kDiscSquares = 2 + 1 + 2;

/// The largest disc known to be inside of a region. A point or segment has one of radius 0 around S, which is on it but
/// for 2U: PosedPair::kWayError is twice what it must be.
struct InnerDisc {
  explicit InnerDisc(const PolygonData& polygon) {
    const InnerDiscs* discs = innerDiscsIfBuilt(polygon);
    if (discs != nullptr && discs->largest > 0) {
      center = discs->center;
      radius = discs->largest;
    } else {
      center = polygon.origin;
      radius = polygon.isDegenerate() ? 0 : -1;
    }
  }

  Vec2 center;
  double radius;  ///< negative if there is none
};

/// The gap between the discs around the regions, a lower bound of the distance, if it is above the margin; otherwise
/// -1.
inline double gapOfDiscs(const PosedPair& pair, double margin) {
  const Double2 way = pair.way();
  const double sum = (pair.a.reach + pair.b.reach) * (1 + kLargestDefect) + pair.error(), reach = sum + margin;
  const double square = dot(way, way);
  if (!(squarable(reach) && square > roundedUp<kDiscSquares>(reach * reach))) return -1;
  // The root of two roundings and its own; the difference, at most what the root is.
  return square < 0x1p1000 ? roundedDown<3>(std::sqrt(square)) - sum : margin;
}

/// How deep discs inside the two regions overlap, 0 if they are within the margin at least; otherwise -1.
inline double depthOfDiscs(const PosedPair& pair, double margin) {
  const InnerDisc disc_a(pair.a), disc_b(pair.b);
  if (!(disc_a.radius >= 0 && disc_b.radius >= 0)) return -1;
  const Double2 way = pair.way(disc_a.center, disc_b.center);
  const double sum = (disc_a.radius + disc_b.radius) * (1 - kLargestDefect) - pair.error(), reach = sum + margin;
  const double square = dot(way, way);
  if (!(squarable(reach) && roundedUp<kDiscSquares>(square) < reach * reach)) return -1;
  return std::max(roundedDown<2>(sum) - roundedUp<2>(std::sqrt(square)), 0.0);
}

/// Whether a field of a may serve: b is that much smaller.
inline bool isSmallBeside(const PolygonData& a, const PolygonData& b) { return 8 * b.unit <= a.unit; }

/// What a's field, if it has been built, knows of the centre of a disc in b, or of b's S, where b is small beside a.
class BodyInField {
 public:
  BodyInField(const PosedPair& pair, double defect)
      : a_(pair.a), b_(pair.b), field_(isSmallBeside(a_, b_) ? fieldIfBuilt(a_) : nullptr) {
    if (field_ == nullptr) return;
    const InnerDisc disc(b_);
    center_ = disc.center, radius_ = disc.radius;
    const Double2 at = pair.inUnitsOfA(pair.way(a_.origin, center_));
    look_ = field_->at(at[0], at[1]);
    error_ = mapError(a_, at, 1.1 * pair.error(), 1.1 * defect);  // as of PosedPair::inUnits()
  }

  /// A lower bound of the distance, if it is above the margin; or how far points may move until the regions don't meet,
  /// with the sign reversed; otherwise 0.
  double gap(double margin) const {
    if (field_ == nullptr) return 0;
    double gap = 0;
    if (look_.inside ? radius_ >= 0 : radius_ > 0) {
      const double within = radius_ * a_.inverse_unit * kShrunk - look_.near;
      gap = std::min(error_ - std::max(look_.inside ? look_.free : 0, within), 0.0);
    }
    if (!(gap < 0)) {
      const double around = (b_.reach + (center_ - b_.origin).norm()) * a_.inverse_unit * kStretched;
      const double free = look_.free - around - error_;
      if (!(free * a_.unit > (look_.inside ? 0 : margin * kStretched))) return 0;
      gap = look_.inside ? -free : free;
    }
    return gap * a_.unit * kShrunk;
  }

  /// An upper bound of the distance between a's outline and b's region; infinite if there is none.
  double farthest() const {
    if (field_ == nullptr) return InfluenceField::kNone;
    return ((look_.near + error_) * a_.unit + (radius_ >= 0 ? 0 : b_.radius)) * kStretched;
  }

 private:
  /// Both poses may stretch and shrink lengths.
  static constexpr double kStretched = (1 + kLargestDefect) * (1 + kLargestDefect) * (1 + 0x1p-40);
  static constexpr double kShrunk = (1 - 0x1p-40) / kStretched;

  const PolygonData &a_, &b_;
  const InfluenceField* field_;
  Vec2 center_;
  InfluenceField::Look look_;
  double radius_, error_;  ///< the disc's, negative if there is none; and how far off its place is, in a's units
};

}  // namespace tricover::detail
