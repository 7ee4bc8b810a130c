// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/collide.h"

#include <fcl/broadphase/default_broadphase_callbacks.h>

#include "queries/queries.h"
#include "shape/errors.h"
#include "shape/is_polygon.h"

// In float_collide.cpp.
extern template std::size_t fcl::collide(const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                                         const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                                         const fcl::CollisionRequest<float>&, fcl::CollisionResult<float>&);

namespace tricover_fcl {

namespace {

/// Checks the options before anything else: shapes far apart never reach the core's checks, and it sees margins added.
void check(const tricover::CollideOptions& options) {
  tricover::detail::requireFiniteMargin(options.margin, "margin");
  tricover::detail::requireFiniteNotNegative(options.tolerance, "tolerance");
  tricover::detail::requireTouching(options.touching);
}

}  // namespace

template <typename S>
std::size_t collide(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                    const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2,
                    const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  if (isPolygon(*o1) || isPolygon(*o2)) return collideGeometries(*o1, tf1, *o2, tf2, request, result);
  return fcl::collide(o1, tf1, o2, tf2, request, result);
}

template <typename S>
std::size_t collide(const fcl::CollisionObject<S>* o1, const fcl::CollisionObject<S>* o2,
                    const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  return tricover_fcl::collide(o1->collisionGeometry().get(), o1->getTransform(), o2->collisionGeometry().get(),
                               o2->getTransform(), request, result);
}

template <typename S>
std::size_t collide(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                    const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2,
                    const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                    fcl::CollisionResult<S>& result) {
  if (!isPolygon(*o1) && !isPolygon(*o2))
    refuseQuestion("options", "they are for pairs with a PolygonShape", "ask fcl::collide");
  check(options);
  return collideGeometries(*o1, tf1, *o2, tf2, request, result, &options);
}

template <typename S>
std::size_t collide(const fcl::CollisionObject<S>* o1, const fcl::CollisionObject<S>* o2,
                    const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                    fcl::CollisionResult<S>& result) {
  return tricover_fcl::collide(o1->collisionGeometry().get(), o1->getTransform(), o2->collisionGeometry().get(),
                               o2->getTransform(), request, options, result);
}

template <typename S>
bool defaultCollisionFunction(fcl::CollisionObject<S>* o1, fcl::CollisionObject<S>* o2, void* data) {
  auto& collision = *static_cast<fcl::DefaultCollisionData<S>*>(data);
  if (collision.done) return true;
  const std::size_t contacts = tricover_fcl::collide(o1, o2, collision.request, collision.result);
  collision.done = !collision.request.enable_cost && contacts > 0 && contacts >= collision.request.num_max_contacts;
  return collision.done;
}

#define TRICOVER_INSTANTIATE(S)                                                                  \
  template std::size_t collide(const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&,      \
                               const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&,      \
                               const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&);       \
  template std::size_t collide(const fcl::CollisionObject<S>*, const fcl::CollisionObject<S>*,   \
                               const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&);       \
  template std::size_t collide(const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&,      \
                               const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&,      \
                               const fcl::CollisionRequest<S>&, const tricover::CollideOptions&, \
                               fcl::CollisionResult<S>&);                                        \
  template std::size_t collide(const fcl::CollisionObject<S>*, const fcl::CollisionObject<S>*,   \
                               const fcl::CollisionRequest<S>&, const tricover::CollideOptions&, \
                               fcl::CollisionResult<S>&);                                        \
  template bool defaultCollisionFunction(fcl::CollisionObject<S>*, fcl::CollisionObject<S>*, void*);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
