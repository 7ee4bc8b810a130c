// SPDX-License-Identifier: BSD-3-Clause
#include "target.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "report.h"

namespace tricover::bench {

std::string cellName(const Result& result) {
  const Workload& w = result.workload;
  return w.scene + " " + std::to_string(w.vertices_fixed) + " x " + std::to_string(w.vertices_moving) + ", " + w.name;
}

std::optional<double> nsOf(const Result& result, const std::string& method) {
  for (const Timing& timing : result.timings) {
    if (timing.name == method) return timing.ns;
  }
  return {};
}

std::optional<double> fastest(const Result& result, Role role) {
  std::optional<double> ns;
  for (const Timing& timing : result.timings) {
    if (timing.role == role && (!ns || timing.ns < *ns)) ns = timing.ns;
  }
  return ns;
}

Target judged(std::string subject, std::string compared, std::vector<Figure> figures, const Wanted& wanted) {
  std::sort(figures.begin(), figures.end(), [](const Figure& p, const Figure& q) { return p.value < q.value; });
  const Figure& worst = wanted.at_least ? figures.front() : figures.back();
  const std::size_t n = figures.size();
  const double median = (figures[(n - 1) / 2].value + figures[n / 2].value) / 2;
  std::string text = (wanted.at_least ? ">= " : "<= ") + shortNumber(wanted.every) + " " + wanted.unit;
  if (wanted.median > 0) text += ", median >= " + shortNumber(wanted.median) + " " + wanted.unit;
  const bool met =
      (wanted.at_least ? worst.value >= wanted.every : worst.value <= wanted.every) && median >= wanted.median;
  return {std::move(subject), std::move(compared), text, wanted.unit, worst.value, median, worst.cell, met};
}

std::string targetsTable(const std::vector<Target>& targets) {
  TextTable table = {{"target", "compared", "wanted", "worst", "median", "worst cell", "met"}};
  for (const Target& t : targets) {
    table.push_back({t.subject, t.compared, t.wanted, shortNumber(t.worst) + " " + t.unit,
                     shortNumber(t.median) + " " + t.unit, t.worst_cell, t.met ? "yes" : "**no**"});
  }
  return markdown(table);
}

std::string targetsCsv(const std::vector<Target>& targets) {
  std::ostringstream out;
  out << "target,compared,wanted,unit,worst,median,worst_cell,met\n";
  for (const Target& t : targets) {
    out << '"' << t.subject << "\",\"" << t.compared << "\",\"" << t.wanted << "\"," << t.unit << ',' << t.worst << ','
        << t.median << ",\"" << t.worst_cell << "\"," << (t.met ? "yes" : "no") << '\n';
  }
  return out.str();
}

}  // namespace tricover::bench
