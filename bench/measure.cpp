// SPDX-License-Identifier: BSD-3-Clause
#include "measure.h"

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <map>
#include <string>

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
  double median(const std::string& name) { return medianOf(seconds_.at(name)); }

 private:
  std::map<std::string, std::vector<double>> seconds_;
};

std::size_t sampleCount(const Workload& workload, const Sampling& sampling) {
  const std::size_t last = workload.positions % sampling.period;
  return workload.positions / sampling.period * sampling.run + std::min(last, sampling.run);
}

/// A sampling whose walk takes about as long as a repetition should, but has at least 50 queries, or 10 runs.
template <class Answers>
Sampling chooseSampling(const Workload& workload, const ContenderFor<Answers>& contender, const Settings& settings) {
  // The first query of a run has nothing to be coherent with.
  const std::size_t run = contender.coherent ? 100 : 1;
  const Sampling sparse{std::max(workload.positions / (contender.coherent ? 10 : 50), run), run};
  Answers answers;
  const auto start = std::chrono::steady_clock::now();
  contender.walk(sparse, answers);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const double affordable = settings.seconds_per_repetition / taken.count();  // sparse walks
  if (affordable * static_cast<double>(run) >= static_cast<double>(sparse.period)) return {};
  const double period = static_cast<double>(sparse.period) / std::max(affordable, 1.0);
  return {static_cast<std::size_t>(std::max(period, static_cast<double>(run))), run};
}

/// Positions, each once, that have a hit in `hits` which `others` lacks. Both sorted.
std::size_t positionsOnlyIn(const Hits& hits, const Hits& others, std::size_t targets) {
  Hits extra;
  std::set_difference(hits.begin(), hits.end(), others.begin(), others.end(), std::back_inserter(extra));
  for (std::uint32_t& hit : extra) hit /= static_cast<std::uint32_t>(targets);
  return static_cast<std::size_t>(std::unique(extra.begin(), extra.end()) - extra.begin());
}

Hits sampled(const Sampling& sampling, const Hits& hits, std::size_t targets) {
  Hits kept;
  std::copy_if(hits.begin(), hits.end(), std::back_inserter(kept),
               [&](std::uint32_t hit) { return sampling.holds(hit / targets); });
  return kept;
}

/// Times the contenders; `check(answers, sampling, timing)` counts what is wrong with a walk's answers.
template <class Answers, class Check>
std::vector<Timing> timeAll(const Workload& workload, const std::vector<ContenderFor<Answers>>& contenders,
                            const Settings& settings, Check check) {
  std::vector<Timing> timings;
  benchmark::ClearRegisteredBenchmarks();
  Sampling of_reference;
  for (const ContenderFor<Answers>& contender : contenders) {
    // The cost of exactness is measured at the same positions: among fewer, a processor foresees more branches.
    const bool as_reference = contender.role == Role::Inexact;
    const Sampling sampling = as_reference ? of_reference : chooseSampling(workload, contender, settings);
    if (timings.empty()) of_reference = sampling;
    const std::size_t walked = sampleCount(workload, sampling);
    timings.push_back({contender.name, contender.role, 0, contender.role == Role::Floor ? 0 : walked});
    const auto time = [&, sampling, index = timings.size() - 1](benchmark::State& state) {
      Answers answers;
      for (auto _ : state) {
        answers.clear();
        contender.walk(sampling, answers);
      }
      if (contender.role != Role::Floor) check(answers, sampling, timings[index]);
    };
    benchmark::RegisterBenchmark(contender.name.c_str(), time)
        ->Repetitions(settings.repetitions)
        ->MinTime(settings.seconds_per_repetition);
    // The walk's own length, to turn its time into time per query.
    timings.back().ns = 1e9 / static_cast<double>(walked);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  for (Timing& timing : timings) timing.ns *= collector.median(timing.name);
  return timings;
}

}  // namespace

double threadSeconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wallSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

std::size_t heapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

std::string cellName(const Workload& w) {
  const std::string sizes = std::to_string(w.vertices_fixed) + " x " + std::to_string(w.vertices_moving);
  return w.scene + (w.vertices_fixed > 0 ? " " + sizes : "") + ", " + w.name;
}

Result measureInTurn(const Workload& workload, const std::vector<Task>& tasks, int rounds) {
  Result result{workload};
  std::vector<std::vector<double>> seconds(tasks.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const double start = threadSeconds();
      tasks[i].run();
      seconds[i].push_back(threadSeconds() - start);
    }
  }
  for (std::size_t i = 0; i < tasks.size(); ++i)
    result.timings.push_back(
        {tasks[i].name, tasks[i].role, 1e9 * medianOf(seconds[i]) / static_cast<double>(workload.positions)});
  return result;
}

Result measure(const Workload& workload, const std::vector<Contender>& contenders, const Settings& settings) {
  Result result{workload};
  Hits reference;
  contenders.front().walk(Sampling{}, reference);
  std::sort(reference.begin(), reference.end());
  result.collisions = positionsOnlyIn(reference, {}, workload.targets);
  result.timings = timeAll(workload, contenders, settings, [&](Hits& hits, const Sampling& sampling, Timing& timing) {
    std::sort(hits.begin(), hits.end());
    const Hits expected = sampled(sampling, reference, workload.targets);
    timing.false_alarms = std::max(timing.false_alarms, positionsOnlyIn(hits, expected, workload.targets));
    timing.misses = std::max(timing.misses, positionsOnlyIn(expected, hits, workload.targets));
  });
  return result;
}

Result measure(const Workload& workload, const std::vector<ValueContender>& contenders, const Settings& settings) {
  const Agreement& agreement = settings.agreement;
  Result result{workload};
  Values reference;
  contenders.front().walk(Sampling{}, reference);
  result.collisions = static_cast<std::size_t>(
      std::count_if(reference.begin(), reference.end(), [&](double value) { return value <= agreement.hit; }));
  result.timings =
      timeAll(workload, contenders, settings, [&](const Values& values, const Sampling& sampling, Timing& timing) {
        const Tolerance& tolerance = timing.role == Role::Ours ? agreement.ours : agreement.rivals;
        std::size_t low = 0, high = 0, next = 0;
        forEachSample(sampling, workload.positions, [&](std::size_t position) {
          const double value = values[next++], expected = reference[position];
          if (!(value >= expected - tolerance.below)) ++low;  // NaN is wrong
          if (value > expected + tolerance.above) ++high;
        });
        timing.false_alarms = std::max(timing.false_alarms, low);
        timing.misses = std::max(timing.misses, high);
      });
  return result;
}

}  // namespace tricover::bench
