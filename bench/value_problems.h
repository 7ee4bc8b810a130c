// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "measure.h"
#include "tradeoff_methods.h"
#include "tradeoff_scenes.h"

namespace tricover::bench {

/// A query, and how its answers are judged.
struct ValueQuery {
  std::string name;
  enum class Error { OfTruth, OfSize, OfTime } error;  ///< relative to the truth, to the size, or a part of the motion
  /// Whether a value is not just inexact but wrong.
  bool (*is_wrong)(double value, double truth, double size);
};

/// Wrong are: a distance of 0, or none, where the regions are apart by more than 1e-13 of the size; a time later than
/// the truth by more than 1e-9, or a contact missed; a depth by which they don't part, by more than 1e-9 of the size,
/// or no contact where there is one.
extern const ValueQuery kDistance, kImpact, kPenetration, kContacts;

/// Queries of one kind about one pair of polygons.
struct ValueProblem {
  ValueQuery query;
  std::string group;
  const KnownScene* scene;
  Values truth;  ///< one a query
  std::vector<ValueMethod> methods;
  /// Whether rounding may do that to one of our answers beyond what the method promises; nothing: it may not.
  std::function<bool(std::size_t query, double value)> may_round = nullptr;
};

/// How far one answer is off.
struct ValueError {
  double relative;  ///< to the truth; 1 where it is more, or where one of both is nothing
  double of_size;   ///< a part of the polygons' size; of times, of the motion
  double counted;   ///< the one of both that the query counts
  bool wrong;
  bool keeps_promise;
};

/// The error of an answer to that query, which may be NaN.
ValueError errorOf(const ValueProblem& problem, const ValueMethod& method, std::size_t query, double value);

/// Distances at those of the scene's poses that are apart by 1e-13 of the size or more.
ValueProblem nearDistances(const KnownScene& scene, bool convex);

/// Contacts at those poses that are 1e-13 of the size or more behind first contact. Both polygons must be convex.
ValueProblem shallowContacts(const KnownScene& scene);

/// The depth of two convex polygons, rounded down.
double exactDepth(const KnownScene& scene, const Pose& pose);

/// Distances, times of impact, contacts of convex polygons, and penetrations of the scenes, which must outlive them.
/// Throws std::logic_error if a time of impact is late.
std::vector<ValueProblem> valueProblems(const std::vector<KnownScene>& scenes, bool full);

/// Time against error of distances, times of impact and penetrations, ours at all settings and the rivals' at theirs,
/// against truths that exact arithmetic gave or confirmed. Writes `<directory>/values.md`, values.csv and values.dat,
/// which tradeoff.gp draws. False if one of ours is off by more than its setting allows.
bool runValueTradeoff(const std::string& directory, bool full);

/// Wrong collisions, and what distances, times of impact, penetrations and contacts are off by, with the scene moved
/// far from the origin, scaled, and squeezed to slivers, each method at its best settings, against exact arithmetic.
/// Writes
/// `<directory>/extremes.md`, .csv and .dat. False if one of ours is wrong, or off by more than it allows.
bool runExtremes(const std::string& directory, bool full);

}  // namespace tricover::bench
