// SPDX-License-Identifier: BSD-3-Clause
// What contacts cost by what is asked, what a cache costs, and one polygon of many islands beside a scene of them.
// Needs no FCL.
#include <string>
#include <vector>

#include "cache_costs.h"
#include "contact_costs.h"
#include "islands.h"
#include "measure.h"
#include "report.h"

namespace tricover::bench {
namespace {

std::string contactTable(const std::vector<ContactCost>& costs) {
  TextTable lines = {{"polygons", "poses"}};
  for (const std::string& question : contactQuestions()) lines[0].push_back(question + ": ns");
  for (const ContactCost& cost : costs) {
    lines.push_back({cost.polygons, cost.poses});
    for (const double ns : cost.ns) lines.back().push_back(shortNumber(ns));
  }
  return markdown(lines);
}

/// Cached / without, a row a walk.
std::string cacheTable(const std::vector<CacheCost>& costs) {
  TextTable lines = {{"polygons", "walk"}};
  for (const CacheCost& cost : costs) {
    if (lines.size() == 1 || lines.back()[0] != cost.polygons || lines.back()[1] != cost.walk)
      lines.push_back({cost.polygons, cost.walk});
    if (lines.size() == 2) lines[0].insert(lines[0].end(), {cost.query + ": ns", "cached", "ratio"});
    lines.back().insert(lines.back().end(), {shortNumber(cost.none_ns), shortNumber(cost.cached_ns),
                                             formatted("%.2f", cost.cached_ns / cost.none_ns)});
  }
  return markdown(lines);
}

std::string islandTable(const std::vector<IslandCost>& costs) {
  TextTable lines = {{"islands", "query", "one polygon: ns", "Scene: ns", "times", "dearest query, prepared: ms"}};
  for (const IslandCost& cost : costs) {
    lines.push_back({std::to_string(cost.islands), cost.query, shortNumber(cost.polygon_ns), shortNumber(cost.scene_ns),
                     formatted("%.2f", cost.polygon_ns / cost.scene_ns), shortNumber(cost.dearest_ms)});
  }
  return markdown(lines);
}

std::string askedCsv(const std::vector<ContactCost>& contacts, const std::vector<CacheCost>& caches,
                     const std::vector<IslandCost>& islands) {
  std::string csv = "input,case,query,ns\n";
  const auto add = [&](const std::string& input, const std::string& name, const std::string& query, double ns) {
    csv += '"' + input + "\",\"" + name + "\",\"" + query + "\"," + shortNumber(ns) + '\n';
  };
  for (const ContactCost& cost : contacts)
    for (std::size_t i = 0; i < cost.ns.size(); ++i) add(cost.polygons, cost.poses, contactQuestions()[i], cost.ns[i]);
  for (const CacheCost& cost : caches) {
    add(cost.polygons, cost.walk, cost.query, cost.none_ns);
    add(cost.polygons, cost.walk, cost.query + ", cached", cost.cached_ns);
  }
  for (const IslandCost& cost : islands) {
    add(std::to_string(cost.islands) + " islands", "one polygon", cost.query, cost.polygon_ns);
    add(std::to_string(cost.islands) + " islands", "Scene", cost.query, cost.scene_ns);
  }
  return csv;
}

int run(const std::string& directory) {
  const std::vector<ContactCost> contacts = measureContactCosts();
  const std::vector<CacheCost> caches = measureCaches();
  const std::vector<IslandCost> islands = measureIslands();
  std::vector<Target> targets = judgeContactCosts(contacts);
  for (Target& target : judgeCaches(caches)) targets.push_back(std::move(target));
  for (Target& target : judgeIslands(islands)) targets.push_back(std::move(target));
  writeFile(directory + "/asked.md",
            "# Contacts, by what is asked\n\n" + contactTable(contacts) + "\n# With a cache and without\n\n" +
                cacheTable(caches) + "\n# A map of islands\n\n" + islandTable(islands) + "\n" + targetsTable(targets) +
                "\n- CPU time of one thread, medians, methods in turn.\n");
  writeFile(directory + "/asked.csv", askedCsv(contacts, caches, islands));
  writeFile(directory + "/asked_targets.csv", targetsCsv(targets));
  return 0;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  return runProgram(argv[0], "<existing report directory>", argc == 2, [&] { return run(argv[1]); });
}
