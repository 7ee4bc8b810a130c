// SPDX-License-Identifier: BSD-3-Clause
#include "measure.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>

namespace tricover::bench {
namespace {

/// Keeps each repetition's CPU seconds per iteration, by benchmark name.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      seconds_[run.run_name.function_name].push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
    }
  }
  double median(const std::string& name) {
    std::vector<double>& seconds = seconds_.at(name);
    std::sort(seconds.begin(), seconds.end());
    const std::size_t n = seconds.size();
    return n % 2 ? seconds[n / 2] : (seconds[n / 2 - 1] + seconds[n / 2]) / 2;
  }

 private:
  std::map<std::string, std::vector<double>> seconds_;
};

std::size_t walkedPositions(const Workload& workload, std::size_t stride) {
  return (workload.positions + stride - 1) / stride;
}

/// The stride at which a walk takes about as long as a repetition should.
std::size_t chooseStride(const Workload& workload, const Contender& contender, const Settings& settings) {
  if (contender.coherent) return 1;
  const std::size_t probe = std::max<std::size_t>(workload.positions / 50, 1);
  Hits hits;
  const auto start = std::chrono::steady_clock::now();
  contender.walk(probe, hits);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const double whole = taken.count() * static_cast<double>(probe);
  const double stride = std::clamp(whole / settings.seconds_per_repetition, 1.0, static_cast<double>(probe));
  return static_cast<std::size_t>(stride);
}

/// Positions, each once, that have a hit in `hits` which `others` lacks. Both sorted.
std::size_t positionsOnlyIn(const Hits& hits, const Hits& others, std::size_t targets) {
  Hits extra;
  std::set_difference(hits.begin(), hits.end(), others.begin(), others.end(), std::back_inserter(extra));
  for (std::uint32_t& hit : extra) hit /= static_cast<std::uint32_t>(targets);
  return static_cast<std::size_t>(std::unique(extra.begin(), extra.end()) - extra.begin());
}

Hits every(std::size_t stride, const Hits& hits, std::size_t targets) {
  Hits kept;
  std::copy_if(hits.begin(), hits.end(), std::back_inserter(kept),
               [&](std::uint32_t hit) { return hit / targets % stride == 0; });
  return kept;
}

}  // namespace

Result measure(const Workload& workload, const Settings& settings) {
  Result result{workload, 0, {}};
  result.workload.contenders.clear();
  Hits reference;
  workload.contenders.front().walk(1, reference);
  std::sort(reference.begin(), reference.end());
  result.collisions = positionsOnlyIn(reference, {}, workload.targets);

  benchmark::ClearRegisteredBenchmarks();
  for (const Contender& contender : workload.contenders) {
    const std::size_t stride = chooseStride(workload, contender, settings);
    const std::size_t walked = walkedPositions(workload, stride);
    result.timings.push_back({contender.name, contender.role, 0, contender.role == Role::Floor ? 0 : walked, 0, 0});
    const auto time = [&, stride, index = result.timings.size() - 1](benchmark::State& state) {
      Hits hits;
      for (auto _ : state) {
        hits.clear();
        contender.walk(stride, hits);
      }
      if (contender.role == Role::Floor) return;
      std::sort(hits.begin(), hits.end());
      const Hits expected = every(stride, reference, workload.targets);
      Timing& timing = result.timings[index];
      timing.false_alarms = std::max(timing.false_alarms, positionsOnlyIn(hits, expected, workload.targets));
      timing.misses = std::max(timing.misses, positionsOnlyIn(expected, hits, workload.targets));
    };
    benchmark::RegisterBenchmark(contender.name.c_str(), time)
        ->Repetitions(settings.repetitions)
        ->MinTime(settings.seconds_per_repetition);
    // The walk's own length, to turn its time into time per query.
    result.timings.back().ns = 1e9 / static_cast<double>(walked);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  for (Timing& timing : result.timings) timing.ns *= collector.median(timing.name);
  return result;
}

}  // namespace tricover::bench
