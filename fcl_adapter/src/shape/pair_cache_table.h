// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "tricover/pair_cache.h"
#include "tricover/polygon.h"

namespace tricover_fcl {

/// The cache that this thread keeps for the pair, in either order: a slot of a table that begins with 64 KB and grows
/// with the number of pairs up to 8192 slots. Hence memory stays bounded while polygons come and go. Pairs that share a
/// slot only lose certificates to each other: a cache that becomes another pair's is emptied, and no answer depends on
/// it. `place_a` and `place_b` tell objects apart that share a polygon (a
/// fleet of one model): the addresses of their poses, which are those of the CollisionObjects' own members. They are
/// compared, never read. Places that are new get the slot of their ids alone, and their own one from the next time on:
/// so a walk along an array of poses is coherent, too. Null for ids that are new, because of a pair that is asked once
/// nothing need be remembered, and once the thread's table is gone: a destructor of a static or thread_local object may
/// still ask. A pair that is asked again and again gets a cache, whichever others take turns with it, unless it shares
/// a slot of the largest table.
tricover::PairCache* pairCache(std::uint64_t id_a, const void* place_a, std::uint64_t id_b, const void* place_b);

/// How much memory this thread's table takes, for tests.
std::size_t pairCacheBytes();

/// Whether a disc beside the polygon is sooner asked for than its cache is found.
inline bool hasFewEdges(const tricover::Polygon& polygon) { return polygon.vertexCount() <= 64; }

}  // namespace tricover_fcl
