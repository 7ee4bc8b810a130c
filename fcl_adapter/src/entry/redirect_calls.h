// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tricover_fcl {

/// Where libfcl comes before tricover in the search order, as in a host that links libfcl and opens a plugin by dlopen,
/// calls of the functions that replaced_*.cpp replace were bound to libfcl's copies. This binds them to ours, in every
/// object that is loaded: by writing into the slots of the linker's tables that say where calls go (x86-64 and
/// AArch64 Linux; elsewhere it does nothing). Call it again when objects may have been loaded since: that costs nothing
/// where tricover came first, and a comparison where nothing was loaded.
void redirectCalls();

}  // namespace tricover_fcl
