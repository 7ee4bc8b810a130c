// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "target.h"

/// What contacts cost, by what is asked of an overlap.
namespace tricover::bench {

struct ContactCost {
  std::string polygons, poses;
  std::vector<double> ns;  ///< a query, of each of contactQuestions()
};

/// "crossings", "contacts", "penetration", and GEOS's whole overlay.
const std::vector<std::string>& contactQuestions();

std::vector<ContactCost> measureContactCosts();

/// Of convex pairs whose boundaries cross more than twice beside those that cross twice.
std::vector<Target> judgeContactCosts(const std::vector<ContactCost>& costs);

}  // namespace tricover::bench
