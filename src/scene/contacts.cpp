// SPDX-License-Identifier: BSD-3-Clause
// The contacts of all pairs that collide.
#include <vector>

#include "scene/in_parallel.h"
#include "scene/scene_state.h"

namespace tricover {

std::vector<PairContact> Scene::contacts(ContactDetail detail, const Parallel& parallel) {
  const std::vector<BodyPair>& pairs = collisions(parallel);
  std::vector<std::vector<Contact>> answers(pairs.size());
  detail::inParallel(parallel, pairs.size(), [&](std::size_t i) {
    const auto &p = impl_->bodies[indexOf(pairs[i].first)], &q = impl_->bodies[indexOf(pairs[i].second)];
    const CollideOptions both = detail::optionsOf(p.options, q.options);
    ContactOptions options;
    options.margin = detail::marginOfBox(both.margin);
    options.detail = detail;
    options.touching = both.touching;
    answers[i] = tricover::contacts(p.polygon, p.pose, q.polygon, q.pose, options);
  });
  std::vector<PairContact> all;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const Contact& contact : answers[i]) all.push_back({pairs[i], contact});
  return all;
}

}  // namespace tricover
