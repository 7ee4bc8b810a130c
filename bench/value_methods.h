// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tradeoff_scenes.h"
#include "tricover/motion.h"

/// Ways to answer queries whose answer is a number, on a scene that must outlive them.
namespace tricover::bench {

/// Answers the query with that number.
using Asker = std::function<double(std::size_t i)>;

/// In place of a time or a depth: no contact.
constexpr double kNoContact = std::numeric_limits<double>::infinity();

/// One setting of one way of answering, and what it promises: how far it may be off, relative to the truth or, of
/// times, in time. Rivals promise nothing.
struct ValueMethod {
  std::string family, setting;
  double promise;
  /// Prepares what answers; throws where the method can't hold the scene's polygons.
  std::function<Asker()> make;

  std::string name() const { return setting.empty() ? family : family + ", " + setting; }
};

/// Whether both are convex, which some methods need.
bool isConvexPair(const Scene& scene);

/// With all of their settings. `convex`: those for convex polygons, too.
std::vector<ValueMethod> distanceMethods(const Scene& scene, const std::vector<Pose>& poses, bool convex);
std::vector<ValueMethod> impactMethods(const Scene& scene, const std::vector<Motion>& motions, bool convex,
                                       int most_samples);

/// Of polygons that overlap: how far they must move to part; the depth of the deepest contact.
std::vector<ValueMethod> penetrationMethods(const Scene& scene, const std::vector<Pose>& poses, bool convex);
std::vector<ValueMethod> contactMethods(const Scene& scene, const std::vector<Pose>& poses, bool convex);

}  // namespace tricover::bench
