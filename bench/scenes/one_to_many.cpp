// SPDX-License-Identifier: BSD-3-Clause
#include "one_to_many.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "askers.h"
#include "layout.h"
#include "maps.h"
#include "rivals/boost_tree.h"
#include "rivals/geos_tree.h"

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

/// All that answers some questions, made ready once for all poses. Where `full`, with all of FCL's managers.
class Askers {
 public:
  Askers(const Questions& questions, bool full) {
    add("cold", Role::Ours, std::make_shared<InTurn<ScanAsker>>(questions));
    add("scene", Role::Ours, std::make_shared<InTurn<SceneAsker>>(questions));
    add(kCached, Role::Ours, std::make_shared<InTurn<CachedSceneAsker>>(questions));
    for (const std::string& manager : fclManagers()) {
      const bool first = manager == fclManagers().front();
      if (!full && !first) continue;
      add(first ? "via FCL" : "via FCL, " + manager, Role::Ours,
          std::make_shared<InTurn<FclAsker>>(questions, manager));
    }
    add("GEOS STRtree", Role::Rival, std::make_shared<InTurn<GeosTree>>(questions));
    add("Boost rtree", Role::Rival, std::make_shared<InTurn<BoostTree>>(questions));
  }

  Result measureOn(Workload workload, const PosesOfEach& poses, bool coherent, const Settings& settings) const {
    workload.positions = poses.size() * poses.front().size();
    workload.targets = 1;
    std::vector<Contender> contenders;
    for (const Method& method : methods_) {
      if (method.name == kCached && !coherent) continue;
      method.prepare(poses);
      contenders.push_back(method.contender(workload.positions));
    }
    return measure(workload, contenders, settings);
  }

 private:
  static constexpr const char* kCached = "scene, cached";

  struct Method {
    std::string name;
    std::function<void(const PosesOfEach& poses)> prepare;
    std::function<Contender(std::size_t positions)> contender;
  };

  template <class Asker>
  void add(const std::string& name, Role role, std::shared_ptr<Asker> asker) {
    methods_.push_back(
        {name, [=](const PosesOfEach& poses) { asker->prepare(poses); },
         [=](std::size_t positions) { return bench::contender<Hits>(name, role, name == kCached, asker, positions); }});
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

std::vector<Result> measureLayouts(const Settings& settings, bool full) {
  constexpr std::size_t kParts = 80;
  const std::pair<int, int> classes[] = {{5, 8}, {12, 20}, {40, 64}, {120, 200}};
  const std::pair<Placing, const char*> ways[] = {
      {Placing::Free, "free"}, {Placing::Local, "local"}, {Placing::Uniform, "uniform"}};
  std::vector<Result> results;
  for (const auto& [least, most] : classes) {
    const Placement layout = makeLayout(kParts, least, most, 7);
    const Questions questions = questionsAbout(layout);
    const Askers askers(questions, full);
    const std::string scene = std::to_string(least) + " to " + std::to_string(most) + " vertices";
    for (const auto& [placing, name] : ways) {
      const Workload workload{"layout", scene, name, vertexCount(layout), static_cast<std::size_t>(most), 0, 0};
      results.push_back(
          askers.measureOn(workload, placingsOfEach(layout, questions, placing), /*coherent*/ false, settings));
    }
  }
  return results;
}

std::vector<Result> measureMaps(const Countries& countries, const Settings& settings, bool full) {
  constexpr std::size_t kPoses = 10000;
  const Polygon robot = forkLift();
  std::vector<Result> results;
  for (const NamedMap& map : allMaps(countries)) {
    const Placement& bodies = map.bodies;
    const Askers askers({{bodies, robot}}, full);
    const auto measureOn = [&](const char* way, std::vector<Pose> poses, bool coherent) {
      const Workload workload{"map", map.name, way, vertexCount(bodies), robot.vertexCount(), 0, 0};
      results.push_back(askers.measureOn(workload, {std::move(poses)}, coherent, settings));
    };
    measureOn("random poses", randomPoses(bodies, kPoses, 3), false);
    measureOn("a planner's path", plannerPath(bodies, robot, kPoses, 4), true);
  }
  return results;
}

}  // namespace tricover::bench
