// SPDX-License-Identifier: BSD-3-Clause
#include "laws.h"

#include "exact_depth.h"
#include "exact_reference.h"
#include "portable_lanes.h"
#include "queries.h"
#include "reproduction.h"
#include "stages.h"

namespace tricover::support {
namespace {

struct Asked {
  const Case& c;
  const Query& query;
  Question question;
  const Answer& answer;
  bool truth;  ///< whether the regions are within the margin
  Random& random;
  PairCache& old;  ///< that has seen other pairs

  Question with(double margin, bool swapped, PairCache* cache) const {
    return {margin, swapped, cache, question.touching};
  }
  Answer again(bool swapped = false) const { return query.ask(c, with(question.margin, swapped, nullptr)); }
  Answer of(const Case& other) const { return query.ask(other, question); }
  bool isAlike(bool swapped, PairCache& cache) const {
    return wrongWithCache(c, query, with(question.margin, swapped, &cache)).empty();
  }
};

bool agreesWithExactRationals(const Asked& q) { return !q.answer.meets || *q.answer.meets == q.truth; }

/// Contacts and crossings.
bool listsNoMoreThanWhereTouchesCount(const Asked& q) {
  if (q.question.touching == Touching::Collides) return true;
  return q.answer.numbers.size() <= q.query.ask(q.c, {q.question.margin}).numbers.size();
}

bool isTheSameOfSwappedOperands(const Asked& q) {
  const Answer swapped = q.again(true);
  return isOneTwice(q.c) ? swapped.meets == q.answer.meets : sameButForZeros(q.answer, swapped);
}

bool namesEdgesWithLength(const Asked& q) { return wrongName(q.c, q.answer).empty(); }

bool isTheSameOnPortableLanes(const Asked& q) {
#ifdef TRICOVER_KERNEL_IS_HIDDEN
  return same(q.answer, q.again());
#else
  return same(q.answer, onPortableLanes([&] { return q.again(); }));
#endif
}

/// Of polygons from which nothing is derived yet, up to any stage.
bool isTheSameAtEveryStage(const Asked& q) {
  for (const auto stages : {detail::Stages::Edges, detail::Stages::Hierarchy, detail::Stages::Paid}) {
    const UpTo these(stages);
    const Case c{afresh(q.c.a), q.c.pose_a, afresh(q.c.b), q.c.pose_b};
    const Answer answer = q.of(c);
    if (q.query.depends_on_stages ? answer.meets != q.answer.meets : !same(answer, q.answer)) return false;
  }
  return true;
}

bool isTheSameWhicheverPolygonIsMadeFirst(const Asked& q) {
  const Polygon b = afresh(q.c.b), a = afresh(q.c.a), b_again = afresh(q.c.b);
  return same(q.of({a, q.c.pose_a, b_again, q.c.pose_b}), q.of({afresh(a), q.c.pose_a, b, q.c.pose_b}));
}

bool isTheSameWithACache(const Asked& q) {
  if (q.query.alike == nullptr) return true;
  PairCache cache;
  for (int i = 0; i < 3; ++i) {
    const double margin = q.random.coin() ? q.question.margin : q.question.margin * q.random.unit();
    const Case before{q.c.a, q.c.pose_a, q.c.b, elsewhere(q.random, q.c)};
    q.query.ask(before, q.with(margin, q.random.coin(), &cache));
  }
  return q.isAlike(false, cache) && q.isAlike(true, cache) && q.isAlike(q.random.coin(), q.old);
}

struct Law {
  const char* name;
  bool (*holds)(const Asked& asked);
};

constexpr Law kLaws[] = {
    {"agrees with exact rationals", agreesWithExactRationals},
    {"lists no more than where touches count", listsNoMoreThanWhereTouchesCount},
    {"is the same of swapped operands", isTheSameOfSwappedOperands},
    {"names edges with length", namesEdgesWithLength},
    {"is the same on portable lanes", isTheSameOnPortableLanes},
    {"is the same at every stage", isTheSameAtEveryStage},
    {"is the same whichever polygon is made first", isTheSameWhicheverPolygonIsMadeFirst},
    {"is the same with a cache", isTheSameWithACache},
};

}  // namespace

bool areWithin(const Case& c, double margin, Touching touching) {
  if (touching == Touching::Allowed && margin == 0) return exact::reachInto(c.a, c.pose_a, c.b, c.pose_b);
  if (margin == 0) return exact::collide(c.a, c.pose_a, c.b, c.pose_b);
  const mpq_class squared = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
  return touching == Touching::Allowed ? squared < mpq_class(margin) * margin : exact::within(squared, margin);
}

std::string brokenLaw(const Case& c, double margin, Touching touching, bool truth, Random& random, PairCache& old) {
  const Question question{margin, false, nullptr, touching};
  for (const Query& query : queries()) {
    if (!query.takes_complements && (c.a.isComplement() || c.b.isComplement())) continue;
    const Answer answer = query.ask(c, question);
    for (const Law& law : kLaws)
      if (!law.holds({c, query, question, answer, truth, random, old}))
        return std::string("it isn't so that ") + query.name + " " + law.name + ", margin " + hex(margin) +
               ", touching " + (touching == Touching::Allowed ? "allowed" : "collides") + ", truth " +
               std::to_string(truth);
  }
  return {};
}

}  // namespace tricover::support
