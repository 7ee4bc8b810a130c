// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <stdexcept>
#include <string>

#include "countries.h"
#include "measure.h"
#include "report.h"
#include "studies.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

struct Study {
  const char* title;
  std::vector<Result> results;
};

int run(const std::string& data, const std::string& directory, bool full) {
  tricover_fcl::registerNarrowphase();
  std::ifstream in(data);
  if (!in) throw std::runtime_error("cannot read " + data);
  drawPictures(readCountries(in), directory);

  // Five repetitions of 3 ms: the whole grid takes about 20 minutes.
  const Settings settings = full ? Settings{5, 0.003} : Settings{};
  const auto measureAll = [&](const char* what, const std::vector<Cell>& cells, auto measureOne) {
    std::vector<Result> results;
    std::size_t done = 0;
    for (const Cell& cell : cells) {
      showProgress(++done, cells.size(),
                   what + name(cell.kind) + ", " + std::to_string(cell.vertices_fixed) + " x " +
                       std::to_string(cell.vertices_moving));
      for (Result& result : measureOne(cell, settings)) results.push_back(std::move(result));
    }
    return results;
  };
  const Study studies[] = {
      {"Every kind, vertices fixed x moving", measureAll("collide, ", studyCells(full), measureCell)},
      {"Distances", measureAll("distance, ", distanceCells(full), measureDistances)},
      {"Times of impact", measureAll("time of impact, ", impactCells(full), measureImpacts)},
      {"Contacts", measureContacts(settings)},
      {"Polygons and round shapes", measureRounds(settings)},
      {"Soups and overlapping rings", measureSoups(settings)}};
  std::vector<Result> all;
  std::string text;
  for (const Study& study : studies) {
    text += "# " + std::string(study.title) + "\n\n" + table(study.results) + "\n";
    all.insert(all.end(), study.results.begin(), study.results.end());
  }
  writeFile(directory + "/tables.md", text);
  writeFile(directory + "/conditions.md", "# How it was measured\n\n" + conditions(settings));
  writeFile(directory + "/results.csv", csv(all));
  writePlotData(studies[0].results, studies[1].results, studies[2].results, directory);
  return oursAgree(all) ? 0 : 1;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) { return tricover::bench::runStudy(argc, argv, tricover::bench::run); }
