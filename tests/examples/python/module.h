// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>
#include <tricover/tricover.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace tricover_python {

namespace py = pybind11;

/// Results are named tuples of numbers and arrays.
class Records {
 public:
  explicit Records(py::module_& m);

  py::object of(const tricover::DistanceResult& result) const;
  /// One tuple, of arrays.
  py::object of(const std::vector<tricover::DistanceResult>& results) const;
  py::object of(const tricover::Penetration& result) const;
  py::object of(const tricover::Contact& contact) const;
  py::object of(const tricover::Impact& impact) const;
  py::object of(const tricover::Conflict& conflict) const;
  py::object of(const tricover::BodyOptions& options) const;
  py::object of(const tricover::RayHit& hit) const;
  py::object of(const tricover::RayInterval& interval) const;
  py::object of(const tricover::SignedDistance& result) const;
  py::object of(const tricover::LeastDistance& result) const;
  /// None for nothing.
  template <typename Result>
  py::object of(const std::optional<Result>& result) const {
    return result ? of(*result) : py::none();
  }

 private:
  py::object distance_, penetration_, contact_, impact_, conflict_, ray_hit_, body_options_, ray_interval_,
      signed_distance_, least_distance_;
};

/// A body's handle. Python sees an int of the class Body.
struct Body {
  tricover::BodyHandle handle;
};

/// Categories of bodies. A Body is none, though it is an int, too.
struct Mask {
  std::uint32_t bits;
};

void definePairs(py::module_& m, const Records& records);
void defineMotions(py::module_& m, const Records& records);
void defineScene(py::module_& m, const Records& records);

}  // namespace tricover_python

namespace pybind11::detail {

template <>
struct type_caster<tricover_python::Body> {
  PYBIND11_TYPE_CASTER(tricover_python::Body, const_name("tricover.Body"));
  bool load(handle given, bool converts) {
    make_caster<tricover::BodyHandle> number;
    if (!number.load(given, converts)) return false;
    value = {number};
    return true;
  }
  static handle cast(const tricover_python::Body& body, return_value_policy, handle) {
    return module_::import("tricover").attr("Body")(body.handle).release();
  }
};

template <>
struct type_caster<tricover_python::Mask> {
  PYBIND11_TYPE_CASTER(tricover_python::Mask, const_name("int"));
  bool load(handle given, bool converts) {
    if (isinstance(given, module_::import("tricover").attr("Body")))
      throw type_error("a mask or category is wanted, not a body's handle: leave out a body by ignored=body");
    make_caster<std::uint32_t> number;
    if (!number.load(given, converts)) return false;
    value = {number};
    return true;
  }
};

}  // namespace pybind11::detail
