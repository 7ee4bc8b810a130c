// SPDX-License-Identifier: BSD-3-Clause
#include "contenders.h"
#include "tricover/collide.h"

namespace tricover::bench {

std::vector<Contender> coreContenders(std::shared_ptr<const Passage> passage) {
  const auto contender = [&](const std::string& name, bool coherent, Strategy strategy) {
    CollideOptions options;
    options.strategy = strategy;
    return Contender{name, Role::Ours, coherent, [=](std::size_t stride, Hits& hits) {
                       const auto& [fixed, moving, poses] = *passage;
                       PairCache cache;
                       for (std::size_t i = 0; i < poses.size(); i += stride) {
                         const bool hit = coherent
                                              ? collide(fixed, Pose::Identity(), moving, poses[i], cache, options)
                                              : collide(fixed, Pose::Identity(), moving, poses[i], options);
                         if (hit) hits.push_back(static_cast<std::uint32_t>(i));
                       }
                     }};
  };
  return {contender("tricover cold", false, Strategy::Hierarchy), contender("tricover cached", true, Strategy::Hierarchy),
          contender("paper cached", true, Strategy::Paper)};
}

}  // namespace tricover::bench
