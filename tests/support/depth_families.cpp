// SPDX-License-Identifier: BSD-3-Clause
#include "depth_families.h"

#include <cmath>
#include <stdexcept>

#include "shapes.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

double little(Random& random) { return random.oneIn(4) ? 0 : std::pow(10, random.real(-13, -0.5)); }

/// Both seen in a frame of some kind, exact or not.
Case framed(Random& random, const Polygon& a, const Polygon& b, const Pose& pose_b) {
  Pose frame = Pose::Identity();
  if (random.coin()) frame = pose(random.real(0, 6.3), random.real(-9, 9), random.real(-9, 9));
  if (random.oneIn(4)) frame = mirrored(frame);
  const Pose there = frame * pose_b;
  return random.coin() ? Case{a, frame, b, there} : Case{b, there, a, frame};
}

/// Into one wall of an L, U or comb or of what is outside of a room, or into both.
Case crateInCorner(Random& random) {
  const Polygon shapes[] = {Polygon(Ring{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}),
                            Polygon(Ring{{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}),
                            Polygon(comb(3, 4, 1, 3)), box(10, 10).complement()};
  const Vec2 corners[] = {{1, 1}, {1, 1}, {1, 0}, {-5, -5}};
  const int kind = random.integer(0, 3);
  const Vec2 at = corners[kind] + Vec2(0.75 - (random.coin() ? little(random) : -random.unit()), 0.5 - little(random));
  return framed(random, shapes[kind], random.coin() ? box(1.5, 1) : Polygon({regular(6, 0.75)}),
                pose(random.oneIn(3) ? random.real(-0.001, 0.001) : 0, at.x(), at.y()));
}

Case dockedExactly(Random& random) {
  const double width = random.coin() ? 0.5 : random.real(0.1, 2), depth = random.coin() ? 0.625 : random.real(0.1, 2);
  const double half = width / 2;
  const Polygon dock(Ring{{0, -half - 1},
                          {depth + 1, -half - 1},
                          {depth + 1, half + 1},
                          {0, half + 1},
                          {0, half},
                          {depth, half},
                          {depth, -half},
                          {0, -half}});
  return framed(random, dock, Polygon({rectangle(0, -half, depth, half)}),
                pose(0, random.coin() ? little(random) : -little(random), random.coin() ? 0 : little(random)));
}

Case thinThroughThick(Random& random) {
  const auto end = [&] { return Vec2(random.real(-2, 2), random.real(-2, 2)); };
  const Polygon thick({random.coin() ? star(random, random.integer(4, 9), 0.5, 1.5) : rectangle(-2, -1, 2, 1)});
  switch (random.integer(0, 3)) {
    case 0:
      return framed(random, thick, point(end()), pose(0, 0, 0));
    case 1:
      return framed(random, thick, Polygon({rectangle(-4, -little(random), 4, 0.001)}), randomPose(random, 1));
    case 2: {
      const Vec2 p = end();
      return framed(random, thick, Polygon({{p, end(), end(), p, end(), p}}), pose(0, 0, 0));
    }
    default:
      return framed(random, thick, segment(end(), end()), pose(0, 0, 0));
  }
}

/// Rings that share edges, slits, spikes, and edges that are all of these in pieces.
Case edgesUsedTwice(Random& random) {
  const auto any = [&] {
    const FillRule fill = random.coin() ? FillRule::EvenOdd : FillRule::NonZero;
    const double x = random.integer(-3, 3) / 4.0, y = random.integer(-3, 3) / 4.0;
    switch (random.integer(0, 3)) {
      case 0:
        return Polygon({rectangle(-1, -1, x, 1), rectangle(x, -1, 1, 1)}, fill);
      case 1:
        return Polygon({{{-1, -1}, {1, -1}, {1, 1}, {x, 1}, {x, 2}, {x, y}, {x, 1}, {-1, 1}}}, fill);
      case 2:
        return Polygon(
            {rectangle(-1, -1, 1, 1), eitherWay(random, rectangle(x, -1, 1, y + 1)), {{-1, 0}, {1, 0}, {x, 1.5}}},
            fill);
      default: {
        Ring ring;
        for (int i = random.integer(5, 8); i > 0; --i) ring.emplace_back(random.integer(-2, 2), random.integer(-2, 2));
        return Polygon({ring}, fill);
      }
    }
  };
  const Polygon a = any(), b = any();
  const double x = random.integer(-9, 9) / 4.0, y = random.integer(-9, 9) / 4.0;
  return framed(random, a, b, random.coin() ? pose(0, x, y) : pose(random.real(0, 6.3), x, y));
}

/// Along an edge of many collinear pieces, all of whose points are as deep but for rounding.
Case flatContacts(Random& random) {
  Ring floor{{-6, -2}, {6, -2}};
  for (int i = random.integer(1, 12), n = i; i >= 0; --i) floor.emplace_back(-6 + 12.0 * i / n, 0);
  const Polygon crate = random.coin() ? box(2, 1) : Polygon(comb(3, 1, 0.25, 0.5));
  const double bottom = crate.bounds().min().y();
  return framed(random, Polygon(floor), crate,
                pose(random.oneIn(3) ? random.real(-1, 1) * 1e-12 : 0, random.real(-6, 4), -bottom - little(random)));
}

Case regularHoles(Random& random) {
  const int n = random.integer(3, 24), m = random.coin() ? n : random.integer(3, 24);
  const Polygon hole({regular(n, 4), regular(n, 3)});
  const double radius = random.coin() ? 3 : random.real(0.5, 5), turn = random.coin() ? 0 : random.real(0, 6.3);
  return framed(random, random.coin() ? hole : Polygon({regular(n, 3)}), Polygon({regular(m, radius)}),
                pose(turn, random.coin() ? 0 : little(random), little(random)));
}

Case besideComplements(Random& random) {
  const Case c = random.coin() ? thinThroughThick(random) : edgesUsedTwice(random);
  const auto outside = [](const Polygon& polygon) {
    try {
      return polygon.complement();
    } catch (const std::invalid_argument&) {
      return box(3, 2).complement();
    }
  };
  if (random.oneIn(3)) return {random.coin() ? c.a : c.b, c.pose_a, box(9, 4).complement(), c.pose_b};
  return random.coin() ? Case{outside(c.a), c.pose_a, c.b, c.pose_b} : Case{c.a, c.pose_a, outside(c.b), c.pose_b};
}

template <Case (*maker)(Random&)>
Case seeded(std::uint64_t seed) {
  Random random(seed);
  return maker(random);
}

}  // namespace

std::vector<Family> depthFamilies() {
  return {{"crate_in_corner", seeded<crateInCorner>},       {"docked_exactly", seeded<dockedExactly>},
          {"thin_through_thick", seeded<thinThroughThick>}, {"edges_used_twice", seeded<edgesUsedTwice>},
          {"flat_contacts", seeded<flatContacts>},          {"regular_holes", seeded<regularHoles>},
          {"beside_complements", seeded<besideComplements>}};
}

}  // namespace tricover::support
