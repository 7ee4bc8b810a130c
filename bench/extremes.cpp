// SPDX-License-Identifier: BSD-3-Clause
#include <gmpxx.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "exact_reference.h"
#include "exact_shifts.h"
#include "random.h"
#include "report.h"
#include "scenes/placed.h"
#include "tradeoff_methods.h"
#include "value_problems.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

constexpr double kNoAnswer = std::numeric_limits<double>::quiet_NaN();

/// The child's part: each answer is written when it is there.
[[noreturn]] void answerInto(int pipe_end, std::size_t count, const std::function<ValueContender()>& make) {
  const rlimit seconds{1, 1}, no_core{0, 0};
  setrlimit(RLIMIT_CPU, &seconds);
  setrlimit(RLIMIT_CORE, &no_core);
  // Messages that rivals print are no part of the table.
  if (!std::freopen("/dev/null", "w", stderr) || !std::freopen("/dev/null", "w", stdout)) _exit(1);
  std::optional<ValueContender> method;
  for (std::size_t i = 0; i < count; ++i) {
    Values answer;
    try {
      if (!method) method = make();
      method->walk({count, 1, i}, answer);
    } catch (const std::exception&) {
      answer = {kNoAnswer};
    }
    if (write(pipe_end, answer.data(), sizeof(double)) != static_cast<ssize_t>(sizeof(double))) _exit(1);
  }
  _exit(0);
}

/// Asks `make()` `count` queries in a child process, where it may throw, crash or hang. NaN where it threw
/// or answered that, and for all that it didn't come to: it has one second of CPU time.
Values askInChild(std::size_t count, const std::function<ValueContender()>& make) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("bench: no pipe");
  std::fflush(nullptr);  // or the child prints it, too
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("bench: no child process");
  if (child == 0) answerInto(ends[1], count, make);
  close(ends[1]);
  Values answers(count, kNoAnswer);
  for (double& answer : answers) {
    double read_answer;
    if (read(ends[0], &read_answer, sizeof read_answer) != static_cast<ssize_t>(sizeof read_answer)) break;
    answer = read_answer;
  }
  close(ends[0]);
  int status;
  waitpid(child, &status, 0);
  return answers;
}

/// One way to the extreme: far from the origin, scaled, or squeezed to slivers.
struct Sweep {
  std::string name;
  std::vector<int> exponents;
  KnownScene (*at)(const KnownScene& plain, double power);
};

const std::vector<Sweep>& sweeps() {
  static const std::vector<int> away = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  static const auto both = [](const KnownScene& plain, auto map) {
    return makeScene("", "", map(plain.fixed), map(plain.moving));
  };
  static const std::vector<Sweep> all = {
      {"both polygons' vertices moved by", away,
       [](const KnownScene& plain, double by) {
         return both(plain, [=](const Polygon& polygon) { return polygon.translated(Vec2::Constant(by)); });
       }},
      {"both poses moved by", away,
       [](const KnownScene& plain, double by) {
         KnownScene scene = plain;
         scene.fixed_pose.translation() = Vec2::Constant(by);
         return scene;
       }},
      {"scaled by",
       {-300, -200, -100, -50, -20, -10, -5, 0, 5, 10, 20, 50, 100, 200, 300},
       [](const KnownScene& plain, double factor) {
         return both(plain, [=](const Polygon& polygon) { return polygon.scaled(factor); });
       }},
      {"slivers, squeezed to",
       {-1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12, -13, -14, -15},
       [](const KnownScene& plain, double factor) {
         return both(plain, [=](const Polygon& polygon) {
           return mapped(polygon, [=](const Vec2& v) { return Vec2(v.x(), v.y() * factor); });
         });
       }}};
  return all;
}

/// "1e-15".
std::string powerOfTen(int exponent) { return "1e" + std::to_string(exponent); }

/// When polygons first meet that are apart at time 0, and of which one is shifted: exact but for the last rounding.
double slidingImpact(const KnownScene& scene, const Motion& motion) {
  const auto contacts = exact::contactsOfShifts(scene.fixed, Motion::still(scene.fixed_pose), scene.moving, motion);
  return contacts.empty() ? kNoContact : contacts[0].begin.get_d();
}

/// Slides from a tenth of the size before contact towards a tenth behind it.
ValueProblem impactsAt(const KnownScene& scene, bool convex) {
  support::Random random(8);
  std::vector<Motion> motions;
  Values truth;
  for (std::size_t i = 1; i < scene.poses.size(); ++i) {
    const KnownPose &behind = scene.poses[i - 1], &ahead = scene.poses[i];
    if (ahead.collides || offsetNames()[ahead.offset] != "1e-1") continue;
    const Vec2 way = behind.pose.translation() - ahead.pose.translation();
    motions.push_back(Motion::translation(ahead.pose, random.real(0.7, 1.5) * way));
    truth.push_back(slidingImpact(scene, motions.back()));
  }
  ValueProblem problem{kImpact, "", &scene, truth, impactMethods(scene, motions, convex, 1000)};
  // Early by no more than timeOfImpact() says: within 1e-13 of these lengths it may report a contact.
  problem.may_round = [=, &scene](std::size_t i, double time) {
    const double lengths = (motions[i].start.translation() - scene.fixed_pose.translation()).norm() +
                           motions[i].shift.norm() + scene.fixed.coveringOrigin().norm() + scene.fixed.radius() +
                           scene.moving.coveringOrigin().norm() + scene.moving.radius();
    return time <= truth[i] &&
           exact::within(exact::distanceSquared(scene.fixed, scene.fixed_pose, scene.moving, motions[i].at(time)),
                         mpq_class(1.01e-13 * lengths));
  };
  return problem;
}

/// Overlaps by much: from contact a part of the way towards the place where the origins of both coverings coincide.
ValueProblem penetrationsAt(const KnownScene& scene) {
  support::Random random(7);
  std::vector<Pose> poses;
  Values truth;
  for (const KnownPose& known : scene.poses) {
    if (!known.collides) continue;
    Pose pose = known.pose;
    const Vec2 middle = scene.fixed_pose * scene.fixed.coveringOrigin() - pose.linear() * scene.moving.coveringOrigin();
    pose.translation() += random.real(0.2, 0.9) * (middle - pose.translation());
    poses.push_back(pose);
    truth.push_back(exactDepth(scene, pose));
  }
  return {kPenetration, "", &scene, truth, penetrationMethods(scene, poses, true)};
}

/// Whether they collide, 1 or 0, by every method at its best settings. Stages that say "maybe" alone are left out.
ValueProblem collisionsAt(const KnownScene& scene, bool convex) {
  static const ValueQuery query = {"collide", ValueQuery::Error::OfTruth,
                                   [](double value, double truth, double) { return value != truth; }};
  ValueProblem problem{query, "", &scene, {}, {}};
  for (const KnownPose& known : scene.poses) problem.truth.push_back(known.collides ? 1 : 0);
  const std::size_t count = scene.poses.size();
  for (const CollisionMethod& method : collisionMethods(scene, convex)) {
    const bool is_stage = method.family == "bounding discs" || method.family == "influence areas";
    if (is_stage || method.setting == "1e-10") continue;
    // Fresh polygons for every pose, as plain signs answer by the stages that are built.
    const auto ask = [=](std::size_t i) {
      Hits hits;
      method.make().walk({count, 1, i}, hits);
      return hits.empty() ? 0.0 : 1.0;
    };
    problem.methods.push_back({method.family, method.setting, method.promise,
                               [=] { return contender<Values>("", Role::Rival, false, count, ask); }});
  }
  return problem;
}

/// `convex`: before the scene was moved or scaled. Depths are known of polygons that rounding didn't dent then.
std::vector<ValueProblem> problemsAt(const KnownScene& scene, bool convex) {
  std::vector<ValueProblem> problems = {collisionsAt(scene, convex), nearDistances(scene, convex),
                                        impactsAt(scene, convex)};
  if (convex && isConvexPair(scene)) {
    problems.push_back(shallowContacts(scene));
    problems.push_back(penetrationsAt(scene));
  }
  return problems;
}

/// The settings of users who want the best, and the defaults.
bool isShown(const ValueMethod& method) {
  for (const char* setting : {"", "exact", "1e-6", "1e-10", "1e-12", "time_error 1e-6", "time_error 1e-12", "1000"})
    if (method.setting == setting) return true;
  return false;
}

/// For all kinds of polygons.
struct Answers {
  std::vector<double> errors;  ///< of what was answered
  std::size_t asked = 0, wrong = 0, failed = 0;

  void add(const Answers& other) {
    errors.insert(errors.end(), other.errors.begin(), other.errors.end());
    asked += other.asked;
    wrong += other.wrong;
    failed += other.failed;
  }
  /// The error at that part of the sorted errors; 1 if there is none.
  double error(double part) const {
    if (errors.empty()) return 1;
    std::vector<double> sorted = errors;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
  }
};

/// A method's answers to one query, at[sweep][exponent].
struct Row {
  std::string query, method;
  std::vector<std::vector<Answers>> at;
};

/// In the order of first appearance, which is that of the queries.
Row& rowOf(std::vector<Row>& rows, const std::string& query, const std::string& method) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& row) { return row.query == query && row.method == method; });
  if (found != rows.end()) return *found;
  rows.push_back({query, method, {}});
  for (const Sweep& sweep : sweeps()) rows.back().at.emplace_back(sweep.exponents.size());
  return rows.back();
}

/// Enters a method's answers. False if it is one of ours and doesn't keep its promise.
bool ask(const ValueProblem& problem, const ValueMethod& method, Answers& to) {
  const Values values = askInChild(problem.truth.size(), method.make);
  const bool ours = std::isfinite(method.promise);
  bool kept = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ValueError error = errorOf(problem, method, i, values[i]);
    const bool failed = std::isnan(values[i]);
    ++to.asked;
    to.failed += failed;
    to.wrong += error.wrong && !failed;
    if (!failed) to.errors.push_back(error.counted);
    if (!ours || (error.keeps_promise && !error.wrong)) continue;
    std::fprintf(stderr, "error: %s by %s is %.17g, not %.17g: %s\n", problem.query.name.c_str(), method.name().c_str(),
                 values[i], problem.truth[i], problem.scene->name.c_str());
    kept = false;
  }
  return kept;
}

/// Every other extreme of a sweep, the last one with them; all if `full`.
bool askAll(std::vector<Row>& rows, bool full) {
  bool kept = true;
  for (std::size_t s = 0; s < sweeps().size(); ++s) {
    const Sweep& sweep = sweeps()[s];
    for (std::size_t e = 0; e < sweep.exponents.size(); ++e) {
      if (!full && (sweep.exponents.size() - 1 - e) % 2 == 1) continue;
      for (const Kind kind : {Kind::Convex, Kind::Slim, Kind::Starred, Kind::WithHole}) {
        const KnownScene plain = makeScene(kind, 8);
        KnownScene scene = sweep.at(plain, std::pow(10, sweep.exponents[e]));
        scene.name = workloads::name(kind) + ", " + sweep.name + " " + powerOfTen(sweep.exponents[e]);
        scene.poses = placementsAroundContact(scene, full ? 16 : 4, 3, 5);
        for (const ValueProblem& problem : problemsAt(scene, isConvexPair(plain)))
          for (const ValueMethod& method : problem.methods)
            if (isShown(method))
              kept = ask(problem, method, rowOf(rows, problem.query.name, method.name()).at[s][e]) && kept;
      }
    }
  }
  return kept;
}

std::string errorText(double error) { return error == 0 ? "0" : formatted("%.0e", error); }

/// The median and the worst error over all extremes of a sweep, and what is no error but wrong.
std::string summary(const std::vector<Answers>& sweep, bool counts_alone) {
  Answers all;
  for (const Answers& answers : sweep) all.add(answers);
  if (all.asked == 0) return "";
  if (all.failed == all.asked) return "fails";
  std::string text = counts_alone ? (all.wrong + all.failed > 0 ? "" : "0, ")
                                  : errorText(all.error(0.5)) + " / " + errorText(all.error(1)) + ", ";
  if (all.wrong > 0) text += std::to_string(all.wrong) + " wrong, ";
  if (all.failed > 0) text += std::to_string(all.failed) + " fail, ";
  text.resize(text.size() - 2);
  if (all.wrong + all.failed > 0) text += " of " + std::to_string(all.asked);
  return text;
}

/// One a query.
std::string tables(const std::vector<Row>& rows) {
  std::string text;
  TextTable lines;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (r == 0 || rows[r].query != rows[r - 1].query) {
      text += "## " + rows[r].query + "\n\n";
      lines = {{"method"}};
      for (const Sweep& sweep : sweeps()) lines[0].push_back(sweep.name);
    }
    lines.push_back({rows[r].method});
    for (const std::vector<Answers>& sweep : rows[r].at)
      lines.back().push_back(summary(sweep, rows[r].query == "collide"));
    if (r + 1 == rows.size() || rows[r].query != rows[r + 1].query) text += markdown(lines) + "\n";
  }
  return text;
}

/// Calls visit(row, number of the row among its query's, sweep, exponent, answers).
template <class Visit>
void forEachCell(const std::vector<Row>& rows, Visit visit) {
  std::size_t first = 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].query != rows[first].query) first = r;
    for (std::size_t s = 0; s < sweeps().size(); ++s)
      for (std::size_t e = 0; e < sweeps()[s].exponents.size(); ++e)
        if (rows[r].at[s][e].asked > 0) visit(rows[r], r - first, s, e, rows[r].at[s][e]);
  }
}

std::string csvOf(const std::vector<Row>& rows) {
  std::string csv = "query,sweep,exponent,method,queries,median_error,worst_error,wrong,failed\n";
  forEachCell(rows, [&](const Row& row, std::size_t, std::size_t s, std::size_t e, const Answers& answers) {
    csv += row.query + ",\"" + sweeps()[s].name + "\"," + powerOfTen(sweeps()[s].exponents[e]) + ",\"" + row.method +
           "\"," + std::to_string(answers.asked) + ',' + formatted("%.3e", answers.error(0.5)) + ',' +
           formatted("%.3e", answers.error(1)) + ',' + std::to_string(answers.wrong) + ',' +
           std::to_string(answers.failed) + '\n';
  });
  return csv;
}

/// A block a query and sweep, "distance 0" and so on: column and row, their names, the worst error's power of ten, and
/// the share of what is wrong or failed.
Blocks blocksOf(const std::vector<Row>& rows) {
  Blocks blocks;
  forEachCell(rows, [&](const Row& row, std::size_t r, std::size_t s, std::size_t e, const Answers& answers) {
    const double faults = static_cast<double>(answers.wrong + answers.failed) / static_cast<double>(answers.asked);
    blocks[row.query + ' ' + std::to_string(s)] += std::to_string(e) + ' ' + std::to_string(r) + " \"" + row.method +
                                                   "\" \"" + powerOfTen(sweeps()[s].exponents[e]) + "\" " +
                                                   formatted("%.1f", std::log10(std::max(answers.error(1), 1e-16))) +
                                                   ' ' + formatted("%.4f", faults) + '\n';
  });
  return blocks;
}

const char* const kHow =
    R"(- A cell is the median and the worst error over all extremes of its column: of distances and penetrations relative to
  the truth (1 where it is more), of contacts relative to the size, of times as a part of the motion; of collisions 0 or
  1, at poses around first contact as for the trade-off: 1 ulp, 1e-13, 1e-10, 1e-7, 1e-4 and 0.1 of the size either way. wrong: not just
  inexact (a distance of 0, or none, where there is one; a time later than contact by more than 1e-9 of the motion, or
  none; a depth too small to part them by more than 1e-9 of the size, or no contact). fail: an exception, a crash, NaN,
  or no answer within a second, after which the rest counts as failed, too.
- Polygons of 8 vertices (round and slim convex, starred, with hole), 100 units long before they are moved or scaled.
  vertices moved: both polygons' own coordinates are large, and so are the pose's. poses moved: the coordinates stay,
  both poses have a far translation. plain float, plain double: the relative pose is computed in doubles, the signs after
  that. tolerance: false alarms within it are what was asked for, and counted all the same. distance: gaps of 1e-13 to 1e-1 of the size. time of impact: slides from a
  tenth of the size before first contact to somewhere behind it. contacts: the deepest one's depth, of convex polygons
  that overlap by 1e-13 to 1e-1 of the size. penetration: of convex ones that overlap by more.
- All truths are exact rational arithmetic's, on the doubles that remain after the move: the distance, the first meeting
  of a vertex and an edge, the least gap between supports.
- tricover's times are early where coordinates are large: timeOfImpact() may take for contact what comes within 1e-13 of
  the coordinates' size. An overlap thinner than the rounding of coordinates, as slivers have, contacts() may take for
  a touch, of depth 0; penetration() doesn't.
- FCL's GJK has tolerances in proportion to the size, its default 1e-6 and 1e-10; its prisms grow with the size, too. Its
  advancement misses what slides even at the origin: a step that lands on the contact finds no direction there. GEOS and
  Boost get the fixed polygon's coordinates in the world. Box2D computes in floats, with a skin of 3e-6 of 100 units.
)";

}  // namespace

bool runExtremes(const std::string& directory, bool full) {
  std::vector<Row> rows;
  const bool kept = askAll(rows, full);
  writeFile(directory + "/extremes.md",
            "# At the extremes: median and worst errors\n\n" + tables(rows) + "# How it was measured\n\n" + kHow);
  writeFile(directory + "/extremes.csv", csvOf(rows));
  writeBlocks(directory + "/extremes.dat", blocksOf(rows));
  return kept;
}

}  // namespace tricover::bench
