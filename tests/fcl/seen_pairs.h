// SPDX-License-Identifier: BSD-3-Clause
// What a broadphase manager shows its callback, and what it should.
#pragma once

#include <fcl/narrowphase/collision_object.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "tricover_fcl/tricover_fcl.h"

namespace tricover_fcl::test {

template <typename S>
using Object = fcl::CollisionObject<S>;
template <typename S>
using Objects = std::vector<std::unique_ptr<Object<S>>>;
using Pairs = std::set<std::pair<const void*, const void*>>;

template <typename S>
std::vector<Object<S>*> pointers(const Objects<S>& objects) {
  std::vector<Object<S>*> all;
  for (const auto& object : objects) all.push_back(object.get());
  return all;
}

inline std::pair<const void*, const void*> pairOf(const void* p, const void* q) {
  return {std::min(p, q), std::max(p, q)};
}

template <typename S>
bool isPolygon(const Object<S>& object) {
  return object.getNodeType() == fcl::GEOM_TRIANGLE;
}

template <typename S>
bool hit(const Object<S>& p, const Object<S>& q) {
  fcl::CollisionResult<S> result;
  return tricover_fcl::collide(&p, &q, fcl::CollisionRequest<S>(), result) > 0;
}

/// What a callback sees.
template <typename S>
struct Seen {
  Pairs shown, hits;
  std::size_t calls = 0, in_vain = 0;  ///< pairs of two polygons that don't collide
};

template <typename S>
bool see(Object<S>* o1, Object<S>* o2, void* data) {
  auto& seen = *static_cast<Seen<S>*>(data);
  const auto pair = pairOf(o1, o2);
  ++seen.calls;
  seen.shown.insert(pair);
  if (hit(*o1, *o2))
    seen.hits.insert(pair);
  else
    seen.in_vain += isPolygon(*o1) && isPolygon(*o2);
  return false;
}

template <typename S>
void expectSeen(const Seen<S>& seen, const Pairs& expected) {
  EXPECT_EQ(seen.hits, expected);
  EXPECT_EQ(seen.calls, seen.shown.size());  // none twice
  EXPECT_EQ(seen.in_vain, 0u);
}

/// All that collide, one of `ps` and one of `qs`.
template <typename S>
Pairs hitsOf(const std::vector<Object<S>*>& ps, const std::vector<Object<S>*>& qs) {
  Pairs hits;
  for (const Object<S>* p : ps) {
    for (const Object<S>* q : qs) {
      const auto pair = pairOf(p, q);
      if (p != q && hits.count(pair) == 0 && hit(*p, *q)) hits.insert(pair);
    }
  }
  return hits;
}

}  // namespace tricover_fcl::test
