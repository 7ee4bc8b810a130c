// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "tricover/polygon.h"

namespace tricover::bench {

/// The hits of a walk over the positions: position * targets + target for every hit.
using Hits = std::vector<std::uint32_t>;

/// One for each position that a walk visited: a distance, or a time of impact.
using Values = std::vector<double>;

/// Which positions a walk visits: `run` consecutive ones out of every `period`, from `first` on.
struct Sampling {
  std::size_t period = 1, run = 1, first = 0;
  bool holds(std::size_t position) const { return position % period < run; }
};

/// Calls visit(position) for each position that the sampling holds, in order.
template <class Visit>
void forEachSample(const Sampling& sampling, std::size_t positions, Visit visit) {
  for (std::size_t begin = sampling.first; begin < positions; begin += sampling.period) {
    const std::size_t end = std::min(begin + sampling.run, positions);
    for (std::size_t position = begin; position < end; ++position) visit(position);
  }
}

enum class Role {
  Ours,    ///< must agree with the reference on every answer
  Rival,   ///< its disagreements are counted and shown
  Box2d,   ///< a rival for convex polygons of 8 vertices, in floats: it has rows of its own
  Floor,   ///< answers nothing: what the call alone costs
  Inexact  ///< tricover without its filter and exact stage, on the reference's positions: what exactness costs
};

/// One way of answering a workload's queries.
template <class Answers>
struct ContenderFor {
  std::string name;
  Role role;
  bool coherent;  ///< lives on small steps, so that its samples must be long runs
  /// Asks for the sampled positions in order and appends the answers.
  std::function<void(const Sampling& sampling, Answers& answers)> walk;
};
using Contender = ContenderFor<Hits>;
using ValueContender = ContenderFor<Values>;

/// `ask(i)` answers the position with index i: whether there is a hit, or a value.
template <class Answers, class Ask>
ContenderFor<Answers> contender(std::string name, Role role, bool coherent, std::size_t positions, Ask ask) {
  return {std::move(name), role, coherent, [=](const Sampling& sampling, Answers& answers) {
            forEachSample(sampling, positions, [&](std::size_t i) {
              if constexpr (std::is_same_v<Answers, Values>) {
                answers.push_back(ask(i));
              } else if (ask(i)) {
                answers.push_back(static_cast<std::uint32_t>(i));
              }
            });
          }};
}

/// By `method`'s value(i) or collide(i).
template <class Answers, class Method>
ContenderFor<Answers> contenderOf(std::string name, Role role, bool coherent, std::size_t positions,
                                  std::shared_ptr<Method> method) {
  return contender<Answers>(std::move(name), role, coherent, positions, [=](std::size_t i) {
    if constexpr (std::is_same_v<Answers, Values>)
      return method->value(i);
    else
      return method->collide(i);
  });
}

/// How much values may differ from the reference's.
struct Tolerance {
  double below, above;
};

struct Agreement {
  double hit = 0;  ///< values up to this one are collisions
  Tolerance ours = {0, 0}, rivals = {0, 0};
};

struct Workload {
  std::string job;    ///< the table it belongs to
  std::string scene;  ///< kind of polygons, or who moves among whom
  std::string name;   ///< "circular", "contact" and so on
  std::size_t vertices_fixed = 0, vertices_moving = 0;
  std::size_t positions = 1;  ///< a query is one position: the moving polygon against all targets
  std::size_t targets = 1;
};

struct Timing {
  std::string name;
  Role role;
  double ns;                ///< per query, median over the repetitions, CPU time
  std::size_t checked = 0;  ///< queries whose answer was compared
  /// Queries with a hit too many or one too few; with a value too low or too high.
  std::size_t false_alarms = 0, misses = 0;
};

struct Result {
  Workload workload;
  std::vector<Timing> timings = {};
  std::size_t collisions = 0;
  std::size_t decided_at_once = 0;  ///< positions that FCL's first box or support tells
};

/// "scene vertices, workload".
std::string cellName(const Workload& workload);

struct Settings {
  int repetitions = 5;
  double seconds_per_repetition = 0.002;  ///< about; a walk that would take longer is sampled
  Agreement agreement = {};               ///< of values
};

/// CPU time of this thread, and wall time.
double threadSeconds();
double wallSeconds();

/// The mean of the middle two where their number is even.
double medianOf(std::vector<double> values);

/// The heap in use.
std::size_t heapBytes();

/// One of several methods that answer all of a workload's queries, each in one call.
struct Task {
  std::string name;
  Role role;
  std::function<void()> run;
};

/// Answers each of so many queries by ask(i), and leaves the answers there.
template <class Ask>
Task taskOf(std::string name, Role role, std::vector<double>& answers, Ask ask) {
  return {std::move(name), role, [&answers, ask]() mutable {
            for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = static_cast<double>(ask(i));
          }};
}

/// Runs all tasks in turn, `rounds` times: the median of each, in ns of CPU time per position of the workload.
Result measureInTurn(const Workload& workload, const std::vector<Task>& tasks, int rounds);

/// Times the contenders by Google Benchmark, interleaved at random in this process, and checks all that they answered
/// while being timed. The first contender is tricover without coherence: the reference.
Result measure(const Workload& workload, const std::vector<Contender>& contenders, const Settings& settings);
Result measure(const Workload& workload, const std::vector<ValueContender>& contenders, const Settings& settings);

}  // namespace tricover::bench
