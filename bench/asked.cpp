// SPDX-License-Identifier: BSD-3-Clause
// Studies of the core alone: contacts, caches, islands, narrow gaps, containers, maps at rest. Needs no FCL.
#include "asked.h"

#include <string>

#include "report.h"

namespace tricover::bench {

bool run(const std::string& directory, bool) {
  // Maps come first: their bytes are the heap's.
  return writeStudies(
      directory, "asked",
      {{"Maps at rest", measureStillMaps()},
       {"Layouts in their containers", measureContainers()},
       {"Contacts, by their detail", measureContactCosts()},
       {"With a cache and without", measureCaches()},
       {"A car in an area", measureCovers()},
       {"A map of islands", measureIslands()},
       {"Robots in maps", measureRobots()},
       {"Narrow gaps", measureGaps()},
       {"Contact that lasts", measureLastingContact()},
       {"Outward simplification", measureSimplification()}},
      "- CPU time of one thread, medians, methods in turn; of narrow gaps and contact that lasts the least of five "
      "means.\n"
      "- Containers: eight parts are taken out and placed anew. The scan tests all boxes, calls collide() "
      "where they meet,\n  and tests the container where a box leaves its hole.\n",
      "Nanoseconds per query, or bytes, or a vertex, where that is said");
}

}  // namespace tricover::bench
