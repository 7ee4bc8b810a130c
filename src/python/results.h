// SPDX-License-Identifier: BSD-3-Clause
// Results as Python's named tuples, of numbers or of arrays, and queries of many operands on threads.
#pragma once

#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "python/arrays.h"
#include "python/threads.h"

namespace tricover_python {

/// The Python class of a result, and its fields in that class's order.
template <typename Result>
struct Record;

#define TRICOVER_PYTHON_RECORD(Type, name, ...)                   \
  template <>                                                     \
  struct Record<tricover::Type> {                                 \
    using R = tricover::Type;                                     \
    static constexpr const char* kName = name;                    \
    static constexpr auto kFields = std::make_tuple(__VA_ARGS__); \
  }
TRICOVER_PYTHON_RECORD(DistanceResult, "Distance", &R::distance, &R::point_a, &R::point_b, &R::edge_a, &R::edge_b);
TRICOVER_PYTHON_RECORD(SignedDistance, "SignedDistance", &R::distance, &R::normal, &R::point_a, &R::point_b, &R::edge_a,
                       &R::edge_b);
TRICOVER_PYTHON_RECORD(Penetration, "Penetration", &R::depth, &R::normal, &R::lower_bound, &R::optimal, &R::translation,
                       &R::point_a, &R::point_b, &R::edge_a, &R::edge_b);
TRICOVER_PYTHON_RECORD(Depth, "Depth", &R::depth, &R::normal, &R::point_a, &R::point_b, &R::edge_a, &R::edge_b,
                       &R::is_point_of_a, &R::upper_bound);
TRICOVER_PYTHON_RECORD(Excess, "Excess", &R::distance, &R::point, &R::nearest, &R::edge, &R::nearest_edge,
                       &R::upper_bound);
TRICOVER_PYTHON_RECORD(Crossing, "Crossing", &R::edge_a, &R::edge_b, &R::point);
TRICOVER_PYTHON_RECORD(Impact, "Impact", &R::time, &R::point, &R::normal, &R::edge_a, &R::edge_b, &R::budget_ended);
TRICOVER_PYTHON_RECORD(Conflict, "Conflict", &R::impact, &R::end, &R::budget_ended, &R::meets_at_end);
TRICOVER_PYTHON_RECORD(LeastDistance, "LeastDistance", &R::distance, &R::lower_bound, &R::time, &R::point_a,
                       &R::point_b, &R::edge_a, &R::edge_b, &R::budget_ended);
TRICOVER_PYTHON_RECORD(RayHit, "RayHit", &R::fraction, &R::point, &R::normal, &R::edge);
TRICOVER_PYTHON_RECORD(RayInterval, "RayInterval", &R::begin, &R::end);
TRICOVER_PYTHON_RECORD(Exit, "Exit", &R::time, &R::point, &R::budget_ended);
TRICOVER_PYTHON_RECORD(BodyOptions, "BodyOptions", &R::margin, &R::category, &R::mask, &R::touching);
TRICOVER_PYTHON_RECORD(BodyDistance, "BodyDistance", &R::body, &R::result);
TRICOVER_PYTHON_RECORD(BodyLeastDistance, "BodyLeastDistance", &R::body, &R::least);
TRICOVER_PYTHON_RECORD(BodyImpact, "BodyImpact", &R::body, &R::impact);
TRICOVER_PYTHON_RECORD(BodyRayHit, "BodyRayHit", &R::body, &R::hit);
TRICOVER_PYTHON_RECORD(BodyRayInterval, "BodyRayInterval", &R::body, &R::interval);
TRICOVER_PYTHON_RECORD(BodyPair, "BodyPair", &R::first, &R::second);
TRICOVER_PYTHON_RECORD(PairContact, "PairContact", &R::pair, &R::contact);
TRICOVER_PYTHON_RECORD(PairImpact, "PairImpact", &R::pair, &R::impact);
TRICOVER_PYTHON_RECORD(PairConflict, "PairConflict", &R::pair, &R::conflict);
TRICOVER_PYTHON_RECORD(paper::CoveringTriangle, "CoveringTriangle", &R::s, &R::v, &R::w, &R::sign);
#undef TRICOVER_PYTHON_RECORD

inline py::object one(bool value) { return py::bool_(value); }
inline py::object one(double value) { return py::float_(value); }
inline py::object one(int value) { return py::int_(value); }
inline py::object one(std::uint32_t value) { return py::int_(value); }
inline py::object one(tricover::EdgeIndex value) { return py::int_(value); }
inline py::object one(tricover::BodyHandle value) { return py::cast(Body{value}); }
inline py::object one(const tricover::Vec2& value) { return arrayOf(value); }
inline py::object one(tricover::Touching value) { return py::cast(value); }
inline py::object one(tricover::Location value) { return py::cast(value); }
py::object one(const tricover::Contact& contact);
py::object one(const tricover::SelfCrossing& crossing);
/// Crossings are many as a rule: one tuple, of arrays.
py::object one(const std::vector<tricover::Crossing>& crossings);
template <typename Result, typename = decltype(Record<Result>::kName)>
py::object one(const Result& result) {
  return std::apply([&](auto... field) { return resultClass(Record<Result>::kName)(one(result.*field)...); },
                    Record<Result>::kFields);
}
/// None for nothing.
template <typename Result>
py::object one(const std::optional<Result>& result) {
  return result ? one(*result) : py::none();
}
template <typename Result>
py::object one(const std::vector<Result>& results) {
  py::list list;
  for (const Result& result : results) list.append(one(result));
  return std::move(list);
}

/// A column of a tuple of arrays: at(i) is a pointer to a value, or to nothing, which NaN, -1, False and NO_BODY stand
/// for.
template <typename Value, typename At>
py::object column(std::size_t count, const At& at) {
  if constexpr (std::is_same_v<Value, tricover::Vec2>) {
    const tricover::Vec2 none(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN());
    std::vector<tricover::Vec2> points(count);
    for (std::size_t i = 0; i < count; ++i) points[i] = at(i) ? *at(i) : none;
    return arrayOf(points);
  } else if constexpr (std::is_same_v<Value, double>) {
    return arrayOf<double>(count,
                           [&](std::size_t i) { return at(i) ? *at(i) : std::numeric_limits<double>::quiet_NaN(); });
  } else if constexpr (std::is_same_v<Value, bool>) {
    return arrayOf<bool>(count, [&](std::size_t i) { return at(i) && *at(i); });
  } else if constexpr (std::is_same_v<Value, tricover::BodyHandle>) {
    return arrayOf<Value>(count, [&](std::size_t i) { return at(i) ? *at(i) : tricover::kNoBody; });
  } else if constexpr (std::is_integral_v<Value>) {
    return arrayOf<Value>(count, [&](std::size_t i) { return at(i) ? *at(i) : Value(-1); });
  } else {
    return std::apply(
        [&](auto... field) {
          return resultClass(Record<Value>::kName)(column<std::decay_t<decltype(std::declval<Value>().*field)>>(
              count, [&, field](std::size_t i) { return at(i) ? &(at(i)->*field) : nullptr; })...);
        },
        Record<Value>::kFields);
  }
}

/// Arrays of many answers, or one tuple of arrays; lists of what is a list for one.
inline py::object many(const std::vector<char>& answers) {
  return arrayOf<bool>(answers.size(), [&](std::size_t i) { return answers[i] != 0; });
}
inline py::object many(const std::vector<double>& answers) {
  return arrayOf<double>(answers.size(), [&](std::size_t i) { return answers[i]; });
}
inline py::object many(const std::vector<tricover::Location>& answers) {
  return arrayOf<std::int8_t>(answers.size(), [&](std::size_t i) { return static_cast<int>(answers[i]); });
}
template <typename Result>
py::object many(const std::vector<std::vector<Result>>& answers) {
  return one(answers);
}
template <typename Result>
py::object many(const std::vector<std::optional<Result>>& answers) {
  return column<Result>(answers.size(), [&](std::size_t i) { return answers[i] ? &*answers[i] : nullptr; });
}
template <typename Result>
py::object many(const std::vector<Result>& answers) {
  return column<Result>(answers.size(), [&](std::size_t i) { return &answers[i]; });
}

/// How many queries some operands are, each given once or so many times.
class Count {
 public:
  template <typename Value>
  Count& of(const Many<Value>& operand, const char* name) {
    if (operand.is_one) return *this;
    if (!is_one_ && operand.values.size() != count_)
      throw std::invalid_argument(std::string(name) + ": there are " + std::to_string(operand.values.size()) +
                                  ", but of " + name_ + " " + std::to_string(count_));
    is_one_ = false, count_ = operand.values.size(), name_ = name;
    return *this;
  }

  /// The answers of query(i), which is called on threads while other Python threads run; `each` at least to a task.
  template <typename Query>
  py::object answers(std::size_t threads, std::size_t each, const Query& query) const {
    using Answer = decltype(query(std::size_t{}));
    if constexpr (std::is_same_v<Answer, bool>) {
      std::vector<char> found(count_);
      forEachInParallel(count_, threads, each, [&](std::size_t i) { found[i] = query(i); });
      return is_one_ ? one(found[0] != 0) : many(found);
    } else {
      std::vector<Answer> found(count_);
      forEachInParallel(count_, threads, each, [&](std::size_t i) { found[i] = query(i); });
      return is_one_ ? one(found[0]) : many(found);
    }
  }

 private:
  bool is_one_ = true;
  std::size_t count_ = 1;
  std::string name_;
};

/// How many queries a thread takes at once: of those below and above some microseconds.
constexpr std::size_t kCheap = 64, kDear = 1;

}  // namespace tricover_python
