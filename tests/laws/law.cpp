// SPDX-License-Identifier: BSD-3-Clause
#include "law.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "reproduction.h"
#include "stages.h"

namespace tricover::laws {
namespace {

std::map<std::string, Laws (*)()>& registered() {
  static std::map<std::string, Laws (*)()> all;
  return all;
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

}  // namespace

void Tally::count(const std::string& trait, bool is_so) {
  Count& count = counts_[trait];
  ++count.asked;
  count.so += is_so;
}

std::string Tally::line() const {
  std::string line;
  for (const auto& [trait, count] : counts_)
    line += (line.empty() ? "" : ", ") + percent(static_cast<double>(count.so) / static_cast<double>(count.asked)) +
            " of " + std::to_string(count.asked) + " " + trait;
  return line;
}

std::string Tally::wrongShare(const Shares& shares, long cases, bool is_sample) const {
  for (const Share& share : shares) {
    const auto found = counts_.find(share.trait);
    if (found == counts_.end()) {
      if (is_sample) continue;
      return std::string("never asked: ") + share.trait;
    }
    const auto asked = static_cast<double>(found->second.asked), is = static_cast<double>(found->second.so) / asked;
    const auto slack = [&](double bound) {
      return is_sample ? 4 * std::sqrt(bound * (1 - bound) / std::min(asked, static_cast<double>(cases))) : 0;
    };
    if (is < share.least - slack(share.least) || is > share.most + slack(share.most))
      return percent(is) + " " + share.trait + ", which is to be from " + percent(share.least) + " to " +
             percent(share.most);
  }
  return {};
}

Register::Register(const char* query, Laws (*laws)()) { registered()[query] = laws; }

Laws allLaws() {
  Laws all;
  for (const auto& [query, lawsOf] : registered())
    for (Law& law : lawsOf()) {
      law.query = query;
      all.push_back(std::move(law));
    }
  return all;
}

std::string wrongCase(const Law& law, std::uint64_t seed, std::uint64_t number, Tally& tally) {
  Random random(Random(seed).bits() + number);
  const auto stages = random.coin() ? detail::Stages::All : static_cast<detail::Stages>(random.integer(0, 3));
  const support::UpTo up_to(stages);
  const std::string wrong = [&]() -> std::string {
    try {
      return law.wrong(random, tally);
    } catch (const std::exception& error) {
      return error.what();
    }
  }();
  if (wrong.empty()) return wrong;
  return "soak " + law.query + " --family " + law.family + " --seed " + std::to_string(seed) + " --case " +
         std::to_string(number) + ": " + wrong;
}

Family family(const char* name, Case (*make)(Random& random)) {
  return {name, [make](std::uint64_t seed) {
            Random random(seed);
            return make(random);
          }};
}

void add(Laws& laws, const std::vector<Family>& families, int cases, const WrongPair& wrong, const Shares& shares,
         const std::string& prefix) {
  for (const Family& family : families)
    laws.push_back({prefix + family.name, cases,
                    [family, wrong](Random& random, Tally& tally) {
                      Case c = family.make(random.bits());
                      const std::string problem = wrong(random, tally, c);
                      return problem.empty() ? problem : problem + "\n" + support::reproduction(c);
                    },
                    shares});
}

}  // namespace tricover::laws
