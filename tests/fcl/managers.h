// SPDX-License-Identifier: BSD-3-Clause
// Every broadphase manager, FCL's and ours; what one shows its callback, and what it should.
#pragma once

#include <fcl/broadphase/broadphase_SSaP.h>
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_bruteforce.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/broadphase/broadphase_interval_tree.h>
#include <fcl/broadphase/broadphase_spatialhash.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "ask.h"
#include "tricover_fcl/scene_manager.h"

namespace tricover_fcl::test {

struct Manager {
  const char* name;
  std::unique_ptr<fcl::BroadPhaseCollisionManagerd> manager;
};

inline std::vector<Manager> managersOfEveryKind() {
  std::vector<Manager> all;
  all.push_back({"DynamicAABBTree", std::make_unique<fcl::DynamicAABBTreeCollisionManagerd>()});
  all.push_back({"DynamicAABBTreeArray", std::make_unique<fcl::DynamicAABBTreeCollisionManager_Array<double>>()});
  all.push_back({"SaP", std::make_unique<fcl::SaPCollisionManagerd>()});
  all.push_back({"SSaP", std::make_unique<fcl::SSaPCollisionManagerd>()});
  all.push_back({"Naive", std::make_unique<fcl::NaiveCollisionManagerd>()});
  all.push_back({"IntervalTree", std::make_unique<fcl::IntervalTreeCollisionManagerd>()});
  // Its cells' bounds lie off the origin: an object that is one point for it, on such a bound, gets no cell.
  all.push_back({"SpatialHashing", std::make_unique<fcl::SpatialHashingCollisionManager<double>>(4, Vec3(-41, -41, -5),
                                                                                                 Vec3(41, 41, 5))});
  all.push_back({"Scene", std::make_unique<SceneManagerd>()});
  return all;
}

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

template <typename S>
double distanceOf(const Object<S>& p, const Object<S>& q, fcl::GJKSolverType solver = fcl::GST_LIBCCD,
                  bool is_signed = false) {
  return static_cast<double>(
      distanceOf<S>(solver, is_signed, p.collisionGeometry(), p.getTransform(), q.collisionGeometry(), q.getTransform())
          .min_distance);
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

/// `query` shows `see` its pairs: those that are expected, none twice, and no others of two polygons.
template <typename S = double, typename Query>
void expectSeen(const Pairs& expected, const Query& query) {
  Seen<S> seen;
  query(&seen);
  EXPECT_EQ(seen.hits, expected);
  EXPECT_EQ(seen.calls, seen.shown.size());
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

template <typename S>
double leastDistance(const std::vector<Object<S>*>& ps, const std::vector<Object<S>*>& qs,
                     fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  double least = static_cast<double>(std::numeric_limits<S>::max());
  for (const Object<S>* p : ps)
    for (const Object<S>* q : qs)
      if (p != q) least = std::min(least, distanceOf(*p, *q, solver));
  return least;
}

}  // namespace tricover_fcl::test
