// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/broadphase/broadphase_collision_manager.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "tricover/export.h"

namespace tricover_fcl {

/// A broadphase manager over a tricover::Scene, to be used as any of FCL's.
///
/// Its callbacks see the pairs that may collide: of two polygons those that do collide in the plane and whose heights
/// meet (by boxes, rounded outwards), so that hardly any question is in vain; of a polygon and another geometry those
/// in which the polygon meets the other's box; of two others those whose boxes meet. From call to call the scene's
/// certificates answer: a frame costs what moved and what may have changed. For distances the callback sees the pairs
/// that may be nearer than what it has reported so far, the nearest first.
///
/// - Polygons are taken where they are when they are registered and at each update(), whatever their boxes; of other
///   geometries, and of polygons whose poses leave the plane, the box is taken: call computeAABB() first, as for FCL's
///   managers. A geometry without a finite box takes part in all pairs, as does a polygon whose pose isn't rigid or
///   finite, so that the callback's query refuses it.
/// - Heights don't part the plane: many prisms one above the other are pairs that are looked at, if not shown.
/// - Margins are those of the shapes. A callback that asks with a larger one (CollideOptions) needs another manager or
///   larger shapes.
/// - An object is registered once; again, it is ignored, like one to update or unregister that isn't registered. An
///   object never meets itself. Unregister objects before they are destroyed (unregisterObject() and clear() don't
///   look into them).
/// - Pairs come in an order that depends on nothing but the calls so far; a callback's arguments are one object of this
///   manager and the given object or one of the other manager. That one may be any of FCL's; never hand this to a
///   manager of FCL's own, which takes it for one of its kind.
/// - Const functions may be called by any number of threads at once while no other function runs. A callback changes no
///   manager.
///
/// \throws std::invalid_argument in registerObject(), collide() and distance(), for no object, no geometry or no
/// manager, and in setIgnored() for objects that aren't registered or the same \throws std::length_error in
/// registerObject() and update(), as tricover::Scene::add() does
///
/// \snippet fcl.cpp scene manager
template <typename S>
class TRICOVER_EXPORT SceneManager final : public fcl::BroadPhaseCollisionManager<S> {
 public:
  using Manager = fcl::BroadPhaseCollisionManager<S>;  ///< One of any kind.
  using Object = fcl::CollisionObject<S>;              ///< A PolygonObject, or any other.
  using Collision = fcl::CollisionCallBack<S>;         ///< Returns true to end the query.
  using Distance = fcl::DistanceCallBack<S>;           ///< The same; also reports the least distance so far.

  SceneManager();
  ~SceneManager() override;

  void registerObject(Object* object) override;               ///< It takes part from now on.
  void unregisterObject(Object* object) override;             ///< It doesn't any more.
  void setup() override;                                      ///< Does nothing: all is ready.
  void update() override;                                     ///< Looks where all objects are.
  void update(Object* object) override;                       ///< Looks where one is.
  void update(const std::vector<Object*>& objects) override;  ///< Looks where these are.
  void clear() override;                                      ///< Unregisters all.

  /// Lets two objects touch and overlap, as a gripper and its part, or no longer: while the pair is ignored, no
  /// callback sees it. That ends when one of them is unregistered. \snippet fcl.cpp scene manager
  void setIgnored(const Object* a, const Object* b, bool ignored = true);

  void getObjects(std::vector<Object*>& objects) const override;  ///< All that are registered, and nothing else.
  bool empty() const override;                                    ///< Whether none is registered.
  std::size_t size() const override;                              ///< How many are.

  /// Shows the pairs of its objects that may collide, until the callback returns true.
  void collide(void* data, Collision callback) const override;
  /// Shows its objects that may collide with the given one.
  void collide(Object* object, void* data, Collision callback) const override;
  /// Shows the pairs of one of its objects and one of the other manager's that may collide.
  void collide(Manager* other, void* data, Collision callback) const override;
  /// Shows the pairs of its objects that may be nearer than what the callback has reported, until that returns true.
  void distance(void* data, Distance callback) const override;
  /// Shows its objects that may be nearer to the given one.
  void distance(Object* object, void* data, Distance callback) const override;
  /// Shows the pairs of one of its objects and one of the other manager's that may be nearer.
  void distance(Manager* other, void* data, Distance callback) const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

using SceneManagerf = SceneManager<float>;   ///< For FCL's float types.
using SceneManagerd = SceneManager<double>;  ///< For FCL's double types.

extern template class SceneManager<float>;
extern template class SceneManager<double>;

}  // namespace tricover_fcl
