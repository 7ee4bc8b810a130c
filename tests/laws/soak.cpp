// SPDX-License-Identifier: BSD-3-Clause
// soak QUERY [--family F] [--seconds N] [--seed S] [--case C]: cases of a query's laws for so long, each law's as often
// as CTest asks it; or the one case that a failure names. Exits 1 if one failed.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <set>
#include <string>

#include "law.h"

namespace tricover::laws {
namespace {

constexpr long kMostPrinted = 20;
/// So few cases may be all alike by chance.
constexpr long kFew = 100;

struct Course {
  Law law;
  Tally tally;
  std::uint64_t cases = 0;
  long failures = 0;
};

struct Options {
  std::string query, family;
  double seconds = 2;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> only;
};

int usage() {
  std::set<std::string> queries;
  for (const Law& law : allLaws()) queries.insert(law.query);
  std::fprintf(stderr, "soak QUERY [--family F] [--seconds N] [--seed S] [--case C], where QUERY is one of");
  for (const std::string& query : queries) std::fprintf(stderr, " %s", query.c_str());
  std::fprintf(stderr, "; or all\n");
  return 2;
}

bool parse(int argc, char** argv, Options& options) {
  if (argc < 2 || argc % 2 != 0) return false;
  options.query = argv[1];
  for (int i = 2; i < argc; i += 2) {
    const char* value = argv[i + 1];
    if (std::strcmp(argv[i], "--family") == 0)
      options.family = value;
    else if (std::strcmp(argv[i], "--seconds") == 0)
      options.seconds = std::atof(value);
    else if (std::strcmp(argv[i], "--seed") == 0)
      options.seed = std::strtoull(value, nullptr, 10);
    else if (std::strcmp(argv[i], "--case") == 0)
      options.only = std::strtoull(value, nullptr, 10);
    else
      return false;
  }
  return !options.only || !options.family.empty();
}

void ask(Course& course, std::uint64_t seed, std::uint64_t number) {
  ++course.cases;
  const std::string wrong = wrongCase(course.law, seed, number, course.tally);
  if (wrong.empty() || ++course.failures > kMostPrinted) return;
  std::printf("FAILED %s\n", wrong.c_str());
  std::fflush(stdout);
}

bool report(const Course& course) {
  const auto cases = static_cast<long>(course.cases);
  const std::string share = cases < kFew ? "" : course.tally.wrongShare(course.law.shares, cases, true);
  std::printf("%-12s %-24s %8ld cases %4ld failed: %s %s\n", course.law.query.c_str(), course.law.family.c_str(), cases,
              course.failures, course.tally.line().c_str(), share.empty() ? "" : ("ALL ALIKE: " + share).c_str());
  return share.empty() && course.failures == 0;
}

bool soak(const std::vector<Law>& laws, const Options& options) {
  using Clock = std::chrono::steady_clock;
  std::vector<Course> courses;
  int weights = 0;
  for (const Law& law : laws) courses.push_back({law, {}}), weights += law.cases;
  const auto end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds));
  Random random(options.seed);
  if (options.only) ask(courses.front(), options.seed, *options.only);
  while (!options.only && Clock::now() < end) {
    int left = random.integer(1, weights);
    auto course = courses.begin();
    while ((left -= course->law.cases) > 0) ++course;
    ask(*course, options.seed, course->cases);
  }
  return std::count_if(courses.begin(), courses.end(), [](const Course& course) { return !report(course); }) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) return usage();
  std::map<std::string, std::vector<Law>> queries;
  for (const Law& law : allLaws())
    if ((options.query == "all" || options.query == law.query) &&
        (options.family.empty() || options.family == law.family))
      queries[law.query].push_back(law);
  bool right = true;
  for (const auto& [query, laws] : queries) right = soak(laws, options) && right;
  return queries.empty() ? usage() : right ? 0 : 1;
}

}  // namespace tricover::laws

int main(int argc, char** argv) { return tricover::laws::main(argc, argv); }
