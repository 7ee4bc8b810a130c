// SPDX-License-Identifier: BSD-3-Clause
// Two polygons under one pose each, or many.
#pragma once

#include "python/module.h"

namespace tricover_python {

/// The answers of query(pose_a, pose_b); `each` as Count::answers() takes it. Errors call the poses by these names.
template <typename Query>
py::object ofPoses(const py::object& pose_a, const py::object& pose_b, std::size_t threads, std::size_t each,
                   const Query& query, const std::string& a_name = "pose_a", const std::string& b_name = "pose_b") {
  const Poses at_a = posesFrom(pose_a, a_name), at_b = posesFrom(pose_b, b_name);
  return Count().of(at_a, a_name.c_str()).of(at_b, b_name.c_str()).answers(threads, each, [&](std::size_t i) {
    return query(at_a[i], at_b[i]);
  });
}

}  // namespace tricover_python
