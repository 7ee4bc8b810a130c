// SPDX-License-Identifier: BSD-3-Clause
#include "families.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "family_makers.h"
#include "shapes.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

template <Case (*maker)(Random&)>
Case seeded(std::uint64_t seed) {
  Random random(seed);
  return maker(random);
}

/// Contacts and regions at another size. A power of two keeps the truth; any other factor rounds every coordinate anew.
Case scaledCase(Random& random, double factor) {
  Case c = [&] {
    switch (random.integer(0, 5)) {
      case 0:
        return vertexOnEdge(random);
      case 1:
        return vertexOnVertex(random);
      case 2:
        return collinearOverlap(random);
      case 3:
        return gapOfUlps(random);
      case 4:
        return pinched(random);
      default:
        return smallGrid(random);
    }
  }();
  c.a = c.a.scaled(factor);
  c.b = c.b.scaled(factor);
  c.pose_a.translation() *= factor;
  c.pose_b.translation() *= factor;
  return c;
}

double near(Random& random, double power_of_two) {
  return random.coin() ? power_of_two : power_of_two * random.real(0.5, 2);
}

Case size1e_300(Random& random) { return scaledCase(random, near(random, 0x1p-997)); }
Case size1e_150(Random& random) { return scaledCase(random, near(random, 0x1p-498)); }
Case size1e150(Random& random) { return scaledCase(random, near(random, 0x1p498)); }
Case size1e300(Random& random) { return scaledCase(random, near(random, 0x1p993)); }

/// Coordinates up to the largest double: sums of them overflow.
Case nearOverflow(Random& random) { return scaledCase(random, near(random, 0x1p1015)); }

/// Coordinates of a few to some millions of the smallest double.
Case denormals(Random& random) {
  return scaledCase(random, random.real(1, 2) * static_cast<double>(1 << random.integer(2, 20)) * 0x1p-1074);
}

/// Of one or more rings, beside, in and around each other, of like sizes or as different as a map's and a robot's.
Case largeOutlines(Random& random) {
  const double size = std::pow(10, random.oneIn(4) ? random.real(-5, -1.5) : random.real(-1.5, 0.3));
  std::vector<Ring> of_a = {star(random, random.integer(3, 300), 6, 10)},
                    of_b = {star(random, random.integer(3, 300), 3 * size, 5 * size)};
  if (random.coin()) of_a.push_back(star(random, random.integer(3, 40), 2, 5));
  if (random.coin()) of_b.push_back(star(random, random.integer(3, 40), size, 2 * size));
  if (random.oneIn(3)) of_b.push_back(star(random, 5, size, 2 * size, {random.real(-20, 20), random.real(-20, 20)}));
  const Vec2 away = random.real(0, 20 + 5 * size) * direction(random.real(0, 6.28));
  return {Polygon(of_a), Pose::Identity(), Polygon(of_b), turnedAndMoved(random.real(0, 6.28), away.x(), away.y())};
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"any_pair", seeded<anyPair>},
      {"vertex_on_edge", seeded<vertexOnEdge>},
      {"vertex_on_vertex", seeded<vertexOnVertex>},
      {"collinear_overlap", seeded<collinearOverlap>},
      {"collinear_far_away", seeded<collinearFarAway>},
      {"gap_of_ulps", seeded<gapOfUlps>},
      {"rotated_contact", seeded<rotatedContact>},
      {"mirrored_contact", seeded<mirroredContact>},
      {"float_pose_contact", seeded<floatPoseContact>},
      {"distorted_pose_contact", seeded<distortedPoseContact>},
      {"offset_1e12_1e15", seeded<farFromOrigin>},
      {"size_1e_minus_300", seeded<size1e_300>},
      {"size_1e_minus_150", seeded<size1e_150>},
      {"size_1e150", seeded<size1e150>},
      {"size_1e300", seeded<size1e300>},
      {"near_overflow", seeded<nearOverflow>},
      {"denormals", seeded<denormals>},
      {"1e150_by_1e_minus_150", seeded<hugeBesideTiny>},
      {"1e6_by_1e_minus_6", seeded<largeBesideSmall>},
      {"slivers_1e_minus_12", seeded<slivers>},
      {"facing_walls", seeded<facingWalls>},
      {"inside_hole", seeded<insideHole>},
      {"touching_hole", seeded<touchingHole>},
      {"containment", seeded<containment>},
      {"pinched", seeded<pinched>},
      {"bow_tie", seeded<bowTie>},
      {"repeated_collinear", seeded<repeatedAndCollinear>},
      {"interlocking_combs", seeded<interlockingCombs>},
      {"straight_vertices", seeded<straightVertices>},
      {"ring_directions", seeded<ringDirections>},
      {"overlapping_even_odd", seeded<overlappingRingsEvenOdd>},
      {"overlapping_non_zero", seeded<overlappingRingsNonZero>},
      {"small_grid", seeded<smallGrid>},
      {"flat_rings", seeded<flatRings>},
  };
  return all;
}

std::vector<Family> familiesOfAllSizes() {
  std::vector<Family> all = families();
  all.push_back({"large_outlines", seeded<largeOutlines>});
  return all;
}

double lengthOf(const Polygon& polygon, const Motion& m) {
  const double reach = polygon.radius() + (polygon.coveringOrigin() - m.pivot).stableNorm();
  return m.shift.stableNorm() + m.shift_2.stableNorm() + m.shift_3.stableNorm() + m.pivot.stableNorm() +
         (1 + std::abs(m.angle) + std::abs(m.angle_2) + std::abs(m.angle_3)) * reach;
}

double lengthOf(const MovingCase& c) {
  return std::abs(c.margin) + (c.motion_a.start.translation() - c.motion_b.start.translation()).stableNorm() +
         lengthOf(c.a, c.motion_a) + lengthOf(c.b, c.motion_b);
}

Case tinyInCorner(Random& random) {
  const double size = std::pow(10, random.integer(-11, -3)), far = random.real(1, 60);
  std::vector<Ring> cells;
  for (int k = random.integer(1, 4); k > 0; --k) {
    const Vec2 low(random.integer(-3, 2) * size / 2, random.integer(-3, 2) * size / 2);
    const Vec2 high = low + Vec2(random.integer(1, 2), random.integer(1, 2)) * size / 2;
    cells.push_back(random.coin() ? rectangle(low.x(), low.y(), high.x(), high.y())
                                  : Ring{low, {high.x(), low.y()}, {low.x(), high.y()}});
  }
  const Pose frame = turnedAndMoved(random.coin() ? 1.5707963267948966 : random.real(-3, 3), 0, 0);
  const Pose turn = turnedAndMoved(random.coin() ? random.real(-1, 1) * 1e-4 : random.real(-3, 3), 0, 0);
  return {Polygon({{{0, 0}, {far, 0}, {far, -far}, {-far, -far}, {-far, far}, {0, far}}}), frame,
          Polygon(cells, FillRule::NonZero), frame * distorted(random, turn)};
}

bool isOneTwice(const Case& c) {
  return c.a.rings() == c.b.rings() && c.a.fillRule() == c.b.fillRule() && c.a.isComplement() == c.b.isComplement() &&
         c.pose_a.matrix() == c.pose_b.matrix();
}

Pose elsewhere(Random& random, const Case& c) {
  const double size = std::min(c.a.radius(), c.b.radius()) * (random.coin() ? 1e-3 : random.coin() ? 1e-12 : 1.0);
  Pose result =
      turnedAndMoved(random.real(-1, 1) * (random.coin() ? 1e-3 : 1.0), 0, 0) * c.pose_b;  // as rigid as that is
  const Vec2 moved = c.pose_b.translation() + Vec2(random.real(-size, size), random.real(-size, size));
  if (moved.allFinite()) result.translation() = moved;
  return result;
}

ContactOnWay contactOnWay(Case c, const Vec2& away, double far, int halvings) {
  ContactOnWay way{0, far};
  for (; halvings > 0; --halvings) {
    const double middle = 0.5 * (way.near + way.far);
    c.pose_b.translation() = c.pose_a.translation() + middle * away;
    (collide(c.a, c.pose_a, c.b, c.pose_b) ? way.near : way.far) = middle;
  }
  return way;
}

}  // namespace tricover::support
