// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Every header includes this one first, so that an older standard is named before what it doesn't know.
#if __cplusplus < 201703L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 201703L)
#error "tricover needs C++17: compile with -std=c++17 or later (CMake: link tricover::tricover, which says so)"
#endif

/// Marks a symbol that a shared library of tricover exports. The kernel (namespace detail) is no part of the binary
/// interface.
#if defined(__GNUC__)
#define TRICOVER_EXPORT __attribute__((visibility("default")))
#else
#define TRICOVER_EXPORT
#endif
