// SPDX-License-Identifier: BSD-3-Clause
// A polygon's path: how it is made of rings, and how its edges are numbered.
#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "numbers/double2.h"
#include "numbers/errors.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {
namespace {

/// In the path. Throws for rings that are no polygon's.
std::size_t positionsOf(const RingsView& rings) {
  if (rings.size() == 0) refuse("rings", "a polygon needs at least one ring");
  std::size_t positions = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const auto [vertices, size] = rings[r];
    const auto name = [&] { return "rings: ring " + std::to_string(r); };
    if (size < 3)
      refuse(name(), "it has " + std::to_string(size) + " vertices", "it needs at least 3, which may be equal ones");
    if (vertices == nullptr) refuse(name(), "its vertices are at no address");
    positions += std::min(size, kMostPositions) + 1;
  }
  requireCapacity(positions);
  return positions;
}

/// Out of line, which keeps the check of an edge's number short.
[[noreturn, gnu::cold]] void refuseEdge(EdgeIndex number, std::size_t count) {
  throw std::out_of_range(refusal(
      "edge",
      std::to_string(number) + (number < 0 ? " is no edge" : " is beyond the last one, " + std::to_string(count - 1))));
}

/// Whether the next vertex of a ring is another one.
bool differsFromNext(const RingView& ring, std::size_t i) {
  const Vec2* const next = ring.vertices + (i + 1 < ring.size ? i + 1 : 0);
  return bitsOf(load2(ring.vertices[i].data()) == load2(next->data())) != 3;
}

/// How many vertices the path takes of a ring: all of three.
std::size_t sizeInPath(const RingView& ring) {
  if (ring.size <= 3) return ring.size;
  std::size_t different = 0;
  for (std::size_t i = 0; i < ring.size; ++i) different += differsFromNext(ring, i) ? 1 : 0;
  return std::max(different, std::size_t{3});
}

/// Writes a ring of so many vertices to the path, closed, and their numbers from `first` on unless that is null.
Vec2* addRing(const RingView& ring, std::size_t size, Vec2* end, std::uint32_t first, std::uint32_t* numbers) {
  Vec2* const begin = end;
  const auto add = [&](std::size_t i) {
    if (numbers != nullptr) *numbers++ = first + static_cast<std::uint32_t>(i);
    new (end++) Vec2(ring.vertices[i]);
  };
  if (size == ring.size && numbers == nullptr) {
    std::memcpy(static_cast<void*>(end), ring.vertices, size * sizeof(Vec2));
    end += size;
  } else {
    std::size_t last = 0;
    for (std::size_t i = 0; i < ring.size; ++i)
      if (size == ring.size || differsFromNext(ring, i)) add(last = i);
    while (end < begin + size) add(last);
  }
  if (numbers != nullptr) *numbers = first + static_cast<std::uint32_t>(ring.size) - 1;
  new (end) Vec2(*begin);
  return end + 1;
}

}  // namespace

void requireCapacity(std::size_t positions) {
  if (positions > kMostPositions)
    throw std::length_error(
        refusal("rings", "more than 2^29 vertices, one more counted for each ring", "divide the polygon"));
}

PolygonData* PolygonData::make(const RingsView& rings, const Fill& fill) {
  if (fill.rule != FillRule::EvenOdd && fill.rule != FillRule::NonZero) refuse("fill", "not a FillRule");
  const std::size_t given = positionsOf(rings);
  std::size_t total = rings.size();
  for (std::size_t r = 0; r < rings.size(); ++r) total += sizeInPath(rings[r]);
  const bool has_repeats = total < given;
  static_assert(sizeof(PolygonData) % alignof(Vec2) == 0 && alignof(PolygonData) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
  const std::size_t of_numbers = rings.size() + 1 + (has_repeats ? total : 0);
  const std::size_t of_path = total * sizeof(Vec2) + of_numbers * sizeof(std::uint32_t);
  auto* const memory = static_cast<std::byte*>(::operator new(sizeof(PolygonData) + of_path));
  auto* const vertices = reinterpret_cast<Vec2*>(memory + sizeof(PolygonData));
  auto* const ring_begin = reinterpret_cast<std::uint32_t*>(vertices + total);
  std::uint32_t* const numbers = has_repeats ? ring_begin + rings.size() + 1 : nullptr;
  Vec2* end = vertices;
  std::uint32_t first = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::ptrdiff_t begin = end - vertices;
    ring_begin[r] = static_cast<std::uint32_t>(begin);
    end = addRing(rings[r], sizeInPath(rings[r]), end, first, numbers == nullptr ? nullptr : numbers + begin);
    first += static_cast<std::uint32_t>(rings[r].size);
  }
  ring_begin[rings.size()] = static_cast<std::uint32_t>(total);
  try {
    return new (memory) PolygonData(rings, total, fill, has_repeats);
  } catch (...) {
    ::operator delete(memory);
    throw;
  }
}

const PolygonData* PolygonData::reducedTo(const std::vector<EdgePosition>& positions) const {
  Ring ring;
  ring.reserve(positions.size());
  for (const EdgePosition position : positions) ring.push_back(path[position]);
  PolygonData* reduced = make(RingsView({ring.data(), ring.size()}), fill);
  reduced->origin = origin;
  reduced->radius = radius;
  reduced->reach = reach;
  reduced->extent = extent;
  reduced->unit = unit;
  reduced->inverse_unit = inverse_unit;
  return reduced;
}

void PolygonData::release() const {
  if (users.fetch_sub(1, std::memory_order_acq_rel) > 1) return;
  auto* const memory = const_cast<PolygonData*>(this);
  memory->~PolygonData();
  ::operator delete(memory);
}

std::size_t PolygonData::ringOf(EdgePosition position) const {
  // Halves, without branches: which one it is can't be predicted.
  const std::uint32_t* begin = path.ringBegin();
  for (std::size_t count = ringCount(); count > 1;) {
    const std::size_t half = count / 2;
    begin += begin[half] <= position ? half : 0;
    count -= half;
  }
  return static_cast<std::size_t>(begin - path.ringBegin());
}

EdgePosition PolygonData::edgePosition(EdgeIndex index) const {
  const auto number = static_cast<std::size_t>(index);
  if (has_repeats) {
    const std::uint32_t* const all = path.numbers();
    auto at = static_cast<EdgePosition>(std::lower_bound(all, all + path.size(), number) - all);
    const std::size_t ring = ringOf(at);
    const EdgePosition end = edgeEnd(ring);
    while (at + 1 < end && all[at + 1] == number) ++at;
    return at == end ? edgeBegin(ring) : at;
  }
  std::size_t low = 0, high = ringCount();
  while (high - low > 1) {
    const std::size_t mid = (low + high) / 2;
    (edgeBegin(mid) - mid <= number ? low : high) = mid;
  }
  return static_cast<EdgePosition>(number + low);
}

EdgePosition PolygonData::nextWithLength(EdgePosition position) const {
  const std::size_t ring = ringOf(position);
  const EdgePosition begin = edgeBegin(ring), end = edgeEnd(ring);
  for (EdgePosition e = position + 1 < end ? position + 1 : begin; e != position; e = e + 1 < end ? e + 1 : begin)
    if (path[e] != path[e + 1]) return e;
  return position;
}

EdgePosition PolygonData::checkedEdgePosition(EdgeIndex number) const {
  const std::size_t count = edgeCount();
  if (static_cast<std::size_t>(number) >= count) refuseEdge(number, count);
  return edgePosition(number);
}

}  // namespace tricover::detail
