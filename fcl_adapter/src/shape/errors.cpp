// SPDX-License-Identifier: BSD-3-Clause
#include "shape/errors.h"

#include <stdexcept>

#if __has_include(<cxxabi.h>)
#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#endif

namespace tricover_fcl {

void refuseQuestion(const std::string& field, const std::string& wrong, const std::string& instead) {
  throw std::logic_error(tricover::detail::refusal(field, wrong, instead));
}

std::string className(const std::type_info& type) {
#if __has_include(<cxxabi.h>)
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(abi::__cxa_demangle(type.name(), nullptr, nullptr, &status),
                                                    std::free);
  if (status == 0) return name.get();
#endif
  return type.name();
}

}  // namespace tricover_fcl
