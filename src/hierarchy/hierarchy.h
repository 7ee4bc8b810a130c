// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include "hierarchy/simd_function.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// An oriented box: its centre, the unit axis it is `along`, and half its extents along and across that.
struct Box {
  float x, y, ux, uy, along, across;
};

/// Eight boxes side by side.
struct BoxLanes {
  float x[kLanes], y[kLanes], ux[kLanes], uy[kLanes], along[kLanes], across[kLanes];
};

/// Up to eight boxes, each around a chain of consecutive edges or around several rings, rounded outwards.
/// They are floats relative to the block's own origin and scale, so that they are as precise as the block is small.
struct alignas(64) Block : BoxLanes {
  std::uint32_t child[kLanes];  ///< the block that the box is divided into; in a leaf the edge's position in the path
  double origin_x, origin_y;    ///< in units of the hierarchy
  float scale, inverse;         ///< powers of two: a length of 1 in this block is `scale` units
  std::uint8_t count;           ///< of boxes; lanes beyond are infinitely far from everything
  /// Bit per lane: the chain is connected and reaches from end to end of the box, so that no point of the box is
  /// farther than 2 * across from the chain.
  std::uint8_t spanned;
  bool leaf;
};
static_assert(sizeof(Block) == 256, "four cache lines");

/// Discs that are proven to lie in the region, in units, as large as a short search finds, spread over the region, the
/// largest first; lanes beyond the count are no discs.
struct InnerDiscs : Derived::Thing {
  InnerDiscs() = default;  ///< none
  /// Found by the hierarchy, which is built for it.
  explicit InnerDiscs(const PolygonData& polygon);

  float x[kLanes] = {}, y[kLanes] = {};
  float radius[kLanes] = {-1e15f, -1e15f, -1e15f, -1e15f, -1e15f, -1e15f, -1e15f, -1e15f};
  float reach = 0;  ///< no point of a disc is farther from S
  int count = 0;
  Vec2 center = Vec2::Zero();  ///< the first of them once more, in the polygon's frame
  double largest = 0;          ///< its radius; 0 if there is none
};

/// Vertices and edges' lines side by side. Edge i begins at vertex i. A point p is beyond its line by nx p.x + ny p.y -
/// d: of a convex polygon outside, of another one to its right.
struct LineLanes {
  float *x, *y, *nx, *ny, *d;
};

/// The few edges of a polygon, of any number of rings, in units from S; lanes beyond repeat the last vertex and the
/// last edge. A point p is |nx p.y - ny p.x - middle| away from an edge's middle, along the edge, which is `half` from
/// its ends.
struct SmallPolygon : LineLanes {
  static constexpr int kMost = 2 * kLanes;
  float *middle, *half;                ///< for each lane
  float low_x, low_y, high_x, high_y;  ///< of the vertices
  int lanes;                           ///< kLanes or kMost
  int count;                           ///< of edges
  unsigned edges;                      ///< a bit for each
  unsigned firsts, lasts;        ///< the first and the last edge of each ring; lanes beyond the count are one more
  std::uint8_t next[kMost];      ///< the vertex at which an edge ends
  std::uint8_t position[kMost];  ///< an edge's, in the path
  FillRule fill;

  SmallPolygon() = default;
  SmallPolygon(const SmallPolygon&) = delete;
  SmallPolygon& operator=(const SmallPolygon&) = delete;
  /// With its lanes behind it, in one allocation: polygons of few vertices are many.
  static void* operator new(std::size_t size, int lanes) {
    return ::operator new(size + kArrays * static_cast<std::size_t>(lanes) * sizeof(float));
  }
  static void operator delete(void* place) { ::operator delete(place); }
  static void operator delete(void* place, int) { ::operator delete(place); }
  static constexpr std::size_t kArrays = 7;

  /// Of bits of vertices, those of the vertices at which edges end: each bit moves to the edge before it in its ring,
  /// that of a ring's first vertex to the last edge: where it is set, the difference clears the last edge's bit, and no
  /// other. In both halves of the bits.
  [[gnu::always_inline]] unsigned ends(unsigned bits) const {
    const unsigned first = bits & firsts;
    return (bits ^ first) >> 1 | (lasts & ~(lasts - first));
  }
};
static_assert(SmallPolygon::kMost == 16, "half of the bits");

/// Makes one without edges, its lanes all 0.
std::unique_ptr<SmallPolygon> emptySmallPolygon(int lanes);
/// Null where the polygon has more edges, or one without a direction; `local` is its path in units, from S.
std::unique_ptr<const SmallPolygon> makeSmallPolygon(const PolygonData& polygon, const Vec2* local);

/// The influence hierarchy of a polygon: a tree of boxes over edges; a box grown by n is its edges' influence area of
/// length n. Its unit is PolygonData::unit and its origin S. Blocks stand in preorder; the root is the first. Few edges
/// are mostly asked at once: their blocks are built for who descends, at the first call of hierarchyOf().
struct Hierarchy : Derived::Thing {
  explicit Hierarchy(const PolygonData& polygon);
  bool hasBlocks() const { return small == nullptr || few_blocks.ifBuilt() != nullptr; }

  mutable std::vector<Block> blocks;  ///< written before few_blocks says so
  Derived few_blocks;                 ///< whether they are there, of few edges
  Box root;                           ///< around all edges, in units
  Box region;                         ///< around all of the region: that one, or without end around a complement
  bool root_spanned;

  std::unique_ptr<const SmallPolygon> small;   ///< null unless the polygon has few edges
  const SmallPolygon* small_convex = nullptr;  ///< null unless it is convex and has few corners, which these are

  Derived tangles;  ///< whether its edges meet each other, see meetsItself()
  Derived sides;    ///< of its rings on which the region is, see regionSidesOf()
  Derived borders;  ///< see withBordersOnly()
  Derived field;    ///< of influence lengths
  SkiRental<Stages::All> field_rental;
};

static_assert(std::uint64_t{kMostPositions} * kLanes <= std::uint64_t{1} << 32, "a block and a lane are one number");

/// The hierarchy, perhaps without blocks, if it has been built, otherwise null: for who asks the root and few edges.
inline const Hierarchy* topIfBuilt(const PolygonData& polygon) {
  return static_cast<const Hierarchy*>(polygon.hierarchy.ifBuilt());
}
/// With its blocks.
inline const Hierarchy* hierarchyIfBuilt(const PolygonData& polygon) {
  const Hierarchy* ready = topIfBuilt(polygon);
  return ready != nullptr && ready->hasBlocks() ? ready : nullptr;
}

[[gnu::cold]] const Hierarchy& buildTop(const PolygonData& polygon);
[[gnu::cold]] const Hierarchy& buildHierarchy(const PolygonData& polygon);

/// Built at the first call, once for all copies and threads.
inline const Hierarchy& topOf(const PolygonData& polygon) {
  const Hierarchy* ready = topIfBuilt(polygon);
  return ready != nullptr ? *ready : buildTop(polygon);
}
inline const Hierarchy& hierarchyOf(const PolygonData& polygon) {
  const Hierarchy* ready = hierarchyIfBuilt(polygon);
  return ready != nullptr ? *ready : buildHierarchy(polygon);
}

/// What building the hierarchy costs, see SkiRental.
inline std::size_t hierarchyPrice(const PolygonData& polygon) { return 16 * polygon.path.size(); }

/// The discs if they have been built, otherwise null.
inline const InnerDiscs* innerDiscsIfBuilt(const PolygonData& polygon) {
  return static_cast<const InnerDiscs*>(polygon.discs.ifBuilt());
}

/// Built at the first call.
const InnerDiscs& innerDiscsOf(const PolygonData& polygon);

/// For a query that discs may answer: builds them once such queries have paid for them, until then null.
[[gnu::cold]] const InnerDiscs* payForDiscs(const PolygonData& polygon);
inline const InnerDiscs* innerDiscsIfPaid(const PolygonData& polygon) {
  const InnerDiscs* ready = innerDiscsIfBuilt(polygon);
  return ready != nullptr ? ready : payForDiscs(polygon);
}

/// Blocks above each other: one each time that up to 2^27 rings are divided, of which two thirds are left at most, and
/// 8^11 edges.
constexpr int kMaxDepth = 47 + 11 + 1;

}  // namespace tricover::detail
