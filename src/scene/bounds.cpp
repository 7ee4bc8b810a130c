// SPDX-License-Identifier: BSD-3-Clause
#include "scene/bounds.h"

#include <cmath>
#include <limits>

#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "numbers/rounding.h"

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a world coordinate of the bounds is off by, beside 2^-20 of a box's extents: R c + t with the centre c of a box
/// in the polygon's frame. In units of U, with rows of R of length 1 but for kUnitRows, and the polygon's extent e,
/// which no coordinate is above, nor a quarter of the radius, nor an eighth of the unit, of which a block's scale is at
/// most 2:
///   the block's origin in the frame, product and sum     2 e
///   the origin in the world, products and sums           3 e, 1 |t|
///   a box's centre from there, products and a sum        3 * 2 scale, 96 e
///   to there, product and sum                            2 (e + |t|), and 16 e
///   reach and error, sums                                3 reach, 3 (e + |t|)
/// (a vertex that is mapped by itself takes fewer steps)
/// and, twice, 1e-13 (2 e + |t|), as near as which timeOfImpact() may report what doesn't meet.
constexpr double kBoundsError = 0x1p-41;
static_assert(kBoundsError >= kUnitRows * errorOf(2 + 3 + 96 + 2 + 16 + 3) + 2 * 2e-13);

/// Vertices are mapped one by one up to this number. The boxes of a larger polygon's hierarchy, which are wider, bound
/// it from there on.
constexpr std::size_t kFewVertices = 400;

/// Extents of a float box: its axis is of unit length but for floats' roundings (Box), and they are summed up here.
constexpr double kExtentsGrowth = 1 + 0x1p-20;

Double2 growth(const PolygonData& polygon, Double2 t, double reach) {
  reach += errorOfLargest(polygon);
  return kBoundsError * (polygon.extent + absolute(t) + reach) + (kTiny + reach);
}

/// A box, grown; without ends where that overflows.
Bounds grownBox(Double2 low, Double2 high, Double2 grow) {
  constexpr double kMost = std::numeric_limits<double>::max();
  low = low - grow, high = high + grow;
  const Bits2 finite = (absolute(low) <= kMost) & (absolute(high) <= kMost);
  const Double2 endless = Double2{} + kInfinity;
  return Bounds::between(finite ? low : -endless, finite ? high : endless);
}

/// Around the vertices at these positions. R p is never inf - inf: R's rows are of length 1.
Bounds boundsOfVertices(const PolygonData& polygon, std::size_t begin, std::size_t end, const Pose& pose,
                        double reach) {
  const double* m = pose.data();  // columns of three
  const Double2 r0 = load2(m), r1 = load2(m + 3), t = load2(m + 6);
  Double2 low = Double2{} + kInfinity, high = -low;
  for (std::size_t i = begin; i < end; ++i) {
    const Double2 p = r0 * polygon.path[i].x() + r1 * polygon.path[i].y();
    low = smaller(low, p), high = larger(high, p);
  }
  return grownBox(t + low, t + high, growth(polygon, t, reach));
}

}  // namespace

Bounds boundsOfEdge(const PolygonData& polygon, EdgePosition edge, const Pose& pose, double reach) {
  return boundsOfVertices(polygon, edge, edge + 2, pose, reach);
}

Bounds boundsOf(const PolygonData& polygon, const Pose& pose, double reach) {
  if (polygon.fill.is_complement) return {-kInfinity, -kInfinity, kInfinity, kInfinity};
  // The last one is the first again.
  if (polygon.path.size() <= kFewVertices) return boundsOfVertices(polygon, 0, polygon.path.size() - 1, pose, reach);
  const double* m = pose.data();  // columns of three
  const Double2 r0 = load2(m), r1 = load2(m + 3), t = load2(m + 6);
  Double2 least = kInfinity - Double2{}, most = -least;
  const Block& block = hierarchyOf(polygon).blocks.front();
  const double unit = polygon.unit, scale = unit * block.scale;
  const double x = polygon.origin.x() + unit * block.origin_x, y = polygon.origin.y() + unit * block.origin_y;
  for (int i = 0; i < block.count; ++i) {
    const double ux = block.ux[i], uy = block.uy[i];
    const Double2 at = r0 * double{block.x[i]} + r1 * double{block.y[i]};
    const Double2 half =
        (absolute(r0 * ux + r1 * uy) * double{block.along[i]} + absolute(r1 * ux - r0 * uy) * double{block.across[i]}) *
        kExtentsGrowth;
    least = smaller(least, at - half), most = larger(most, at + half);
  }
  const Double2 middle = r0 * x + r1 * y + t;
  return grownBox(middle + scale * least, middle + scale * most, growth(polygon, t, reach));
}

}  // namespace tricover::detail
