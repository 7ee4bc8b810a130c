// SPDX-License-Identifier: BSD-3-Clause
// soak QUERY [--seconds N] [--seed S] [--case C]: random cases of a query for so long, or the one that a failure names;
// see usage(). Exits 1 if one failed.
#include "soak.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace tricover::soak {
namespace {

/// So few cases may be all alike by chance.
constexpr long kFew = 2000;
constexpr long kMostPrinted = 20;

struct Query {
  const char* name;
  void (*run)(Run& run);
};

constexpr Query kQueries[] = {
    {"cache", soakCache},
    {"conflicts", soakConflicts},
    {"contacts", soakContacts},
    {"covers", soakCovers},
    {"crossings", soakCrossings},
    {"depth", soakDepth},
    {"distance", soakDistance},
    {"impact", soakImpact},
    {"locate", soakLocate},
    {"penetration", soakPenetration},
    {"ray", soakRay},
    {"scene", soakScene},
    {"touching", soakTouching},
#ifdef TRICOVER_SOAK_FCL
    {"fcl", soakFcl},
    {"round", soakRound},
#endif
};

int usage() {
  std::fprintf(stderr, "soak QUERY [--seconds N] [--seed S] [--case C], where QUERY is all or one of");
  for (const Query& query : kQueries) std::fprintf(stderr, " %s", query.name);
  std::fprintf(stderr, "\n");
  return 2;
}

}  // namespace

Run::Run(const char* query, std::uint64_t seed, double seconds, std::optional<std::uint64_t> only)
    : query_(query),
      seed_(seed),
      case_(only.value_or(0)),
      end_case_(only ? *only + 1 : std::numeric_limits<std::uint64_t>::max()),
      end_(std::chrono::steady_clock::now() +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds))),
      random_(seed) {}

bool Run::next() {
  if (case_ == end_case_) return false;
  random_ = Random(Random(seed_).bits() + case_++);
  up_to_.reset();
  up_to_.emplace(static_cast<detail::Stages>(Random(case_).integer(0, 3)));
  return std::chrono::steady_clock::now() < end_;
}

void Run::count(const char* family, bool hit) {
  Tally& tally = families_[family];
  ++tally.cases;
  tally.hits += hit;
}

void Run::fail(const char* family, const std::string& what, const std::string& reproduction) {
  if (++families_[family].failures > kMostPrinted) return;
  std::printf("FAILED %s, %s, seed %llu, case %llu: %s\n%s\n", query_, family, static_cast<unsigned long long>(seed_),
              static_cast<unsigned long long>(case_ - 1), what.c_str(), reproduction.c_str());
  std::fflush(stdout);
}

bool Run::report() const {
  bool right = true;
  long cases = 0, failures = 0;
  for (const auto& [family, tally] : families_) {
    const double share = static_cast<double>(tally.hits) / static_cast<double>(tally.cases);
    const bool alike = tally.cases >= kFew && (share < 0.02 || share > 0.98);
    std::printf("%-12s %-24s %10ld cases %5.1f %% hits %6ld failed%s\n", query_, family.c_str(), tally.cases,
                100 * share, tally.failures, alike ? ": ALL ALIKE" : "");
    right = right && !alike && tally.failures == 0;
    cases += tally.cases, failures += tally.failures;
  }
  std::printf("%-12s %-24s %10ld cases %6ld failed\n", query_, "all", cases, failures);
  return right && cases > 0;
}

int main(int argc, char** argv) {
  double seconds = 2;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> only;
  const char* wanted = nullptr;
  for (int i = 1; i < argc; ++i) {
    const bool valued = i + 1 < argc;
    if (valued && std::strcmp(argv[i], "--seconds") == 0)
      seconds = std::atof(argv[++i]);
    else if (valued && std::strcmp(argv[i], "--seed") == 0)
      seed = std::strtoull(argv[++i], nullptr, 10);
    else if (valued && std::strcmp(argv[i], "--case") == 0)
      only = std::strtoull(argv[++i], nullptr, 10);
    else if (wanted == nullptr && argv[i][0] != '-')
      wanted = argv[i];
    else
      return usage();
  }
  bool known = false, right = true;
  for (const Query& query : kQueries) {
    if (wanted == nullptr || (std::strcmp(wanted, "all") != 0 && std::strcmp(wanted, query.name) != 0)) continue;
    known = true;
    Run run(query.name, seed, seconds, only);
    query.run(run);
    right = run.report() && right;
  }
  return !known ? usage() : right ? 0 : 1;
}

}  // namespace tricover::soak

int main(int argc, char** argv) { return tricover::soak::main(argc, argv); }
