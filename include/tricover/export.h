// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a shared library of tricover's offers: all that carries this, and nothing else. The kernel (namespace detail)
/// is no part of the binary interface.
#if defined(__GNUC__)
#define TRICOVER_EXPORT __attribute__((visibility("default")))
#else
#define TRICOVER_EXPORT
#endif
