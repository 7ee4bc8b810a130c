// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "countries.h"
#include "drive_study.h"
#include "measure.h"
#include "pictures.h"
#include "plot_data.h"
#include "report.h"
#include "studies.h"
#include "targets.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

/// All tables and CSV files; returns all results.
std::vector<Result> writeReport(const Measured& measured, const std::vector<Result>& drives,
                                const std::vector<Result>& splines, const Settings& settings,
                                const std::string& directory) {
  const std::vector<Target> targets = judge(measured);
  const std::string main_job = "# One country among all the others\n\n" + table(drives);
  const std::string how = "\n# How it was measured\n\n" + conditions(settings);
  const std::string summary = "# Targets\n\n" + targetsTable(targets) + "\n";
  std::fputs((summary + main_job + how).c_str(), stdout);
  writeFile(directory + "/targets.md", summary);
  writeFile(directory + "/targets.csv", targetsCsv(targets));
  writeFile(directory + "/conditions.md", how);
  writeFile(directory + "/round.md", "# Polygons and round shapes\n\n" + table(measured.rounds));
  writeFile(directory + "/discs.md",
            "# Discs\n\n" + table(measured.discs) + "\n# A fleet of round robots\n\n" + table({measured.round_fleet}));
  writeFile(directory + "/soups.md", "# Soups and overlapping rings\n\n" + table(measured.soups));
  writeFile(directory + "/splines.md", "# Splines\n\n" + table(splines));
  writeFile(directory + "/tables.md", summary + main_job + "\n# Every kind, vertices fixed x moving\n\n" +
                                          table(measured.study) + "\n# Distances\n\n" + table(measured.distances) +
                                          "\n# Times of impact\n\n" + table(measured.impacts) + "\n# Contacts\n\n" +
                                          table(measured.contacts) + how);
  writePlotData(measured.study, measured.distances, measured.impacts, directory);

  std::vector<Result> all = drives;
  all.push_back(measured.round_fleet);
  for (const auto* results : {&measured.study, &measured.distances, &measured.impacts, &measured.contacts,
                              &measured.rounds, &measured.discs, &measured.soups, &splines}) {
    all.insert(all.end(), results->begin(), results->end());
  }
  writeFile(directory + "/results.csv", csv(all));
  return all;
}

int run(const std::string& data, const std::string& directory, bool full) {
  tricover_fcl::registerNarrowphase();
  std::ifstream in(data);
  if (!in) throw std::runtime_error("cannot read " + data);
  const auto countries = std::make_shared<const Countries>(readCountries(in));
  drawPictures(*countries, directory);

  // Five repetitions of 3 ms: the whole grid takes about 20 minutes.
  const Settings settings = full ? Settings{5, 0.003} : Settings{};
  std::vector<std::string> movers = {"Italy", "Norway"};
  if (full) movers.insert(movers.end(), {"Indonesia", "Chile", "Australia"});
  const std::vector<Cell> cells = studyCells(full);
  const std::vector<Cell> distance_cells = distanceCells(full), impact_cells = impactCells(full);
  const std::size_t total = 2 * movers.size() + 6 + cells.size() + distance_cells.size() + impact_cells.size();
  std::size_t done = 0;
  Measured measured;
  std::vector<Result> drives;
  for (const std::string& mover : movers) {
    for (const char* trajectory : {"circular", "linear"}) {
      showProgress(done++, total, mover + ", " + trajectory);
      drives.push_back(measureDrive(countries, mover, trajectory, settings));
    }
  }
  showProgress(done++, total, "memory and building");
  measured.footprints = measureFootprints(settings);
  showProgress(done++, total, "contacts");
  measured.contacts = measureContacts(settings);
  showProgress(done++, total, "round shapes");
  measured.rounds = measureRounds(settings);
  showProgress(done++, total, "discs");
  measured.discs = measureDiscs(settings);
  measured.round_fleet = measureRoundFleet(settings);
  showProgress(done++, total, "soups");
  measured.soups = measureSoups(settings);
  showProgress(done++, total, "splines");
  const std::vector<Result> splines = measureSplines(settings);
  const auto measureAll = [&](const char* what, const std::vector<Cell>& some, auto measureOne,
                              std::vector<Result>& to) {
    for (const Cell& cell : some) {
      showProgress(done++, total,
                   what + name(cell.kind) + ", " + std::to_string(cell.vertices_fixed) + " x " +
                       std::to_string(cell.vertices_moving));
      for (Result& result : measureOne(cell, settings)) to.push_back(std::move(result));
    }
  };
  measureAll("", cells, measureCell, measured.study);
  measureAll("distance, ", distance_cells, measureDistances, measured.distances);
  measureAll("time of impact, ", impact_cells, measureImpacts, measured.impacts);
  showProgress(total, total, "done");
  const std::vector<Result> all = writeReport(measured, drives, splines, settings, directory);
  return oursAgree(all) ? 0 : 1;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) { return tricover::bench::runStudy(argc, argv, tricover::bench::run); }
