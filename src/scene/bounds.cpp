// SPDX-License-Identifier: BSD-3-Clause
#include "scene/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hierarchy/hierarchy.h"
#include "numbers/rounding.h"

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a world coordinate of the bounds is off by, beside 2^-20 of a box's extents: R c + t with the centre c of a box
/// in the polygon's frame. In units of U, with rows of R of length 1 but for 1e-6, and the polygon's extent e, which no
/// coordinate is above, nor a quarter of the radius, nor an eighth of the unit, of which a block's scale is at most 2:
///   the block's origin in the frame, product and sum     2 e
///   its way to the world, products and sums              3 e, 1 |t|
///   a box's centre from there, products and a sum        3 * 2 scale, 96 e
///   to there, product and sum                            2 (e + |t|), and 16 e
///   reach and error, sums                                3 reach, 3 (e + |t|)
/// and, twice, 1e-13 (2 e + |t|), as near as which timeOfImpact() may report what doesn't meet.
constexpr double kBoundsError = 0x1p-41;
static_assert(kBoundsError >= (1 + 1e-5) * errorOf(2 + 3 + 96 + 2 + 16 + 3) + 2 * 2e-13);

/// Extents of a float box: its axis is of unit length but for floats' roundings (Box), and they are summed up here.
constexpr double kExtentsGrowth = 1 + 0x1p-20;

/// One coordinate of a posed polygon's boxes: the row (r0, r1) of R, and t.
void enclose(const PolygonData& polygon, double r0, double r1, double t, double reach, double& low, double& high) {
  const Block& block = hierarchyOf(polygon).blocks.front();
  const double unit = polygon.unit, scale = unit * block.scale;
  const double x = polygon.origin.x() + unit * block.origin_x, y = polygon.origin.y() + unit * block.origin_y;
  const double middle = r0 * x + r1 * y + t;
  double least = kInfinity, most = -kInfinity;
  for (int i = 0; i < block.count; ++i) {
    const double ux = block.ux[i], uy = block.uy[i];
    const double at = r0 * block.x[i] + r1 * block.y[i];
    const double half = std::abs(r0 * ux + r1 * uy) * block.along[i] + std::abs(r1 * ux - r0 * uy) * block.across[i];
    least = std::min(least, at - half * kExtentsGrowth);
    most = std::max(most, at + half * kExtentsGrowth);
  }
  const double error = kBoundsError * (polygon.extent + std::abs(t) + reach) + kTiny;
  low = middle + scale * least - (reach + error);
  high = middle + scale * most + (reach + error);
  // What overflows, and where the hierarchy knows nothing. Negated for NaN.
  constexpr double kLargest = std::numeric_limits<double>::max();
  if (!(low >= -kLargest && high <= kLargest) || !polygon.fitsUnit()) {
    low = -kInfinity;
    high = kInfinity;
  }
}

}  // namespace

Bounds boundsOf(const PolygonData& polygon, const Pose& pose, double reach) {
  const auto& m = pose.matrix();
  Bounds bounds;
  enclose(polygon, m(0, 0), m(0, 1), m(0, 2), reach, bounds.min_x, bounds.max_x);
  enclose(polygon, m(1, 0), m(1, 1), m(1, 2), reach, bounds.min_y, bounds.max_y);
  return bounds;
}

}  // namespace tricover::detail
