// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "measure.h"
#include "tradeoff_scenes.h"
#include "value_methods.h"

namespace tricover::bench {

/// What is asked, and how its answers are judged.
struct ValueQuery {
  std::string name;
  enum class Error { OfTruth, OfSize, OfTime } error;  ///< relative to the truth, to the size, or a part of the motion
  /// Whether a value is not just inexact but wrong.
  bool (*is_wrong)(double value, double truth, double size);
};

/// Wrong are: a distance of 0, or none, where the regions are apart by more than 1e-13 of the size; a time later than
/// the truth by more than 1e-9, or a contact missed; a depth by which they don't part, by more than 1e-9 of the size,
/// or no contact where there is one.
const ValueQuery& distanceQuery();
const ValueQuery& impactQuery();
const ValueQuery& penetrationQuery();
const ValueQuery& contactQuery();

/// Queries of one kind about one pair of polygons.
struct ValueProblem {
  ValueQuery query;
  std::string group;
  const Scene* scene;
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

/// Of the answer to that query, which may be NaN.
ValueError errorOf(const ValueProblem& problem, const ValueMethod& method, std::size_t query, double value);

/// Of the scene's placements those that are apart by 1e-13 of the size or more.
ValueProblem nearDistances(const Scene& scene, bool convex);

/// Of the placements those that are 1e-13 of the size or more behind first contact. Both polygons must be convex.
ValueProblem shallowContacts(const Scene& scene);

/// The depth of two convex polygons, rounded down.
double exactDepth(const Scene& scene, const Pose& pose);

/// Distances, times of impact, contacts of convex polygons, and penetrations of the scenes, which must outlive them.
/// Throws std::logic_error if a time of impact is late.
std::vector<ValueProblem> valueProblems(const std::vector<Scene>& scenes, bool full);

}  // namespace tricover::bench
