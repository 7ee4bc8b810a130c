// SPDX-License-Identifier: BSD-3-Clause
#include <tricover_fcl/registration.h>

#include <iostream>

int main() {
  tricover_fcl::registerNarrowphase();
  std::cout << "registered\n";
}
