// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/pose.h"

#include <stdexcept>
#include <string>

#include "numbers/rigidity.h"

namespace tricover {

void checkPose(const Pose& pose, const char* name) {
  const double* m = pose.data();  // columns of three
  const detail::Gram gram(detail::load2(m), detail::load2(m + 3));
  // Negated, so that NaN fails.
  if (!(gram.norms[0] <= kRigidTolerance && gram.norms[1] <= kRigidTolerance && gram.dot <= kRigidTolerance))
    throw std::invalid_argument(std::string(name) + ": its linear part is not rigid within 1e-6");
  if (!pose.translation().allFinite())
    throw std::invalid_argument(std::string(name) + ": its translation is not finite");
}

}  // namespace tricover
