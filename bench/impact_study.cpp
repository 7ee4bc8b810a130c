// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>
#include <utility>

#include "methods.h"
#include "random.h"
#include "rivals/box2d.h"
#include "rivals/fcl_advancement.h"
#include "studies.h"
#include "tricover/time_of_impact.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

/// FCL's advancement stops short of contact where it comes slowly; that isn't counted as wrong below a thousandth.
constexpr Agreement kAgreement = {1, {kTimeError, kTimeError}, {1e-3, 2 * kTimeError}};

class Core {
 public:
  Core(Polygon fixed, Polygon moving) : fixed_(std::move(fixed)), moving_(std::move(moving)) {}
  void prepare(const std::vector<Motion>& motions) { motions_ = motions.data(); }
  double value(std::size_t i) {
    const auto impact = timeOfImpact(fixed_, still_, moving_, motions_[i], {0, kTimeError});
    return impact ? impact->time : kNever;
  }

 private:
  Polygon fixed_, moving_;
  Motion still_;
  const Motion* motions_ = nullptr;
};

std::vector<Motion> randomMotions(const Polygon& fixed, const Polygon& moving, bool turning) {
  support::Random random(3);
  const double radius = (fixed.radius() + moving.radius()) / 2;
  std::vector<Motion> motions;
  for (const Pose& near : separatedPoses(fixed, moving, 1.03, 1.5)) {
    Motion motion;
    motion.start = near;
    const Vec2 inwards = (fixed.origin() - near * moving.origin()).normalized();
    motion.shift = radius * random.real(0.5, 2) * (Eigen::Rotation2Dd(random.real(-1.2, 1.2)) * inwards);
    motion.pivot = moving.origin();
    if (turning) motion.angle = random.real(-2.6, 2.6);
    motions.push_back(motion);
  }
  return motions;
}

}  // namespace

std::vector<Cell> impactCells(bool full) {
  std::vector<std::pair<std::size_t, std::size_t>> sizes = {{8, 8}, {64, 64}};
  if (full) sizes.insert(sizes.end(), {{16, 16}, {256, 256}, {1024, 1024}});
  std::vector<Cell> cells;
  for (const workloads::Kind kind : workloads::allKinds()) {
    for (const auto& [fixed, moving] : sizes) cells.push_back({kind, fixed, moving, {"sliding", "turning"}});
    if (full || kind == workloads::Kind::Contour) cells.push_back({kind, 512, 16, {"sliding", "turning"}});
  }
  return cells;
}

std::vector<Result> measureImpacts(const Cell& cell, const Settings& settings) {
  const auto [fixed, moving] = polygonsOf(cell);
  const auto shape = [](const Polygon& polygon) { return std::make_shared<tricover_fcl::PolygonShaped>(polygon); };
  const std::vector<Triangle> fixed_triangles = triangulate(fixed), moving_triangles = triangulate(moving);
  MethodTable<Values, Motion> table;
  table.add("cold", Role::Ours, false, std::make_shared<Core>(fixed, moving));
  table.add("via FCL", Role::Ours, false, std::make_shared<FclAdvancement>(shape(fixed), shape(moving)));
  table.add("FCL RSS", Role::Rival, false,
            std::make_shared<FclAdvancement>(makeFlatMesh<fcl::RSSd>(fixed_triangles),
                                             makeFlatMesh<fcl::RSSd>(moving_triangles)));
  table.add("FCL OBBRSS", Role::Rival, false,
            std::make_shared<FclAdvancement>(makeFlatMesh(fixed_triangles), makeFlatMesh(moving_triangles)));
  if (box2dTakes(fixed) && box2dTakes(moving)) {
    table.add("Box2D", Role::Box2d, false, std::make_shared<Box2dImpact>(fixed, moving));
    table.add("Box2D cast", Role::Box2d, false, std::make_shared<Box2dCast>(fixed, moving), withoutTurns);
  }
  std::vector<Result> results;
  for (const std::string& name : cell.workloads) {
    const bool turning = name == "turning";
    const std::vector<Motion> motions = randomMotions(fixed, moving, turning);
    Choice choice;
    choice.sliding = !turning;
    const Workload workload{
        "impact", workloads::name(cell.kind), name, cell.vertices_fixed, cell.vertices_moving, motions.size(), 1};
    results.push_back(measure(workload, table.on(motions, choice), kAgreement, settings));
  }
  return results;
}

}  // namespace tricover::bench
