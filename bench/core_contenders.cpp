// SPDX-License-Identifier: BSD-3-Clause
#include "contenders.h"
#include "tricover/collide.h"

namespace tricover::bench {

std::vector<Contender> coreContenders(std::shared_ptr<const Passage> passage) {
  const auto contender = [&](const std::string& name, bool coherent, Strategy strategy) {
    CollideOptions options;
    options.strategy = strategy;
    return Contender{name, Role::Ours, coherent, [=](const Sampling& sampling, Hits& hits) {
                       const Polygon &fixed = passage->fixed, &moving = passage->moving;
                       const std::vector<Pose>& poses = passage->poses;
                       const Pose identity = Pose::Identity();
                       PairCache cache;
                       forEachSample(sampling, poses.size(), [&](std::size_t i) {
                         const bool hit = coherent ? collide(fixed, identity, moving, poses[i], cache, options)
                                                   : collide(fixed, identity, moving, poses[i], options);
                         if (hit) hits.push_back(static_cast<std::uint32_t>(i));
                       });
                     }};
  };
  return {contender("cold", false, Strategy::Hierarchy), contender("cached", true, Strategy::Hierarchy),
          contender("paper", true, Strategy::Paper)};
}

}  // namespace tricover::bench
