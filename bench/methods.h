// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "measure.h"
#include "tricover/polygon.h"

namespace tricover::bench {

/// Which methods a workload is for.
struct Choice {
  bool coherent = false;  ///< small steps: also those that live on them
  bool paper = false;     ///< also the paper's Algorithm 3, which is slow
  bool plain = false;     ///< also the core with plain double signs
};

/// Everything that is timed on one pair of polygons, derived once for all workloads of theirs. The fixed polygon stays
/// at the identity.
class Methods {
 public:
  Methods(const Polygon& fixed, const Polygon& moving);

  /// The contenders, tricover without coherence first, on these poses, which must outlive them. Those of an earlier
  /// call are invalid.
  std::vector<Contender> on(const std::vector<Pose>& poses, const Choice& choice);

 private:
  using Make = std::function<void(const std::vector<Pose>& poses, const Choice& choice, std::vector<Contender>& to)>;
  std::vector<Make> makers_;
};

}  // namespace tricover::bench
