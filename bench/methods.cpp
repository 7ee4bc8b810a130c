// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include <memory>
#include <utility>

#include "core.h"
#include "plain_core.h"
#include "rivals/boost_geometry.h"
#include "rivals/box2d.h"
#include "rivals/empty_function.h"
#include "rivals/fcl_bvh.h"
#include "rivals/fcl_call.h"
#include "rivals/fcl_convex.h"
#include "rivals/geos.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
Methods::Methods(const Polygon& fixed, const Polygon& moving) {
  const auto always = [](const Choice&) { return true; };
  const auto coherent = [](const Choice& choice) { return choice.coherent; };
  const auto paper = [](const Choice& choice) { return choice.paper; };
  const auto add = [&](const char* name, Role role, bool lives_on_steps, auto method, auto wanted) {
    makers_.push_back([=](const std::vector<Pose>& poses, const Choice& choice, std::vector<Contender>& to) {
      if (!wanted(choice)) return;
      method->prepare(poses);
      to.push_back(contender(name, role, lives_on_steps, method, poses.size()));
    });
  };
  add("cold", Role::Ours, false, std::make_shared<Core>(fixed, moving), always);
  add("cached", Role::Ours, true, std::make_shared<CachedCore>(fixed, moving), coherent);
  add("paper", Role::Ours, true, std::make_shared<PaperCore>(fixed, moving), paper);
  add("via FCL", Role::Ours, true,
      std::make_shared<FclCall>(std::make_shared<tricover_fcl::PolygonShaped>(fixed),
                                std::make_shared<tricover_fcl::PolygonShaped>(moving)),
      always);
  add("empty", Role::Floor, false, std::make_shared<FclCall>(emptyGeometry(), emptyGeometry()), always);
  makers_.push_back([walk = tricover_plain_double::plainWalk(fixed.rings(), moving.rings())](
                        const std::vector<Pose>& poses, const Choice& choice, std::vector<Contender>& to) {
    if (!choice.plain) return;
    to.push_back({"plain signs", Role::Inexact, false, [&, walk](const Sampling& sampling, Hits& hits) {
                    walk(poses.data(), poses.size(), sampling.period, sampling.run, hits);
                  }});
  });
  add("FCL MPR", Role::Rival, false, std::make_shared<FclMpr>(fixed, moving), always);
  add("FCL GJK", Role::Rival, false, std::make_shared<FclGjk>(fixed, moving, false), always);
  add("FCL GJK guess", Role::Rival, true, std::make_shared<FclGjk>(fixed, moving, true), coherent);
  add("FCL BVH", Role::Rival, false, std::make_shared<FclBvh>(fixed, moving), always);
  add("GEOS", Role::Rival, false, std::make_shared<Geos>(fixed, moving), always);
  add("Boost", Role::Rival, false, std::make_shared<BoostGeometry>(fixed, moving), always);
  if (box2dTakes(fixed) && box2dTakes(moving)) {
    add("Box2D overlap", Role::Box2d, false, std::make_shared<Box2dOverlap>(fixed, moving), always);
    add("Box2D manifold", Role::Box2d, false, std::make_shared<Box2dManifold>(fixed, moving), always);
  }
}

std::vector<Contender> Methods::on(const std::vector<Pose>& poses, const Choice& choice) {
  std::vector<Contender> contenders;
  for (const Make& make : makers_) make(poses, choice, contenders);
  return contenders;
}

}  // namespace tricover::bench
