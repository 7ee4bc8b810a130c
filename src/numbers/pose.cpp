// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/pose.h"

#include <cmath>
#include <string>

#include "numbers/errors.h"
#include "numbers/rigidity.h"

namespace tricover {

void checkPose(const Pose& pose, const char* name) {
  const auto& m = pose.matrix();
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column) {
      if (std::isfinite(m(row, column))) continue;
      const std::string place = std::to_string(row);
      detail::refuse(name, column == 2 ? "translation(" + place + ") is not finite"
                                       : "linear(" + place + ", " + std::to_string(column) + ") is not finite");
    }
  const double* columns = pose.data();  // of three
  const detail::Gram gram(detail::load2(columns), detail::load2(columns + 3));
  // Negated, so that NaN, of entries whose squares overflow, fails.
  if (!(gram.norms[0] <= kRigidTolerance && gram.norms[1] <= kRigidTolerance && gram.dot <= kRigidTolerance))
    detail::refuse(name, "linear() is not rigid within 1e-6",
                   "a pose only turns, mirrors and moves: scale the polygon's vertices");
}

}  // namespace tricover
