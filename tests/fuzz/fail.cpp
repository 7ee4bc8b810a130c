// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <cstdlib>

#include "byte_reader.h"

namespace tricover::fuzz {

void fail(const char* what, const std::string& reproduction) {
  std::fprintf(stderr, "%s\n%s", what, reproduction.c_str());
  std::abort();
}

}  // namespace tricover::fuzz
