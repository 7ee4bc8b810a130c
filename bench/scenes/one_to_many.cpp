// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "askers.h"
#include "layout.h"
#include "maps.h"
#include "rivals/boost_tree.h"
#include "rivals/geos_tree.h"
#include "scene_studies.h"

namespace tricover::bench {
namespace {

/// A polygon that asks, and the bodies around it.
struct Question {
  Placement bodies;
  Polygon moving;
};
using Questions = std::vector<Question>;
using PosesOfEach = std::vector<std::vector<Pose>>;  ///< by question

/// Asks the questions in turn: position i is pose i / n of question i % n.
template <class Asker>
class InTurn {
 public:
  template <class... Arguments>
  explicit InTurn(const Questions& questions, const Arguments&... arguments) {
    for (const Question& question : questions) {
      askers_.push_back(std::make_unique<Asker>(question.bodies, question.moving, arguments...));
    }
  }
  void prepare(const PosesOfEach& poses) {
    for (std::size_t k = 0; k < askers_.size(); ++k) askers_[k]->prepare(poses[k]);
  }
  bool collide(std::size_t i) { return askers_[i % askers_.size()]->collide(i / askers_.size()); }

 private:
  std::vector<std::unique_ptr<Asker>> askers_;
};

/// All that answers some questions, made ready once for all poses.
class Askers {
 public:
  explicit Askers(const Questions& questions) {
    add("cold", Role::Ours, std::make_shared<InTurn<ScanAsker>>(questions));
    add("scene", Role::Ours, std::make_shared<InTurn<SceneAsker>>(questions));
    add("via FCL", Role::Ours, std::make_shared<InTurn<FclAsker>>(questions, false));
    add("via FCL, array tree", Role::Ours, std::make_shared<InTurn<FclAsker>>(questions, true));
    add("GEOS STRtree", Role::Rival, std::make_shared<InTurn<GeosTree>>(questions));
    add("Boost rtree", Role::Rival, std::make_shared<InTurn<BoostTree>>(questions));
  }

  Result measureOn(Workload workload, const PosesOfEach& poses, const Settings& settings) const {
    workload.positions = poses.size() * poses.front().size();
    workload.targets = 1;
    std::vector<Contender> contenders;
    for (const Method& method : methods_) {
      method.prepare(poses);
      contenders.push_back(method.contender(workload.positions));
    }
    return measure(workload, contenders, settings);
  }

 private:
  struct Method {
    std::string name;
    std::function<void(const PosesOfEach& poses)> prepare;
    std::function<Contender(std::size_t positions)> contender;
  };

  template <class Asker>
  void add(const std::string& name, Role role, std::shared_ptr<Asker> asker) {
    methods_.push_back(
        {name, [=](const PosesOfEach& poses) { asker->prepare(poses); },
         [=](std::size_t positions) { return bench::contender<Hits>(name, role, false, asker, positions); }});
  }

  std::vector<Method> methods_;
};

/// Parts that are taken out of a layout, one at a time, from all over it.
std::vector<std::size_t> liftedParts(const Placement& layout) {
  constexpr std::size_t kLifted = 8;
  std::vector<std::size_t> parts;
  for (std::size_t k = 0; k < kLifted; ++k) parts.push_back(k * layout.size() / kLifted);
  return parts;
}

Questions questionsAbout(const Placement& layout) {
  Questions questions;
  for (const std::size_t part : liftedParts(layout)) {
    Placement others = layout;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(part));
    questions.push_back({std::move(others), layout[part].polygon});
  }
  return questions;
}

PosesOfEach placingsOfEach(const Placement& layout, const Questions& questions, Placing placing) {
  constexpr std::size_t kPoses = 125;
  PosesOfEach poses;
  for (const std::size_t part : liftedParts(layout)) {
    poses.push_back(placings(layout[part], questions[poses.size()].bodies, placing, kPoses, part));
  }
  return poses;
}

}  // namespace

std::vector<Result> measureLayouts(const Settings& settings) {
  constexpr std::size_t kParts = 80;
  const std::pair<int, int> classes[] = {{5, 8}, {12, 20}, {40, 64}, {120, 200}};
  const std::pair<Placing, const char*> ways[] = {
      {Placing::Free, "free"}, {Placing::Local, "local"}, {Placing::Uniform, "uniform"}};
  std::vector<Result> results;
  for (const auto& [least, most] : classes) {
    const Placement layout = makeLayout(kParts, least, most, 7);
    const Questions questions = questionsAbout(layout);
    const Askers askers(questions);
    const std::string scene = std::to_string(least) + " to " + std::to_string(most) + " vertices";
    for (const auto& [placing, name] : ways) {
      const Workload workload{"layout", scene, name, vertexCount(layout), static_cast<std::size_t>(most), 0, 0};
      results.push_back(askers.measureOn(workload, placingsOfEach(layout, questions, placing), settings));
    }
  }
  return results;
}

std::vector<Result> measureMaps(const Countries& countries, const Settings& settings) {
  constexpr std::size_t kPoses = 10000;
  const Polygon robot = forkLift();
  std::vector<Result> results;
  for (const NamedMap& map : allMaps(countries)) {
    const Placement& bodies = map.bodies;
    const Askers askers({{bodies, robot}});
    const auto measureOn = [&](const char* way, std::vector<Pose> poses) {
      const Workload workload{"map", map.name, way, vertexCount(bodies), robot.vertexCount(), 0, 0};
      results.push_back(askers.measureOn(workload, {std::move(poses)}, settings));
    };
    measureOn("random poses", randomPoses(bodies, kPoses, 3));
    measureOn("a planner's path", plannerPath(bodies, robot, kPoses, 4));
  }
  return results;
}

}  // namespace tricover::bench
