// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/contacts.h"
#include "tricover/covers.h"
#include "tricover/distance.h"
#include "tricover/export.h"
#include "tricover/least_distance.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"
#include "tricover/ray.h"
#include "tricover/time_of_impact.h"
#include "tricover/touching.h"
#include "tricover/trajectory.h"

namespace tricover {

/// Runs tasks on the caller's threads: calls task(i) for every i in [0, count), in any order and on any threads, and
/// returns when all are done. It must rethrow an exception that a task throws. An empty function means sequential.
/// \snippet scene.cpp parallel
using Parallel = std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// A handle of a body in a Scene. It names that body until the body is removed, and never names another body. The low
/// 32 bits are the body's index, Scene::indexOf(); the high bits count the bodies that have had the index before. It
/// depends on nothing but the calls of its scene: another scene may have a body of the same handle.
using BodyHandle = std::uint64_t;

/// All bits of a mask.
constexpr std::uint32_t kEveryCategory = ~std::uint32_t{0};

/// The properties of a body beside its polygon and pose.
struct BodyOptions {
  /// A world length, finite. Every query inflates the body by it. Margins of two bodies, and of a body and a query, add
  /// up (rounded to the nearest double). A negative sum is an overlap that is allowed, as CollideOptions::margin says.
  /// Distances and rays take a negative sum for 0.
  double margin = 0;
  std::uint32_t category = 1;  ///< Bits: the categories of the body.
  /// Bits: the categories that the body meets. Two bodies meet if each has a category of the other's mask.
  std::uint32_t mask = kEveryCategory;
  /// If Allowed, another body or the polygon of a query that only touches this body doesn't collide with it, whatever
  /// the other one's option says; see CollideOptions::touching. An impact is the first touch in any case; see
  /// ImpactOptions::ignore_initial for bodies that touch at the start.
  /// \snippet scene.cpp scene touching
  Touching touching = Touching::Collides;
};

/// A body to add to a scene.
struct BodyPlacement {
  Polygon polygon;      ///< The body's shape.
  Pose pose;            ///< From the polygon's frame to the world.
  BodyOptions options;  ///< The body's other properties.
};

/// A new pose of a body.
struct BodyPose {
  BodyHandle body;  ///< The body that moves.
  Pose pose;        ///< Replaces the body's pose.
};

/// Names no body.
constexpr BodyHandle kNoBody = ~BodyHandle{0};

/// Selects the bodies of a query by category, and may leave one of them out. A mask converts to a filter.
/// \throws std::out_of_range in a query, if `except` is neither kNoBody nor a body of the scene
/// \snippet scene.cpp scene nearest
struct BodyFilter {
  /// Selects the bodies that have one of the categories, except one body.
  BodyFilter(std::uint32_t categories_ = kEveryCategory, BodyHandle except_ = kNoBody)
      : categories(categories_), except(except_) {}
  /// A handle, or another integer of 64 bits, is not a mask. To leave out a body, write BodyFilter::allBut(body).
  template <typename HandleIsNoMask, typename = std::enable_if_t<std::is_integral<HandleIsNoMask>::value &&
                                                                 (sizeof(HandleIsNoMask) > sizeof(std::uint32_t))>>
  BodyFilter(HandleIsNoMask, BodyHandle = kNoBody) = delete;  // To leave out a body, write BodyFilter::allBut(body).
  /// Selects all bodies except one.
  /// \snippet scene.cpp scene nearest
  static BodyFilter allBut(BodyHandle body) { return {kEveryCategory, body}; }

  std::uint32_t categories;  ///< Bits: a body is selected if it has one of these categories.
  BodyHandle except;         ///< This body is not selected.
};

/// A pair of bodies, the lower handle first.
struct BodyPair {
  BodyHandle first;   ///< The lower handle.
  BodyHandle second;  ///< The higher handle.
  /// Compares both handles.
  friend bool operator==(const BodyPair& p, const BodyPair& q) { return p.first == q.first && p.second == q.second; }
  /// Compares both handles.
  friend bool operator!=(const BodyPair& p, const BodyPair& q) { return !(p == q); }
  /// Orders pairs by the first handle, then by the second.
  friend bool operator<(const BodyPair& p, const BodyPair& q) {
    return p.first != q.first ? p.first < q.first : p.second < q.second;
  }
};

/// The distance between a query's polygon and a body.
struct BodyDistance {
  BodyHandle body;        ///< The body.
  DistanceResult result;  ///< a is the query's polygon, b the body.
};

/// The least distance between a query's moving polygon and a body.
struct BodyLeastDistance {
  BodyHandle body;      ///< The body.
  LeastDistance least;  ///< a is the query's polygon, b the body.
};

/// The impact of a query's moving polygon on a body.
struct BodyImpact {
  BodyHandle body;  ///< The body.
  Impact impact;    ///< a is the query's polygon, b the body.
};

/// When bodies stop covering a moving polygon.
struct Exit {
  double time;                ///< They cover the polygon until then.
  Vec2 point;                 ///< Where the polygon leaves them then, in the world.
  bool budget_ended = false;  ///< The search ended early: they may cover the polygon for longer.
};

/// The motion of a body from time 0 to 1.
struct BodyMotion {
  BodyHandle body;  ///< The body that moves.
  Motion motion;    ///< Replaces the body's pose.
};

/// The motion of a body by the caller's clock. Before the trajectory begins and after it ends, the body rests there, or
/// is absent, as the trajectory says, whatever its pose in the scene.
struct BodyTrajectory {
  BodyHandle body;        ///< The body that moves.
  Trajectory trajectory;  ///< Replaces the body's pose.
};

/// A contact of two bodies.
struct PairContact {
  BodyPair pair;    ///< The two bodies.
  Contact contact;  ///< a is pair.first, b is pair.second.
};

/// The impact of two bodies.
struct PairImpact {
  BodyPair pair;  ///< The two bodies.
  Impact impact;  ///< a is pair.first, b is pair.second.
};

/// A time interval in which two bodies meet.
struct PairConflict {
  BodyPair pair;      ///< The two bodies.
  Conflict conflict;  ///< a is pair.first, b is pair.second.
};

/// The point where a ray meets a body.
struct BodyRayHit {
  BodyHandle body;  ///< The body.
  RayHit hit;       ///< The result of castRay() for this body.
};

/// A part of a ray that is in a body.
struct BodyRayInterval {
  BodyHandle body;       ///< The body.
  RayInterval interval;  ///< One of castRayAll() for this body.
};

namespace detail {
struct SceneState;
}

/// Bodies, which are polygons under poses of their own, and queries about all of them.
///
/// Every answer is the exact one of collide(), distance(), timeOfImpact() and castRay() for the bodies concerned. It
/// doesn't depend on earlier queries, on the order in which bodies were added, nor on threads. Any number of threads
/// may call const functions at once while no other function runs.
///
/// A scene extends the paper's coherence to many moving objects. It remembers a lower bound on each near pair's
/// distance and tests the pair again only when the motion of both bodies together has used that bound up. A call of
/// collisions() costs only the bodies that moved and the pairs that are due.
///
/// New bodies enter a tree of boxes at the next query, all together. Memory beside the polygons, which are shared:
/// about 300 bytes a body and 100 a pair of bodies whose surroundings meet, and up to twice that where lists have just
/// grown.
///
/// \snippet scene.cpp scene
class TRICOVER_EXPORT Scene {
 public:
  using Body = BodyHandle;  ///< A handle of a body.

  /// Returns an index for arrays of your own. No two bodies of a scene have the same index at once. Indices are below
  /// the largest number of bodies that there have been at once, plus the number of removed bodies whose pairs
  /// collisions() has not reported as ended yet. \snippet scene.cpp scene handles
  static constexpr std::uint32_t indexOf(Body body) { return static_cast<std::uint32_t>(body); }

  Scene();  ///< Makes a scene without bodies.
  ~Scene();
  /// Makes an independent scene with the same bodies under the same handles, for planners that branch. Polygons are
  /// shared; a copy costs about 300 bytes a body and 100 a pair.
  Scene(const Scene& other);
  Scene& operator=(const Scene& other);  ///< Replaces all bodies by copies of the other scene's.
  Scene(Scene&& other);                  ///< Leaves the other scene without bodies.
  Scene& operator=(Scene&& other);       ///< Leaves the other scene without bodies.

  /// Adds a body. A call that throws changes nothing, here and in all functions below.
  /// \return the body's handle
  /// \throws std::invalid_argument for a pose that checkPose() refuses, for a margin that is not finite, and for a
  /// value that Touching doesn't have
  /// \throws std::length_error for more than 2^28 bodies
  /// \snippet scene.cpp scene bodies
  Body add(const Polygon& polygon, const Pose& pose, const BodyOptions& options = {});
  /// Adds many bodies, or none if it throws.
  /// \return their handles, in the order of `bodies`
  /// \throws std::invalid_argument as for one body
  /// \throws std::length_error as for one body
  /// \snippet scene.cpp scene bodies
  std::vector<Body> add(const std::vector<BodyPlacement>& bodies);
  /// Removes a body.
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene bodies
  void remove(Body body);
  /// Moves a body to another pose.
  /// \throws std::invalid_argument for a pose that checkPose() refuses
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene bodies
  void move(Body body, const Pose& pose);
  /// Changes a body's options. A pair that collides before and after neither ends nor begins for collisions().
  /// \throws std::invalid_argument for a margin that is not finite, and for a value that Touching doesn't have
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene handles
  void setOptions(Body body, const BodyOptions& options);
  /// Lets two bodies touch and overlap, as a gripper and its part, or no longer. While a pair is ignored, it is in no
  /// result of collisions(), contacts(), impacts() and conflicts(). That ends when one of the bodies is removed.
  /// \throws std::invalid_argument for a body and itself
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene ignored
  void setIgnored(Body a, Body b, bool ignored = true);
  /// Returns whether the pair is ignored.
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene ignored
  bool isIgnored(Body a, Body b) const;
  /// Moves many bodies: the result is that of single moves in order, whatever `parallel` is. Moves none if a body or a
  /// pose is refused. If `parallel` itself throws, or memory runs out, some bodies may stay where they were.
  /// \throws std::invalid_argument for a pose that checkPose() refuses
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene frames
  void move(const std::vector<BodyPose>& poses, const Parallel& parallel = {});

  /// Returns the number of bodies.
  /// \snippet scene.cpp scene bodies
  std::size_t size() const;
  /// Returns all handles, sorted.
  /// \snippet scene.cpp scene bodies
  std::vector<Body> bodies() const;
  /// Returns whether the handle names a body.
  /// \snippet scene.cpp scene bodies
  bool contains(Body body) const;
  /// Returns a body's polygon.
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene bodies
  const Polygon& polygon(Body body) const;
  /// Returns a body's pose.
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene bodies
  const Pose& pose(Body body) const;
  /// Returns a body's options as they were given.
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene bodies
  const BodyOptions& options(Body body) const;

  /// Returns the pairs that collide now, sorted. Bodies that only touch collide unless either of them allows it
  /// (BodyOptions::touching). The reference is valid until the next call of a function that isn't const.
  /// \snippet scene.cpp scene frames
  const std::vector<BodyPair>& collisions(const Parallel& parallel = {});
  /// Returns the pairs that the last call of collisions() returned and the call before did not, sorted.
  /// \snippet scene.cpp scene frames
  const std::vector<BodyPair>& began() const;
  /// Returns the pairs that the last call of collisions() did not return and the call before did, sorted. Their bodies
  /// may have been removed.
  /// \snippet scene.cpp scene frames
  const std::vector<BodyPair>& ended() const;

  /// Calls collisions() and returns all contacts of each pair in it, as tricover::contacts() returns them: by pairs,
  /// then the deepest first. A margin of a pair, if it is positive, adds to the depths.
  /// \throws std::invalid_argument as tricover::contacts() does
  /// \snippet scene.cpp scene contacts
  std::vector<PairContact> contacts(ContactDetail detail = ContactDetail::LocalDepth, const Parallel& parallel = {});

  /// Returns whether a polygon at a pose collides with a body that passes the filter.
  /// \throws std::invalid_argument as tricover::collide() does
  /// \snippet scene.cpp scene queries
  bool collides(const Polygon& polygon, const Pose& pose, const CollideOptions& options = {},
                const BodyFilter& filter = {}) const;
  /// Returns the same for many poses, in their order.
  /// \throws std::invalid_argument as tricover::collide() does
  /// \snippet scene.cpp parallel
  std::vector<bool> collides(const Polygon& polygon, const std::vector<Pose>& poses, const CollideOptions& options = {},
                             const BodyFilter& filter = {}, const Parallel& parallel = {}) const;
  /// Returns a body that passes the filter and collides with a polygon, an arbitrary one if there are several.
  /// \throws std::invalid_argument as tricover::collide() does
  /// \snippet scene.cpp scene queries
  std::optional<Body> anyColliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options = {},
                                   const BodyFilter& filter = {}) const;
  /// Returns all bodies that pass the filter and collide with a polygon, sorted.
  /// \throws std::invalid_argument as tricover::collide() does
  /// \snippet scene.cpp scene queries
  std::vector<Body> colliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options = {},
                              const BodyFilter& filter = {}) const;
  /// Calls visit(body) for each of them, in any order, until it returns false. That makes no list in a loop.
  /// \throws std::invalid_argument as tricover::collide() does
  /// \snippet scene.cpp scene queries
  void visitColliding(const Polygon& polygon, const Pose& pose, const std::function<bool(Body)>& visit,
                      const CollideOptions& options = {}, const BodyFilter& filter = {}) const;
  /// Returns whether the union of the bodies that pass the filter holds all of a posed polygon, as tricover::covers()
  /// says for one area: a vehicle across lanes that overlap or share a border. Exact, for overlapping rings and bodies
  /// alike.
  /// \throws std::invalid_argument as tricover::covers() does, and if one of these bodies that is near has a margin
  /// \snippet covers.cpp scene covers
  bool covers(const Polygon& polygon, const Pose& pose, const CoverOptions& options = {},
              const BodyFilter& filter = {}) const;
  /// Returns the first time at which covers() is false of a moving polygon while all bodies rest, or nothing if they
  /// cover it throughout. Time runs from 0 to 1. The time is never late. Along a border that the polygon follows,
  /// rounding may decide: allow it to stick out a little, by a margin of -1e-6.
  /// \throws std::invalid_argument as covers() does, and for a motion that checkMotion() refuses
  /// \snippet covers.cpp first exit
  std::optional<Exit> firstExit(const Polygon& polygon, const Motion& motion, const CoverOptions& options = {},
                                const BodyFilter& filter = {}) const;
  /// Returns the same along a trajectory, by its clock.
  /// \throws std::invalid_argument as covers() does
  /// \snippet covers.cpp first exit
  std::optional<Exit> firstExit(const Polygon& polygon, const Trajectory& trajectory, const CoverOptions& options = {},
                                const BodyFilter& filter = {}) const;
  /// Returns the body nearest to a polygon among those that pass the filter. Equal distances: the lowest handle.
  /// \throws std::invalid_argument as tricover::distance() does
  /// \snippet scene.cpp scene queries
  std::optional<BodyDistance> nearest(const Polygon& polygon, const Pose& pose, const DistanceOptions& options = {},
                                      const BodyFilter& filter = {}) const;
  /// Returns the same for many poses, in their order.
  /// \throws std::invalid_argument as tricover::distance() does
  /// \snippet scene.cpp parallel
  std::vector<std::optional<BodyDistance>> nearest(const Polygon& polygon, const std::vector<Pose>& poses,
                                                   const DistanceOptions& options = {}, const BodyFilter& filter = {},
                                                   const Parallel& parallel = {}) const;
  /// Returns the same body if it is no farther away than `limit`.
  /// \throws std::invalid_argument as tricover::distanceWithin() does
  /// \snippet scene.cpp scene queries
  std::optional<BodyDistance> nearestWithin(const Polygon& polygon, const Pose& pose, double limit,
                                            const DistanceOptions& options = {}, const BodyFilter& filter = {}) const;
  /// Returns the `most` nearest bodies no farther away than `limit`, or fewer if there are fewer, in the order of
  /// distances, then handles.
  /// \throws std::invalid_argument as tricover::distanceWithin() does
  /// \snippet scene.cpp scene nearest
  std::vector<BodyDistance> nearestK(const Polygon& polygon, const Pose& pose, std::size_t most, double limit,
                                     const DistanceOptions& options = {}, const BodyFilter& filter = {}) const;
  /// Returns the body that a moving polygon comes nearest to among those that pass the filter, and when. All bodies
  /// rest. Equal distances: the lowest handle. LeastDistance::lower_bound holds for all of these bodies.
  /// \throws std::invalid_argument as tricover::leastDistance() does
  /// \snippet scene.cpp scene least distance
  std::optional<BodyLeastDistance> leastDistance(const Polygon& polygon, const Motion& motion,
                                                 const LeastDistanceOptions& options = {},
                                                 const BodyFilter& filter = {}) const;
  /// Returns the same along a trajectory, by its clock.
  /// \throws std::invalid_argument as tricover::leastDistance() does
  /// \snippet scene.cpp scene least distance
  std::optional<BodyLeastDistance> leastDistance(const Polygon& polygon, const Trajectory& trajectory,
                                                 const LeastDistanceOptions& options = {},
                                                 const BodyFilter& filter = {}) const;
  /// Returns the body that a moving polygon meets first among those that pass the filter. All bodies rest. Equal times:
  /// the lowest handle.
  /// \throws std::invalid_argument as timeOfImpact() does
  /// \snippet scene.cpp scene queries
  std::optional<BodyImpact> firstImpact(const Polygon& polygon, const Motion& motion, const ImpactOptions& options = {},
                                        const BodyFilter& filter = {}) const;
  /// Returns the same along a trajectory. Times and `time_error` are by the trajectory's clock.
  /// \throws std::invalid_argument as timeOfImpact() does
  /// \snippet scene.cpp scene trajectories
  std::optional<BodyImpact> firstImpact(const Polygon& polygon, const Trajectory& trajectory,
                                        const ImpactOptions& options = {}, const BodyFilter& filter = {}) const;
  /// Returns all pairs that meet while these bodies move and the others rest, each at its first time. The earliest
  /// comes first, then the order is that of handles.
  /// \throws std::invalid_argument as timeOfImpact() does, and for a body that is named twice
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene
  std::vector<PairImpact> impacts(const std::vector<BodyMotion>& motions, const ImpactOptions& options = {},
                                  const Parallel& parallel = {}) const;
  /// Returns the same along trajectories, from the first begin to the last end of the pair. Times and `time_error` are
  /// by the clock, which is the same for all trajectories.
  /// \throws std::invalid_argument as timeOfImpact() does, and for a body that is named twice
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene trajectories
  std::vector<PairImpact> impacts(const std::vector<BodyTrajectory>& trajectories, const ImpactOptions& options = {},
                                  const Parallel& parallel = {}) const;
  /// Returns all time intervals in which pairs meet, as tricover::conflicts() returns them for each pair. The earliest
  /// comes first, then the order is that of handles.
  /// \throws std::invalid_argument as timeOfImpact() does, and for a body that is named twice
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene
  std::vector<PairConflict> conflicts(const std::vector<BodyMotion>& motions, const ImpactOptions& options = {},
                                      const Parallel& parallel = {}) const;
  /// Returns the same along trajectories, by their clock.
  /// \throws std::invalid_argument as timeOfImpact() does, and for a body that is named twice
  /// \throws std::out_of_range for a handle that names no body
  /// \snippet scene.cpp scene trajectories
  std::vector<PairConflict> conflicts(const std::vector<BodyTrajectory>& trajectories,
                                      const ImpactOptions& options = {}, const Parallel& parallel = {}) const;
  /// Returns the body that a ray from `from` to `to` meets first among those that pass the filter. Equal fractions: the
  /// lowest handle. Margins of a body and of the ray add up.
  /// \throws std::invalid_argument for a point that is not finite, and for a margin that is negative or not finite
  /// \snippet scene.cpp scene queries
  std::optional<BodyRayHit> castRay(const Vec2& from, const Vec2& to, const RayOptions& options = {},
                                    const BodyFilter& filter = {}) const;
  /// Returns all intervals of such a ray that are in bodies that pass the filter, in the order of their begins, then
  /// handles. Bodies may overlap.
  /// \throws std::invalid_argument for a point that is not finite, and for a margin that is negative or not finite
  /// \snippet scene.cpp scene queries
  std::vector<BodyRayInterval> castRayAll(const Vec2& from, const Vec2& to, const RayOptions& options = {},
                                          const BodyFilter& filter = {}) const;

 private:
  std::unique_ptr<detail::SceneState> impl_;
};

}  // namespace tricover
