// SPDX-License-Identifier: BSD-3-Clause
// Studies of the core alone: contacts, caches, islands, narrow gaps, containers, maps at rest. Needs no FCL.
#include "asked.h"

#include <string>

#include "report.h"

namespace tricover::bench {
namespace {

int run(const std::string& directory) {
  struct Study {
    const char* title;
    std::vector<Result> (*measure)();
  };
  // Maps come first: their bytes are the heap's.
  const Study studies[] = {{"Maps at rest", measureStillMaps},
                           {"Layouts in their containers", measureContainers},
                           {"Contacts, by their detail", measureContactCosts},
                           {"With a cache and without", measureCaches},
                           {"A map of islands", measureIslands},
                           {"Narrow gaps", measureGaps}};
  std::string text;
  std::vector<Result> all;
  for (const Study& study : studies) {
    const std::vector<Result> results = study.measure();
    text += std::string("# ") + study.title + "\n\n" +
            table(results, "Nanoseconds per query, or bytes where that is said") + "\n";
    all.insert(all.end(), results.begin(), results.end());
  }
  writeFile(directory + "/asked.md", text +
                                         "- CPU time of one thread, medians, methods in turn; of narrow gaps the "
                                         "least of five means.\n- Containers: eight parts are taken out and placed "
                                         "anew. The scan tests all boxes, calls collide() where they meet,\n  and "
                                         "tests the container where a box leaves its hole.\n");
  writeFile(directory + "/asked.csv", csv(all));
  return 0;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  return runProgram(argv[0], "<existing report directory>", argc == 2, [&] { return run(argv[1]); });
}
