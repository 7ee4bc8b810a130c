// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "families.h"
#include "tricover/pair_cache.h"
#include "tricover/touching.h"

/// Every query about a pair as one type, so that a law of all of them is written once.
namespace tricover::support {

struct Question {
  double margin = 0;
  bool swapped = false;        ///< asked about b and a
  PairCache* cache = nullptr;  ///< none
  Touching touching = Touching::Collides;
};

/// Everything that a query tells, as if a had been the first operand.
struct Answer {
  std::optional<bool> meets;  ///< whether the regions are within the margin; nothing where the answer doesn't tell
  std::vector<double> numbers;
  std::vector<std::pair<EdgeIndex, EdgeIndex>> edges;  ///< of a and of b
};

/// To the last bit. An answer from swapped operands may differ by the sign of a zero, and by points that overflow.
bool same(const Answer& p, const Answer& q);
bool sameButForZeros(const Answer& p, const Answer& q);

struct Query {
  const char* name;
  Answer (*ask)(const Case& c, const Question& question);
  /// Whether the answer with a cache is right beside the one without; null for a query that takes no cache.
  bool (*alike)(const Case& c, const Question& question, const Answer& without, const Answer& with) = nullptr;
  /// What is derived from polygons may change more than whether they meet: how soon a parting is seen, within the
  /// error.
  bool depends_on_stages = false;
  bool takes_complements = true;
};

const std::vector<Query>& queries();

/// What differs from the answer without the question's cache; empty if nothing does.
std::string wrongWithCache(const Case& c, const Query& query, const Question& question);

/// The first edge without length that an answer names though its ring has one with; empty if there is none.
std::string wrongName(const Case& c, const Answer& answer);

}  // namespace tricover::support
