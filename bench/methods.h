// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "measure.h"
#include "tricover/pose.h"

namespace tricover::bench {

/// What a workload is like.
struct Choice {
  bool coherent = false;  ///< small steps: also methods that live on them
  bool paper = false;     ///< also the paper's Algorithm 3, which is slow
  bool plain = false;     ///< also the core with plain double signs
  bool sliding = false;   ///< motions that don't turn: also methods that know no others
};

inline bool always(const Choice&) { return true; }
inline bool onSmallSteps(const Choice& choice) { return choice.coherent; }
inline bool withoutTurns(const Choice& choice) { return choice.sliding; }

/// The methods that are timed on one pair of polygons, derived once for all workloads of theirs: tricover without
/// coherence first. The fixed polygon stays at the identity.
template <class Answers, class Input = Pose>
class MethodTable {
 public:
  using Wanted = bool (*)(const Choice& choice);
  using Make = std::function<ContenderFor<Answers>(const std::vector<Input>& inputs)>;

  /// A row: `method` has prepare(inputs), and collide(i) or value(i).
  template <class Method>
  void add(std::string name, Role role, bool lives_on_steps, std::shared_ptr<Method> method, Wanted wanted = always) {
    const auto make = [=](const std::vector<Input>& inputs) {
      method->prepare(inputs);
      return contender<Answers>(name, role, lives_on_steps, method, inputs.size());
    };
    addMade(make, wanted);
  }
  void addMade(Make make, Wanted wanted) { rows_.push_back({std::move(make), wanted}); }

  /// The contenders on these inputs, which must outlive them. Those of an earlier call are invalid.
  std::vector<ContenderFor<Answers>> on(const std::vector<Input>& inputs, const Choice& choice = {}) const {
    std::vector<ContenderFor<Answers>> contenders;
    for (const Row& row : rows_)
      if (row.wanted(choice)) contenders.push_back(row.make(inputs));
    return contenders;
  }

 private:
  struct Row {
    Make make;
    Wanted wanted;
  };
  std::vector<Row> rows_;
};

}  // namespace tricover::bench
