// SPDX-License-Identifier: BSD-3-Clause
// How the costs of large and adverse inputs grow: each query at n, 2n, 4n and 8n. Needs the core alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "gaps.h"
#include "growth_inputs.h"
#include "measure.h"
#include "report.h"
#include "tricover/tricover.h"

namespace tricover::bench {
namespace {

using growth::Input;

/// A row stops doubling once it has taken this long, or would with the next size if its cost were quadratic.
constexpr double kSecondsPerRow = 2;

/// A query is asked until this much time has passed.
constexpr double kSecondsPerSize = 0.02;

struct Growth {
  std::string input, query;
  std::size_t n;
  /// CPU seconds a query at n, 2n, 4n, 8n; nothing where the row's time was up.
  std::array<std::optional<double>, 4> seconds;

  /// The cost grows like n to this power from the least to the largest size that was measured; nothing if there was
  /// one. (Blocks have eight lanes: some costs rise from one level of the hierarchy to the next and fall again there,
  /// so that a doubling alone says little.)
  std::optional<double> power() const {
    std::optional<double> power;
    for (std::size_t i = 1; i < seconds.size() && seconds[i]; ++i)
      power = std::log2(*seconds[i] / *seconds[0]) / static_cast<double>(i);
    return power;
  }
};

struct Row {
  const char* input;
  Input (*make)(std::size_t n);
  const char* query;
  std::size_t n;
  void (*ask)(const Input& input);
  int queries = 1;  // in one call of `ask`
};

const Pose kIdentity = Pose::Identity();

void askContacts(const Input& in) { contacts(in.a, kIdentity, in.b, in.motion.start); }
void askOneContact(const Input& in) { contacts(in.a, kIdentity, in.b, in.motion.start, {0, 1}); }
void askPenetration(const Input& in) { penetration(in.a, kIdentity, in.b, in.motion.start); }
void askDistance(const Input& in) { distance(in.a, kIdentity, in.b, in.motion.start); }
void askCollide(const Input& in) { collide(in.a, kIdentity, in.b, in.motion.start); }
void askImpact(const Input& in) { timeOfImpact(in.a, {}, in.b, in.motion); }

/// From small steps of the motion, after a first query.
constexpr int kSteps = 10;
void askCollideCached(const Input& in) {
  static PairCache cache;
  for (int i = 0; i < kSteps; ++i) collide(in.a, kIdentity, in.b, in.motion.at(i * 1e-3), cache);
}
void askPairCached(const Input& in) {
  static PairCache cache;
  for (int i = 0; i < kSteps; ++i) {
    Pose pose = in.motion.start;
    pose.translation().x() += i * 1e-3;
    distance(in.a, kIdentity, in.b, pose, cache);
  }
}

Input closeBars(std::size_t n) { return growth::slidingBars(n, 1e-8); }
Input looseBars(std::size_t n) { return growth::slidingBars(n, 1e-3); }
Input passingFans(std::size_t n) { return growth::passingFans(n, 5e-4, 0); }
Input turningFans(std::size_t n) { return growth::passingFans(n, 5e-4, 0.1); }
Input tightDisc(std::size_t n) { return growth::discInHole(n, 1e-4); }

const std::vector<Row>& allRows() {
  static const std::vector<Row> rows = {
      {"islands inside a polygon", growth::islandsOnPlate, "contacts", 1000, askContacts},
      {"islands inside a polygon", growth::islandsOnPlate, "contacts, most = 1", 1000, askOneContact},
      {"islands upon themselves, shifted", growth::islandsOnIslands, "contacts", 1000, askContacts},
      {"islands upon themselves, shifted", growth::islandsOnIslands, "penetration", 100, askPenetration},
      {"jagged outlines deep in each other", growth::jaggedOutlines, "penetration", 32, askPenetration},
      {"a row of islands upon itself, shifted", growth::islandsInRow, "contacts", 1000, askContacts},
      {"a nearest corner, n times", growth::repeatedCorners, "distance", 1000, askDistance},
      {"a nearest corner, n times", growth::repeatedCorners, "distance, cached", 1000, askPairCached, kSteps},
      {"n equal points", growth::equalPoints, "distance", 1000, askDistance},
      {"fans of n edges", growth::fans, "distance", 1000, askDistance},
      {"fans of n edges", growth::fans, "time of impact", 250, askImpact},
      {"fans of n edges that touch", growth::touchingFans, "contacts", 500, askContacts},
      {"fans of n edges that pass, 5e-4 apart", passingFans, "time of impact", 500, askImpact},
      {"fans of n edges that pass and turn", turningFans, "time of impact", 500, askImpact},
      {"bars of n edges, 1e-3 apart, sliding", looseBars, "time of impact", 1000, askImpact},
      {"bars of n edges, 1e-8 apart, sliding", closeBars, "time of impact", 500, askImpact},
      {"disc turning in a hole, fits by 1e-4", tightDisc, "time of impact", 250, askImpact},
      {"spirals wound into each other", growth::spirals, "collide", 10000, askCollide},
      {"spirals wound into each other", growth::spirals, "collide, cached", 10000, askCollideCached, kSteps},
      {"spirals wound into each other", growth::spirals, "time of impact", 1000, askImpact},
      {"spirals of 64 edges a turn", growth::coarseSpirals, "collide", 5000, askCollide},
      {"spirals of 64 edges a turn", growth::coarseSpirals, "collide, cached", 5000, askCollideCached, kSteps},
      {"spirals of 64 edges a turn", growth::coarseSpirals, "time of impact", 2000, askImpact},
      {"31 rings in a maze of n cells' triangles", growth::ringsInMaze, "collide", 1000, askCollide},
  };
  return rows;
}

/// Asks until so much time has passed, at least once: CPU seconds a query.
double meanOf(const Row& row, const Input& input, double seconds) {
  const double start = threadSeconds();
  double passed = 0;
  int asked = 0;
  while (passed <= seconds) {
    row.ask(input);
    asked += row.queries;
    passed = threadSeconds() - start;
  }
  return passed / asked;
}

/// What comes first derives what the polygons keep, some of it not before the two hundredth query.
double measureOnce(const Row& row, const Input& input) {
  meanOf(row, input, 0);
  meanOf(row, input, 5 * kSecondsPerSize);
  return meanOf(row, input, kSecondsPerSize);
}

Growth measureRow(const Row& row) {
  Growth growth{row.input, row.query, row.n, {}};
  const double start = threadSeconds();
  std::size_t n = row.n;
  for (auto& seconds : growth.seconds) {
    const Input input = row.make(n);
    const double before = threadSeconds();
    seconds = measureOnce(row, input);
    const double now = threadSeconds();
    if (now - start + 4 * (now - before) > kSecondsPerRow) break;
    n *= 2;
  }
  return growth;
}

std::string growthTable(const std::vector<Growth>& rows) {
  TextTable lines = {{"input", "query", "n", "n: ms", "2n: ms", "4n: ms", "8n: ms", "grows like"}};
  for (const Growth& row : rows) {
    lines.push_back({row.input, row.query, std::to_string(row.n)});
    for (const auto& seconds : row.seconds) lines.back().push_back(seconds ? shortNumber(1e3 * *seconds) : "");
    char grows[32] = "";
    if (const auto power = row.power()) std::snprintf(grows, sizeof grows, "n^%.1f", std::max(*power, 0.0));
    lines.back().push_back(grows);
  }
  return markdown(lines);
}

std::string growthCsv(const std::vector<Growth>& rows) {
  std::string csv = "input,query,n,seconds_n,seconds_2n,seconds_4n,seconds_8n,power\n";
  for (const Growth& row : rows) {
    csv += '"' + row.input + "\",\"" + row.query + "\"," + std::to_string(row.n);
    for (const auto& seconds : row.seconds) csv += ',' + (seconds ? shortNumber(*seconds) : "");
    csv += ',' + (row.power() ? shortNumber(*row.power()) : "") + '\n';
  }
  return csv;
}

const char* const kHow =
    R"(- CPU time of one thread: the mean of the queries asked in 20 ms, after 100 ms that aren't timed. A row ends where the
  next size would take it beyond 2 s if the cost were quadratic; an empty cell is a size that wasn't reached.
- Narrow gaps: each the least of five means of 2 ms.
- The power is that from n to the largest size. cached: ten small steps with a cache, a tenth of their time.
)";

int run(const std::string& directory) {
  std::vector<Growth> rows;
  for (const Row& row : allRows()) rows.push_back(measureRow(row));
  const std::vector<GapCost> gaps = measureGaps();
  const std::vector<Target> targets = judgeGaps(gaps);
  writeFile(directory + "/growth.md", "# Growth\n\n" + growthTable(rows) + "\n# Narrow gaps\n\n" + gapTable(gaps) +
                                          "\n" + targetsTable(targets) + "\n" + kHow);
  writeFile(directory + "/growth.csv", growthCsv(rows));
  writeFile(directory + "/gaps.csv", gapCsv(gaps));
  writeFile(directory + "/gap_targets.csv", targetsCsv(targets));
  return 0;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  return runProgram(argv[0], "<existing report directory>", argc == 2, [&] { return run(argv[1]); });
}
