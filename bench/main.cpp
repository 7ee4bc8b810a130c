// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

#include "countries.h"
#include "pictures.h"
#include "report.h"
#include "study.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

void showProgress(std::size_t done, std::size_t total, const std::string& title) {
  if (!isatty(STDERR_FILENO)) return;
  std::fprintf(stderr, "\r\033[K[%zu/%zu] %s", done, total, title.c_str());
  if (done == total) std::fprintf(stderr, "\n");
}

/// Whether every method of ours gave the reference's answer every time.
bool oursAgree(const std::vector<Result>& results) {
  bool agree = true;
  for (const Result& result : results) {
    for (const Timing& timing : result.timings) {
      if (timing.role != Role::Ours || timing.false_alarms + timing.misses == 0) continue;
      std::fprintf(stderr, "error: %s disagrees with tricover cold on %s, %s\n", timing.name.c_str(),
                   result.workload.scene.c_str(), result.workload.name.c_str());
      agree = false;
    }
  }
  return agree;
}

int run(const std::string& data, const std::string& directory, bool full) {
  tricover_fcl::registerNarrowphase();
  std::ifstream in(data);
  if (!in) throw std::runtime_error("cannot read " + data);
  const auto countries = std::make_shared<const Countries>(readCountries(in));
  drawPictures(*countries, directory);

  const Settings settings = full ? Settings{5, 0.02} : Settings{};
  std::vector<std::string> movers = {"Italy", "Norway"};
  if (full) movers.insert(movers.end(), {"Indonesia", "Chile", "Australia"});
  const std::vector<Cell> cells = studyCells(full);
  const std::size_t total = 2 * movers.size() + cells.size();
  std::size_t done = 0;
  std::vector<Result> results;
  for (const std::string& mover : movers) {
    for (const char* trajectory : {"circular", "linear"}) {
      showProgress(done++, total, mover + ", " + trajectory);
      results.push_back(measureDrive(countries, mover, trajectory, settings));
    }
  }
  for (const Cell& cell : cells) {
    showProgress(done++, total, name(cell.kind) + ", " + std::to_string(cell.vertices_fixed) + " x " +
                                    std::to_string(cell.vertices_moving));
    for (Result& result : measureCell(cell, settings)) results.push_back(std::move(result));
  }
  showProgress(total, total, "done");

  const std::string tables = "# One country among all the others\n\n" + table(results, "countries") +
                             "\n# The paper's workloads (Table 2), equally many vertices\n\n" + table(results, "paper");
  const std::string how = "\n# How it was measured\n\n" + conditions(settings);
  std::fputs((tables + how).c_str(), stdout);
  writeFile(directory + "/tables.md",
            tables + "\n# The grid of Figure 12: vertices fixed x moving\n\n" + table(results, "grid") + how);
  writeFile(directory + "/results.csv", csv(results));
  writePlotData(results, directory);
  return oursAgree(results) ? 0 : 1;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  const bool full = argc == 4 && std::string(argv[3]) == "--full";
  if (argc != 3 && !full) {
    std::fprintf(stderr, "usage: %s <countries file> <existing report directory> [--full]\n", argv[0]);
    return 2;
  }
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  char* benchmark_arguments[] = {argv[0], interleave.data(), nullptr};
  int benchmark_count = 2;
  benchmark::Initialize(&benchmark_count, benchmark_arguments);
  try {
    return tricover::bench::run(argv[1], argv[2], full);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
