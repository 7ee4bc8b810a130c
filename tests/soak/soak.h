// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "random.h"
#include "stages.h"

/// Random cases without end, each against a reference that shares nothing with the kernel, or against a law where there
/// is no reference.
namespace tricover::soak {

using support::Random;

/// One query's cases: how long they go on, and what came of them.
class Run {
 public:
  /// only: the number of the one case to be asked; none: all from the first on.
  Run(const char* query, std::uint64_t seed, double seconds, std::optional<std::uint64_t> only);

  /// Begins another case, as long as there is time: with as much derived as queries have paid for, or up to any stage.
  bool next();
  /// The case's own.
  Random& random() { return random_; }

  /// One more check of this family; whether they collide, meet or whatever the query's two outcomes are.
  void count(const char* family, bool hit);
  /// Prints what is wrong and the case as C++.
  void fail(const char* family, const std::string& what, const std::string& reproduction);

  /// Prints the counts. False if a case failed, or cases of a family were all alike.
  bool report() const;

 private:
  struct Tally {
    long cases = 0, hits = 0, failures = 0;
  };

  const char* query_;
  std::uint64_t seed_, case_, end_case_;
  std::chrono::steady_clock::time_point end_;
  Random random_;
  std::optional<support::UpTo> up_to_;
  std::map<std::string, Tally> families_;
};

// One a file.
void soakCache(Run& run);
void soakConflicts(Run& run);
void soakContacts(Run& run);
void soakCovers(Run& run);
void soakCrossings(Run& run);
void soakDepth(Run& run);
void soakDistance(Run& run);
void soakImpact(Run& run);
void soakLocate(Run& run);
void soakPenetration(Run& run);
void soakRay(Run& run);
void soakScene(Run& run);
void soakTouching(Run& run);
// With FCL alone.
void soakFcl(Run& run);
void soakRound(Run& run);

}  // namespace tricover::soak
