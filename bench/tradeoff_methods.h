// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "measure.h"
#include "tradeoff_scenes.h"
#include "tricover/motion.h"

/// Ways to answer queries about a scene that must outlive them, with all of their settings.
namespace tricover::bench {

/// In place of a time or a depth: no contact.
constexpr double kNoContact = std::numeric_limits<double>::infinity();

/// One setting of one way of answering, and what it promises: how far it may be off, relative to the truth or, of
/// times, in time. Rivals promise nothing, which is infinity.
template <class Answers>
struct MethodFor {
  std::string family, setting;
  double promise;
  /// Prepares what answers, yet without a name; throws where the method can't hold the scene's polygons.
  std::function<ContenderFor<Answers>()> make;

  std::string name() const { return setting.empty() ? family : family + ", " + setting; }
};
using CollisionMethod = MethodFor<Hits>;
using ValueMethod = MethodFor<Values>;

/// Whether both are convex, which some methods need.
bool isConvexPair(const KnownScene& scene);

/// About the scene's poses: tricover's stages alone, its tolerances, its kernel with plain signs, the exact one, and
/// the rivals. `convex`: those for convex polygons, too.
std::vector<CollisionMethod> collisionMethods(const KnownScene& scene, bool convex);

/// The family that must never be wrong, and the one that must keep to its tolerance.
constexpr const char* kExact = "tricover, exact";
constexpr const char* kTolerance = "tricover, tolerance";

std::vector<ValueMethod> distanceMethods(const KnownScene& scene, const std::vector<Pose>& poses, bool convex);
std::vector<ValueMethod> impactMethods(const KnownScene& scene, const std::vector<Motion>& motions, bool convex,
                                       int most_samples);

/// For polygons that overlap: how far they must move to part; the depth of the deepest contact.
std::vector<ValueMethod> penetrationMethods(const KnownScene& scene, const std::vector<Pose>& poses, bool convex);
std::vector<ValueMethod> contactMethods(const KnownScene& scene, const std::vector<Pose>& poses, bool convex);

}  // namespace tricover::bench
