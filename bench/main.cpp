// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

#include "contenders.h"
#include "countries.h"
#include "pictures.h"
#include "report.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

/// A workload is made when its turn comes: all of them together would take gigabytes.
struct Plan {
  std::string title;
  std::function<Workload()> make;
};

Workload paperWorkload(Kind kind, const std::string& trajectory, std::size_t fixed_vertices,
                       std::size_t moving_vertices) {
  const Polygon fixed = workloads::makePolygon(kind, fixed_vertices, 1);
  const Polygon moving = workloads::makePolygon(kind, moving_vertices, 2);
  auto poses = trajectory == "circular" ? workloads::circularTrajectory(fixed, moving)
                                        : workloads::linearTrajectory(fixed, moving);
  const auto passage = std::make_shared<const Passage>(Passage{fixed, moving, std::move(poses)});
  auto contenders = coreContenders(passage);
  for (Contender& contender : fclContenders(passage)) contenders.push_back(std::move(contender));
  const std::string job = fixed_vertices == moving_vertices ? "paper" : "grid";
  const std::size_t positions = passage->poses.size();
  return {job, name(kind), trajectory, fixed_vertices, moving_vertices, positions, 1, std::move(contenders)};
}

/// By default every kind on the diagonal, thinned out, and the whole grid of Figure 12 for contours on the circle.
bool planned(Kind kind, const std::string& trajectory, std::size_t fixed, std::size_t moving, bool full) {
  if (full || (kind == Kind::Contour && trajectory == "circular")) return true;
  return fixed == moving && (fixed == 8 || fixed == 64 || fixed == 512);
}

std::vector<Plan> plans(std::shared_ptr<const Countries> countries, bool full) {
  std::vector<Plan> result;
  std::vector<std::string> movers = {"Italy", "Norway"};
  if (full) movers.insert(movers.end(), {"Indonesia", "Chile", "Australia"});
  for (const std::string& mover : movers) {
    for (const char* trajectory : {"circular", "linear"}) {
      result.push_back({mover + ", " + trajectory, [=] { return drive(countries, mover, trajectory); }});
    }
  }
  for (const Kind kind : workloads::allKinds()) {
    for (const char* trajectory : {"circular", "linear"}) {
      for (std::size_t fixed = 8; fixed <= 1024; fixed *= 2) {
        for (std::size_t moving = 8; moving <= 1024; moving *= 2) {
          if (!planned(kind, trajectory, fixed, moving, full)) continue;
          const std::string title =
              name(kind) + ", " + trajectory + ", " + std::to_string(fixed) + " x " + std::to_string(moving);
          result.push_back({title, [=] { return paperWorkload(kind, trajectory, fixed, moving); }});
        }
      }
    }
  }
  return result;
}

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
                   result.workload.scene.c_str(), result.workload.trajectory.c_str());
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

  const Settings settings = full ? Settings{5, 0.05} : Settings{};
  const auto all = plans(countries, full);
  std::vector<Result> results;
  for (const Plan& plan : all) {
    showProgress(results.size(), all.size(), plan.title);
    results.push_back(measure(plan.make(), settings));
  }
  showProgress(all.size(), all.size(), "done");

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
