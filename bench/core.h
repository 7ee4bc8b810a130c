// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/paper.h"

namespace tricover::bench {

/// tricover's core as its users call it, the fixed polygon at the identity.
class Core {
 public:
  Core(Polygon fixed, Polygon moving) : fixed_(std::move(fixed)), moving_(std::move(moving)) {}
  void prepare(const std::vector<Pose>& poses) { poses_ = poses.data(); }
  bool collide(std::size_t i) { return tricover::collide(fixed_, identity_, moving_, poses_[i]); }
  double value(std::size_t i) { return distance(fixed_, identity_, moving_, poses_[i]).distance; }

 protected:
  Polygon fixed_, moving_;
  Pose identity_ = Pose::Identity();
  const Pose* poses_ = nullptr;
};

/// With caches.
class CachedCore : public Core {
 public:
  using Core::Core;
  bool collide(std::size_t i) { return tricover::collide(fixed_, identity_, moving_, poses_[i], cache_); }
  double value(std::size_t i) { return distance(fixed_, identity_, moving_, poses_[i], cache_).distance; }

 private:
  PairCache cache_;
};

/// The paper's Algorithm 3.
class PaperCore : public Core {
 public:
  using Core::Core;
  bool collide(std::size_t i) { return paper::collide(fixed_, identity_, moving_, poses_[i], cache_); }

 private:
  paper::MaskCache cache_;
};

}  // namespace tricover::bench
