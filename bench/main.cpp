// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "measure.h"
#include "report.h"
#include "studies.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {

bool run(const std::string& directory, bool full) {
  tricover_fcl::registerNarrowphase();
  drawPictures(directory);
  // Five repetitions of 3 ms: the whole grid takes about 20 minutes.
  const Settings settings = full ? Settings{5, 0.003} : Settings{};
  const std::vector<Study> studies = {{"Every kind, vertices fixed x moving", measureCollisions(full, settings)},
                                      {"Distances", measureDistances(full, settings)},
                                      {"Times of impact", measureImpacts(full, settings)},
                                      {"Contacts", measureContacts(settings)},
                                      {"Polygons and round shapes", measureRounds(settings)},
                                      {"Soups and overlapping rings", measureSoups(settings)}};
  writeFile(directory + "/conditions.md", "# How it was measured\n\n" + conditions(settings));
  writePlotData(studies[0].results, studies[1].results, studies[2].results, directory);
  return writeStudies(directory, "results", studies, "");
}

}  // namespace tricover::bench
