// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/// The core compiled once more, in a namespace of its own and with TRICOVER_PLAIN_SIGNS: no filter and no exact stage.
/// Standard types only, because tricover's own are others there.
using PlainRings = std::vector<std::vector<Eigen::Vector2d>>;

/// Appends to `hits` those of the poses with indices below `positions`, of which it asks the first `run` in every
/// `period` from `first` on, at which the moving polygon collides with the fixed one.
using PlainWalk = std::function<void(const Eigen::Isometry2d* poses, std::size_t positions, std::size_t period,
                                     std::size_t run, std::size_t first, std::vector<std::uint32_t>& hits)>;

namespace tricover_plain_double {
PlainWalk plainWalk(const PlainRings& fixed, const PlainRings& moving,
                    const Eigen::Isometry2d& fixed_pose = Eigen::Isometry2d::Identity());
}
namespace tricover_plain_float {
PlainWalk plainWalk(const PlainRings& fixed, const PlainRings& moving,
                    const Eigen::Isometry2d& fixed_pose = Eigen::Isometry2d::Identity());
}
