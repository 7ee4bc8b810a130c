// SPDX-License-Identifier: BSD-3-Clause
#include "python/ways.h"

namespace tricover_python {
namespace {

/// A list whose items are all of the type of the first one.
template <typename Moving>
Many<Moving> listOf(const py::sequence& given, const std::string& name, const char* type) {
  Many<Moving> result{{}, false};
  for (const py::handle one : given) {
    if (!py::isinstance<Moving>(one))
      throw py::type_error(name + "[" + std::to_string(result.values.size()) + "]: it is no " + type +
                           ", as the first one is");
    result.values.push_back(one.cast<Moving>());
  }
  return result;
}

}  // namespace

Way wayFrom(const py::object& given, const std::string& name) {
  if (py::isinstance<tricover::Motion>(given)) return {{{given.cast<tricover::Motion>()}, true}, {}, false};
  if (py::isinstance<tricover::Trajectory>(given)) return {{}, {{given.cast<tricover::Trajectory>()}, true}, false};
  if ((py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) && py::len(given) > 0) {
    const py::object first = given[py::int_(0)];
    if (py::isinstance<tricover::Motion>(first)) return {listOf<tricover::Motion>(given, name, "Motion"), {}, false};
    if (py::isinstance<tricover::Trajectory>(first))
      return {{}, listOf<tricover::Trajectory>(given, name, "Trajectory"), false};
  }
  return {{{tricover::Motion::still(onePose(given, name))}, true}, {}, true};
}

void makeAlike(Way& a, Way& b, const char* name_a, const char* name_b) {
  const auto other = [](Way& way, const char* name) {
    if (!way.stays)
      throw py::type_error(std::string(name) +
                           ": it is a Motion, and the other one is a Trajectory; make one of it by " +
                           "Trajectory([(begin, end, motion)])");
    way.trajectories = {{tricover::Trajectory(way.motions[0].start)}, true};
  };
  if (!a.trajectories.values.empty() && b.trajectories.values.empty()) other(b, name_b);
  if (a.trajectories.values.empty() && !b.trajectories.values.empty()) other(a, name_a);
}

void requireOne(const Way& way, const std::string& name) {
  if (!way.motions.is_one || !way.trajectories.is_one)
    throw std::invalid_argument(name + ": one motion or trajectory is wanted, not a list of them");
}

Many<double> timesFrom(const py::object& given, const std::string& name) {
  const Array times = numbersFrom(given, name);
  if (times.ndim() > 1)
    throw std::invalid_argument(name + ": it must be a number or have the shape (n,), not " + shapeOf(times));
  return {{times.data(), times.data() + times.size()}, times.ndim() == 0};
}

}  // namespace tricover_python
