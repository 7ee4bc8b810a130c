// SPDX-License-Identifier: BSD-3-Clause
#include "entry/redirect_calls.h"

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))

#include <dlfcn.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <vector>

// In replaced_collide.cpp and replaced_advancement.cpp, with FCL's tables.
namespace fcl {

#define TRICOVER_ELSEWHERE(Solver)                                                                                \
  extern template std::size_t collide(const CollisionGeometry<double>*, const Transform3<double>&,                \
                                      const CollisionGeometry<double>*, const Transform3<double>&, const Solver*, \
                                      const CollisionRequest<double>&, CollisionResult<double>&);                 \
  extern template double detail::continuousCollideConservativeAdvancement(                                        \
      const CollisionGeometry<double>*, const MotionBase<double>*, const CollisionGeometry<double>*,              \
      const MotionBase<double>*, const Solver*, const ContinuousCollisionRequest<double>&,                        \
      ContinuousCollisionResult<double>&);
TRICOVER_ELSEWHERE(detail::GJKSolver_libccd<double>)
TRICOVER_ELSEWHERE(detail::GJKSolver_indep<double>)
#undef TRICOVER_ELSEWHERE

}  // namespace fcl

namespace tricover_fcl {
namespace {

using Geometry = const fcl::CollisionGeometry<double>*;
using Object = const fcl::CollisionObject<double>*;
using Transform = const fcl::Transform3<double>&;
using Motion = const fcl::MotionBase<double>*;
using ContinuousRequest = const fcl::ContinuousCollisionRequest<double>&;
using ContinuousResult = fcl::ContinuousCollisionResult<double>&;

template <typename Function>
void* addressOf(Function* function) {
  return reinterpret_cast<void*>(function);
}

template <typename Solver>
void* collideOf() {
  return addressOf<std::size_t(Geometry, Transform, Geometry, Transform, const Solver*,
                               const fcl::CollisionRequest<double>&, fcl::CollisionResult<double>&)>(&fcl::collide);
}

template <typename Solver>
void* advancementOf() {
  return addressOf<double(Geometry, Motion, Geometry, Motion, const Solver*, ContinuousRequest, ContinuousResult)>(
      &fcl::detail::continuousCollideConservativeAdvancement);
}

/// What replaced_*.cpp replace, where calls from here go: to ours, or to libfcl's, if that comes first.
std::vector<void*> replacedFunctions() {
  using fcl::detail::GJKSolver_indep, fcl::detail::GJKSolver_libccd;
  using Request = const fcl::DistanceRequest<double>&;
  using Result = fcl::DistanceResult<double>&;
  return {collideOf<GJKSolver_libccd<double>>(),
          collideOf<GJKSolver_indep<double>>(),
          addressOf<double(Object, Object, Request, Result)>(&fcl::distance),
          addressOf<double(Geometry, Transform, Geometry, Transform, Request, Result)>(&fcl::distance),
          advancementOf<GJKSolver_libccd<double>>(),
          advancementOf<GJKSolver_indep<double>>(),
          addressOf<double(Geometry, Motion, Geometry, Motion, ContinuousRequest, ContinuousResult)>(
              &fcl::continuousCollide),
          addressOf<double(Geometry, Transform, Transform, Geometry, Transform, Transform, ContinuousRequest,
                           ContinuousResult)>(&fcl::continuousCollide)};
}

#if defined(__x86_64__)
constexpr auto kCallSlot = R_X86_64_JUMP_SLOT, kAddressSlot = R_X86_64_GLOB_DAT;
#else
constexpr auto kCallSlot = R_AARCH64_JUMP_SLOT, kAddressSlot = R_AARCH64_GLOB_DAT;
#endif

struct Redirected {
  const char* name;  ///< the linker's
  void* ours;
};

/// The functions whose calls go to another object than this one, though this one has them, too.
std::vector<Redirected> findRedirected() {
  std::vector<Redirected> found;
  Dl_info here{}, theirs{}, ours{};
  if (dladdr(reinterpret_cast<void*>(&findRedirected), &here) == 0) return found;
  void* own = nullptr;
  for (void* const function : replacedFunctions()) {
    if (dladdr(function, &theirs) == 0 || theirs.dli_fbase == here.dli_fbase || !theirs.dli_sname) continue;
    // Calls will come here for as long as the process lives: this object is never unloaded.
    if (!own) own = dlopen(here.dli_fname, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
    void* const replacement = own ? dlsym(own, theirs.dli_sname) : nullptr;
    const bool is_ours = replacement && dladdr(replacement, &ours) != 0 && ours.dli_fbase == here.dli_fbase;
    if (is_ours) found.push_back({theirs.dli_sname, replacement});
  }
  return found;
}

/// What the linker's tables of one object say.
struct Tables {
  ElfW(Addr) base;
  const ElfW(Sym) * symbols = nullptr;
  const char* names = nullptr;
  const ElfW(Rela) * calls = nullptr, *others = nullptr;
  std::size_t call_bytes = 0, other_bytes = 0;
  ElfW(Addr) sealed_begin = 0, sealed_end = 0;  ///< pages that were made read-only after the object was loaded
};

Tables tablesOf(const dl_phdr_info& object, ElfW(Addr) page) {
  Tables tables{object.dlpi_addr};
  const ElfW(Dyn)* entry = nullptr;
  for (const auto* header = object.dlpi_phdr; header != object.dlpi_phdr + object.dlpi_phnum; ++header) {
    const ElfW(Addr) begin = object.dlpi_addr + header->p_vaddr;
    if (header->p_type == PT_DYNAMIC) entry = reinterpret_cast<const ElfW(Dyn)*>(begin);
    if (header->p_type != PT_GNU_RELRO) continue;
    tables.sealed_begin = begin & ~(page - 1);
    tables.sealed_end = (begin + header->p_memsz) & ~(page - 1);
  }
  const auto at = [&](const auto*& table, ElfW(Addr) address) {  // relocated by glibc, not by musl
    table = reinterpret_cast<std::remove_reference_t<decltype(table)>>(address < tables.base ? tables.base + address
                                                                                             : address);
  };
  for (; entry && entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_SYMTAB) at(tables.symbols, entry->d_un.d_ptr);
    if (entry->d_tag == DT_STRTAB) at(tables.names, entry->d_un.d_ptr);
    if (entry->d_tag == DT_JMPREL) at(tables.calls, entry->d_un.d_ptr);
    if (entry->d_tag == DT_RELA) at(tables.others, entry->d_un.d_ptr);
    if (entry->d_tag == DT_PLTRELSZ) tables.call_bytes = entry->d_un.d_val;
    if (entry->d_tag == DT_RELASZ) tables.other_bytes = entry->d_un.d_val;
  }
  return tables;
}

void write(void** slot, void* function, const Tables& tables, ElfW(Addr) page) {
  const auto address = reinterpret_cast<ElfW(Addr)>(slot);
  void* const its_page = reinterpret_cast<void*>(address & ~(page - 1));
  const bool is_sealed = address >= tables.sealed_begin && address < tables.sealed_end;
  if (is_sealed && mprotect(its_page, page, PROT_READ | PROT_WRITE) != 0) return;  // registerNarrowphase() will say so
  __atomic_store_n(slot, function, __ATOMIC_RELEASE);
  if (is_sealed) mprotect(its_page, page, PROT_READ);
}

void redirect(const Tables& tables, const ElfW(Rela) * slots, std::size_t bytes,
              const std::vector<Redirected>& redirected, ElfW(Addr) page) {
  for (const auto* slot = slots; slot != slots + bytes / sizeof(*slots); ++slot) {
    const auto type = ELF64_R_TYPE(slot->r_info);
    if (type != kCallSlot && type != kAddressSlot) continue;
    const char* const name = tables.names + tables.symbols[ELF64_R_SYM(slot->r_info)].st_name;
    const auto match = std::find_if(redirected.begin(), redirected.end(),
                                    [&](const Redirected& each) { return std::strcmp(each.name, name) == 0; });
    if (match == redirected.end()) continue;
    void** const place = reinterpret_cast<void**>(tables.base + slot->r_offset);
    if (*place != match->ours) write(place, match->ours, tables, page);
  }
}

struct Update {
  const std::vector<Redirected>& redirected;
  unsigned long long seen, loaded;  ///< how many objects had been loaded, and now have been
};

/// Of every object; stops at the first one if none was loaded since.
int redirectIn(dl_phdr_info* object, std::size_t, void* data) {
  auto& update = *static_cast<Update*>(data);
  update.loaded = object->dlpi_adds;
  if (update.loaded == update.seen) return 1;
  const auto page = static_cast<ElfW(Addr)>(sysconf(_SC_PAGESIZE));
  const Tables tables = tablesOf(*object, page);
  if (!tables.symbols || !tables.names) return 0;
  redirect(tables, tables.calls, tables.call_bytes, update.redirected, page);
  redirect(tables, tables.others, tables.other_bytes, update.redirected, page);
  return 0;
}

}  // namespace

void redirectCalls() {
  static const std::vector<Redirected> redirected = findRedirected();
  if (redirected.empty()) return;
  static std::mutex mutex;
  static unsigned long long seen = 0;
  const std::lock_guard lock(mutex);
  Update update{redirected, seen, seen};
  dl_iterate_phdr(redirectIn, &update);
  seen = update.loaded;
}

}  // namespace tricover_fcl

#else

void tricover_fcl::redirectCalls() {}

#endif
