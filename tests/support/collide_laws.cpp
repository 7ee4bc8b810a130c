// SPDX-License-Identifier: BSD-3-Clause
#include "collide_laws.h"

#include "reproduction.h"
#include "stages.h"
#include "tricover/prepare.h"

namespace tricover::support {
namespace {

class Asking {
 public:
  Asking(const Case& c, const CollideOptions& options, const CollideTruth& truth)
      : c_(c), options_(options), truth_(truth) {}

  void cold(Strategy strategy, const std::string& way) {
    judge(collide(strategy, c_.a, c_.pose_a, c_.b, c_.pose_b, options_), way);
    judge(collide(strategy, c_.b, c_.pose_b, c_.a, c_.pose_a, options_), way + ", swapped");
  }
  void cached(Strategy strategy, StrategyCaches& caches, const std::string& way) {
    judge(collide(strategy, c_.a, c_.pose_a, c_.b, c_.pose_b, caches, options_), way);
    judge(collide(strategy, c_.b, c_.pose_b, c_.a, c_.pose_a, caches, options_), way + ", swapped");
  }
  const std::string& wrong() const { return wrong_; }

 private:
  void judge(bool answer, const std::string& way) {
    if (wrong_.empty() && (answer ? !truth_.may : truth_.must))
      wrong_ = "collide, " + way + ": " + std::to_string(answer) + ", margin " + hex(options_.margin) + ", tolerance " +
               hex(options_.tolerance);
  }

  const Case& c_;
  const CollideOptions& options_;
  const CollideTruth& truth_;
  std::string wrong_;
};

}  // namespace

std::string wrongCollide(const Case& c, const CollideOptions& options, const CollideTruth& truth, StrategyCaches& old,
                         Random& random) {
  const Case new_one{afresh(c.a), c.pose_a, afresh(c.b), c.pose_b};
  Asking asking(new_one, options, truth);
  for (const auto stages : {detail::Stages::Edges, detail::Stages::Hierarchy, detail::Stages::All}) {
    const UpTo these(stages);
    const std::string name = "up to stage " + std::to_string(static_cast<int>(stages));
    StrategyCaches fresh;
    asking.cold(Strategy::Hierarchy, name);
    asking.cached(Strategy::Hierarchy, fresh, name + ", with a cache");
  }
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const std::string name = nameOf(strategy);
    asking.cold(strategy, name);
    asking.cached(strategy, old, name + ", cache of other pairs");
    StrategyCaches fresh;
    for (int i = 0; i < 3; ++i)
      collide(strategy, new_one.a, c.pose_a, new_one.b, elsewhere(random, c), fresh,
              random.coin() ? options : CollideOptions());
    asking.cached(strategy, fresh, name + ", cache of other poses");
  }
  // With the discs of those that don't meet, too.
  prepare(new_one.a), prepare(new_one.b);
  asking.cold(Strategy::Hierarchy, "prepared");
  return asking.wrong();
}

}  // namespace tricover::support
