// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "measure.h"
#include "report.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"

/// The matrix of polygons, poses and methods that most studies are.
namespace tricover::bench {

/// The traits of a workload, and those that a method needs.
enum Trait : unsigned {
  kAny = 0,
  kSmallSteps = 1,  ///< also methods that live on them
  kPaper = 2,       ///< also the paper's Algorithm 3, which is slow
  kPlain = 4,       ///< also the core with plain double signs
  kSliding = 8      ///< motions that don't turn: also methods that know no others
};
unsigned traitsOf(const Workload& workload);

/// The methods that are timed on one pair of polygons, derived once for all workloads of theirs: tricover without
/// coherence first. The fixed polygon stays at the identity.
template <class Answers, class Input = Pose>
class MethodTable {
 public:
  using Make = std::function<ContenderFor<Answers>(const std::vector<Input>& inputs)>;

  /// A row: a `Method` of these arguments, which has prepare(inputs), and collide(i) or value(i).
  template <class Method, class... Arguments>
  std::shared_ptr<Method> add(std::string name, Role role, bool coherent, unsigned needs, Arguments&&... arguments) {
    const auto method = std::make_shared<Method>(std::forward<Arguments>(arguments)...);
    addMade(needs, [=](const std::vector<Input>& inputs) {
      method->prepare(inputs);
      return contenderOf<Answers>(name, role, coherent, inputs.size(), method);
    });
    return method;
  }
  void addMade(unsigned needs, Make make) { rows_.emplace_back(needs, std::move(make)); }

  /// The contenders on these inputs, which must outlive them. Those of an earlier call are invalid.
  std::vector<ContenderFor<Answers>> on(const std::vector<Input>& inputs, unsigned traits = kAny) const {
    std::vector<ContenderFor<Answers>> contenders;
    for (const auto& [needs, make] : rows_)
      if ((needs & ~traits) == 0) contenders.push_back(make(inputs));
    return contenders;
  }

  /// How many positions of the last inputs FCL's first box or support tells.
  std::function<std::size_t()> decided_at_once = [] { return std::size_t{0}; };

 private:
  std::vector<std::pair<unsigned, Make>> rows_;
};

/// A kind of polygons.
struct Shape {
  std::string name;
  std::function<Polygon(std::size_t vertices, std::uint64_t seed)> make;
};

/// Two polygons of a kind, and the workloads that they are asked on.
struct Cell {
  Shape shape;
  std::size_t vertices_fixed, vertices_moving;
  std::vector<std::string> workloads;
};

/// Times `methods(fixed, moving)`, a table, on `inputs(workload, fixed, moving)` in every cell.
template <class Methods, class Inputs>
std::vector<Result> measureAll(const std::string& job, const std::vector<Cell>& cells, Methods methods, Inputs inputs,
                               const Settings& settings) {
  std::vector<Result> results;
  std::size_t done = 0;
  for (const Cell& cell : cells) {
    const Polygon fixed = cell.shape.make(cell.vertices_fixed, 1), moving = cell.shape.make(cell.vertices_moving, 2);
    const auto table = methods(fixed, moving);
    showProgress(++done, cells.size(), job + ", " + cell.shape.name);
    for (const std::string& name : cell.workloads) {
      const auto all = inputs(name, fixed, moving);
      const Workload workload{job, cell.shape.name, name, fixed.vertexCount(), moving.vertexCount(), all.size(), 1};
      results.push_back(measure(workload, table.on(all, traitsOf(workload)), settings));
      results.back().decided_at_once = table.decided_at_once();
    }
  }
  return results;
}

}  // namespace tricover::bench
