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
#include "tricover/distance.h"
#include "tricover/export.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"
#include "tricover/ray.h"
#include "tricover/time_of_impact.h"
#include "tricover/touching.h"
#include "tricover/trajectory.h"

namespace tricover {

/// How many things at once: calls task(i) for every i in [0, count), in any order and on any threads, and returns when
/// all are done. An exception of a task is to be thrown on. Empty: one after the other.
/// \snippet scene.cpp parallel
using Parallel = std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// A handle of a Scene. It names a body until that is removed, and never another one: the body's slot, and above 32
/// bits how many bodies have had that before.
using BodyHandle = std::uint64_t;

/// A body's slot, for arrays of one's own: no two bodies have the same one at once, and they are below the number of
/// bodies that there have been at once (more by those whose pairs collisions() is yet to report as ended).
/// \snippet scene.cpp scene handles
constexpr std::uint32_t slotOf(BodyHandle body) { return static_cast<std::uint32_t>(body); }

/// All bits of a mask.
constexpr std::uint32_t kEveryCategory = ~std::uint32_t{0};

/// What a body is beside its polygon.
struct BodyOptions {
  /// A world length, at least 0. Every query is about the body grown by it: margins of two bodies, and of a body and a
  /// query, add up (rounded to the nearest double).
  double margin = 0;
  std::uint32_t category = 1;  ///< Bits: what the body is.
  std::uint32_t mask =
      kEveryCategory;  ///< Bits: what it meets. Two bodies meet if each has a category of the other's mask.
  /// Allowed: what only touches this body doesn't collide with it, be it another body or the polygon of a query,
  /// whatever those say: as CollideOptions::touching has it. (An impact is the first touch all the same; see
  /// ImpactOptions::ignore_initial for those that touch at the start.)
  /// \snippet scene.cpp scene touching
  Touching touching = Touching::Collides;
};

/// A body that is to come into a scene.
struct BodyPlacement {
  Polygon polygon;      ///< What it is.
  Pose pose;            ///< Where it is.
  BodyOptions options;  ///< And what else.
};

/// Where a body is to go.
struct BodyPose {
  BodyHandle body;  ///< Which one.
  Pose pose;        ///< In place of its pose.
};

/// Names no body.
constexpr BodyHandle kNoBody = ~BodyHandle{0};

/// Selects the bodies of a query by category, and may leave one of them out. A mask converts to a filter.
/// A query throws std::out_of_range if `except` is neither kNoBody nor a body of the scene.
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

/// Two bodies, the lower handle first.
struct BodyPair {
  BodyHandle first;   ///< The lower handle.
  BodyHandle second;  ///< The higher handle.
  /// Whether they are of the same bodies.
  friend bool operator==(const BodyPair& p, const BodyPair& q) { return p.first == q.first && p.second == q.second; }
  /// Whether they are of other bodies.
  friend bool operator!=(const BodyPair& p, const BodyPair& q) { return !(p == q); }
  /// By the first body, then by the second.
  friend bool operator<(const BodyPair& p, const BodyPair& q) {
    return p.first != q.first ? p.first < q.first : p.second < q.second;
  }
};

/// A polygon's distance from a body.
struct BodyDistance {
  BodyHandle body;        ///< Which one.
  DistanceResult result;  ///< a is the polygon that was asked for, b the body.
};

/// A moving polygon's impact on a body.
struct BodyImpact {
  BodyHandle body;  ///< Which one.
  Impact impact;    ///< a is the polygon that was asked for, b the body.
};

/// How a body moves from time 0 to 1.
struct BodyMotion {
  BodyHandle body;  ///< Which one.
  Motion motion;    ///< In place of its pose.
};

/// How a body moves by a clock of the caller's. Before its begin and after its end it rests where that is, whatever its
/// pose.
struct BodyTrajectory {
  BodyHandle body;        ///< Which one.
  Trajectory trajectory;  ///< In place of its pose.
};

/// The impact of two bodies.
struct PairImpact {
  BodyPair pair;  ///< Which ones.
  Impact impact;  ///< a is pair.first, b is pair.second.
};

/// A span of time in which two bodies meet.
struct PairConflict {
  BodyPair pair;      ///< Which ones.
  Conflict conflict;  ///< a is pair.first, b is pair.second.
};

/// Where a ray meets a body.
struct BodyRayHit {
  BodyHandle body;  ///< Which one.
  RayHit hit;       ///< Where, as castRay() says it.
};

namespace detail {
struct SceneState;
}

/// Many polygons under poses of their own, and what collides among them.
///
/// Every answer is the exact one of collide(), distance(), timeOfImpact() and castRay() for the bodies concerned, and
/// depends neither on what was asked before nor on the order in which bodies came nor on threads. Const functions may
/// be called by any number of threads at once while no other function runs.
///
/// It extends the paper's coherence to many moving objects. Each body counts how far its points have moved in all; two
/// bodies that were c apart need not be looked at before both counts together have grown by c. So collisions() costs
/// the bodies that moved and the pairs whose facts ran out.
///
/// Bodies come into a tree of boxes at the next query, all that wait together. Memory: about 300 bytes a body and 100 a
/// pair of bodies whose surroundings meet, and up to twice that where lists have just grown, beside the polygons, which
/// are shared.
///
/// \snippet scene.cpp scene
class TRICOVER_EXPORT Scene {
 public:
  using Body = BodyHandle;  ///< A handle.

  Scene();  ///< Without bodies.
  ~Scene();
  /// A scene of its own with the same bodies under the same handles, the polygons shared: for planners that branch. It
  /// copies what the scene takes, about 300 bytes a body and 100 a pair.
  Scene(const Scene& other);
  Scene& operator=(const Scene& other);  ///< The same, instead of its bodies.
  Scene(Scene&& other);                  ///< Leaves the other one without bodies.
  Scene& operator=(Scene&& other);       ///< Leaves the other one without bodies, too.

  /// Puts a polygon into the scene and says how it is called from now on. Throws std::invalid_argument as
  /// tricover::collide() does for the pose and the margin, std::length_error for more than 2^28 bodies and as
  /// tricover::collide() does. A throw changes nothing, here as in what follows.
  /// \snippet scene.cpp scene bodies
  Body add(const Polygon& polygon, const Pose& pose, const BodyOptions& options = {});
  /// Many at once, and how they are called, in their order: what add() does one after the other, or nothing if it
  /// throws.
  /// \snippet scene.cpp scene bodies
  std::vector<Body> add(const std::vector<BodyPlacement>& bodies);
  /// Takes a body out. Throws std::out_of_range for a handle that names nothing.
  /// \snippet scene.cpp scene bodies
  void remove(Body body);
  /// Puts a body where it is now. Throws as add() and remove() do.
  /// \snippet scene.cpp scene bodies
  void move(Body body, const Pose& pose);
  /// Makes a body another kind of body. collisions() goes on: a pair that collides before and after neither ends nor
  /// begins. Throws as add() and remove() do.
  /// \snippet scene.cpp scene handles
  void setOptions(Body body, const BodyOptions& options);
  /// Many at once: what move() does one after the other, whatever runs it, or nothing if it throws for a body or a
  /// pose. What `parallel` throws itself, and std::bad_alloc, may leave some where they were. \snippet scene.cpp scene
  /// frames
  void move(const std::vector<BodyPose>& poses, const Parallel& parallel = {});

  /// How many bodies there are.
  /// \snippet scene.cpp scene bodies
  std::size_t size() const;
  /// Their handles, sorted.
  /// \snippet scene.cpp scene bodies
  std::vector<Body> bodies() const;
  /// Whether the handle names one.
  /// \snippet scene.cpp scene bodies
  bool contains(Body body) const;
  /// What a body is. Throws as remove() does.
  /// \snippet scene.cpp scene bodies
  const Polygon& polygon(Body body) const;
  /// Where a body is. Throws as remove() does.
  /// \snippet scene.cpp scene bodies
  const Pose& pose(Body body) const;
  /// A body's options, as they were given. Throws as remove() does.
  /// \snippet scene.cpp scene bodies
  const BodyOptions& options(Body body) const;

  /// The pairs that collide now, sorted, whatever runs it. Those that only touch do, unless one of both
  /// allows it (BodyOptions::touching). The reference is good until the next call of a function that
  /// isn't const.
  /// \snippet scene.cpp scene frames
  const std::vector<BodyPair>& collisions(const Parallel& parallel = {});
  /// Of the last two calls of collisions(): the pairs that collide since, sorted.
  /// \snippet scene.cpp scene frames
  const std::vector<BodyPair>& began() const;
  /// The pairs that don't any more, sorted; also those whose bodies were removed.
  /// \snippet scene.cpp scene frames
  const std::vector<BodyPair>& ended() const;

  /// Whether a polygon at a pose collides with a body, of those that pass the filter. Throws as
  /// tricover::collide() does.
  /// \snippet scene.cpp scene queries
  bool collides(const Polygon& polygon, const Pose& pose, const CollideOptions& options = {},
                const BodyFilter& filter = {}) const;
  /// The same for many poses at once, in their order, whatever runs it.
  /// \snippet scene.cpp parallel
  std::vector<bool> collides(const Polygon& polygon, const std::vector<Pose>& poses, const CollideOptions& options = {},
                             const BodyFilter& filter = {}, const Parallel& parallel = {}) const;
  /// A body that a polygon collides with, of those that pass the filter; of several it isn't said which.
  /// Throws as tricover::collide() does.
  /// \snippet scene.cpp scene queries
  std::optional<Body> anyColliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options = {},
                                   const BodyFilter& filter = {}) const;
  /// All bodies that a polygon collides with, of those that pass the filter, sorted. Throws as
  /// tricover::collide() does.
  /// \snippet scene.cpp scene queries
  std::vector<Body> colliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options = {},
                              const BodyFilter& filter = {}) const;
  /// The body nearest to a polygon, of those that pass the filter; of several at the same distance the one of
  /// the lowest handle. Throws as tricover::distance() does.
  /// \snippet scene.cpp scene queries
  std::optional<BodyDistance> nearest(const Polygon& polygon, const Pose& pose, const DistanceOptions& options = {},
                                      const BodyFilter& filter = {}) const;
  /// The same, if it is no farther away than `limit`. Throws as tricover::distanceWithin() does.
  /// \snippet scene.cpp scene queries
  std::optional<BodyDistance> nearestWithin(const Polygon& polygon, const Pose& pose, double limit,
                                            const DistanceOptions& options = {}, const BodyFilter& filter = {}) const;
  /// So many bodies, or all that there are, that are nearest to a polygon and no farther away than `limit`: by their
  /// distances, then by their handles. Throws as tricover::distanceWithin() does.
  /// \snippet scene.cpp scene nearest
  std::vector<BodyDistance> nearestFew(const Polygon& polygon, const Pose& pose, std::size_t count, double limit,
                                       const DistanceOptions& options = {}, const BodyFilter& filter = {}) const;
  /// The body that a moving polygon meets first, of those that pass the filter, all at rest; of several at
  /// the same time the one of the lowest handle. Throws as timeOfImpact() does.
  /// \snippet scene.cpp scene queries
  std::optional<BodyImpact> firstImpact(const Polygon& polygon, const Motion& motion, const ImpactOptions& options = {},
                                        const BodyFilter& filter = {}) const;
  /// The same along a trajectory; times, and `time_error`, are its own.
  /// \snippet scene.cpp scene trajectories
  std::optional<BodyImpact> firstImpact(const Polygon& polygon, const Trajectory& trajectory,
                                        const ImpactOptions& options = {}, const BodyFilter& filter = {}) const;
  /// All pairs that meet while these bodies move and the others rest, each at its first time: earliest first, then by
  /// handles. Throws as timeOfImpact() and remove() do, and std::invalid_argument for a body that is named twice.
  /// \snippet scene.cpp scene
  std::vector<PairImpact> impacts(const std::vector<BodyMotion>& motions, const ImpactOptions& options = {},
                                  const Parallel& parallel = {}) const;
  /// The same along trajectories, from the first begin to the last end of the pair; times, and `time_error`, are by
  /// their clock, which is the same for all.
  /// \snippet scene.cpp scene trajectories
  std::vector<PairImpact> impacts(const std::vector<BodyTrajectory>& trajectories, const ImpactOptions& options = {},
                                  const Parallel& parallel = {}) const;
  /// All spans of time in which pairs meet, as tricover::conflicts() says them of each pair: earliest first, then by
  /// handles. Throws as impacts() does.
  /// \snippet scene.cpp scene trajectories
  std::vector<PairConflict> conflicts(const std::vector<BodyTrajectory>& trajectories,
                                      const ImpactOptions& options = {}, const Parallel& parallel = {}) const;
  /// The body that a ray meets first on the way from `from` to `to`, as tricover::castRay(), of those that pass
  /// the filter; of several at the same fraction the one of the lowest handle. Margins of a body and of the
  /// ray add up. Throws as tricover::castRay() does.
  /// \snippet scene.cpp scene queries
  std::optional<BodyRayHit> castRay(const Vec2& from, const Vec2& to, const RayOptions& options = {},
                                    const BodyFilter& filter = {}) const;

 private:
  std::unique_ptr<detail::SceneState> impl_;
};

}  // namespace tricover
