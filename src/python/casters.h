// SPDX-License-Identifier: BSD-3-Clause
// How Python's objects become tricover's and the other way round. Errors say what to write instead.
#pragma once

#include <pybind11/pybind11.h>
#include <tricover/tricover.h>

#include <cstdint>
#include <string>

namespace tricover_python {

namespace py = pybind11;

/// A body's handle. Python sees an int of the class Body.
struct Body {
  tricover::BodyHandle handle;
};

/// Categories of bodies. A Body is none, though it is an int, too.
struct Mask {
  std::uint32_t bits;
};

/// A polygon that is an argument. Anything else is an error that says how to make a Polygon.
struct Shape {
  const tricover::Polygon* polygon = nullptr;
  operator const tricover::Polygon&() const { return *polygon; }
};

/// A class of tricover._results or _scene_results, or an enumeration of tricover._enums.
py::object resultClass(const char* name);
py::object enumClass(const char* name);
/// The number of an enumeration's member.
/// \throws py::type_error for anything else
int memberOf(py::handle given, const char* enumeration);
/// Why an object is no polygon, and what to do.
std::string noPolygon(py::handle given);

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
    return tricover_python::resultClass("Body")(body.handle).release();
  }
};

template <>
struct type_caster<tricover_python::Mask> {
  PYBIND11_TYPE_CASTER(tricover_python::Mask, const_name("int"));
  bool load(handle given, bool converts) {
    if (isinstance(given, tricover_python::resultClass("Body")))
      throw type_error("a mask or category is wanted, not a body's handle: leave out a body by ignored=body");
    make_caster<std::uint32_t> number;
    if (!number.load(given, converts)) return false;
    value = {number};
    return true;
  }
};

template <>
struct type_caster<tricover_python::Shape> {
  PYBIND11_TYPE_CASTER(tricover_python::Shape, const_name("tricover.Polygon"));
  bool load(handle given, bool) {
    if (!isinstance<tricover::Polygon>(given)) throw type_error(tricover_python::noPolygon(given));
    value = {given.cast<const tricover::Polygon*>()};
    return true;
  }
};

// Enumerations are IntEnums, so that arrays of their numbers compare with members.
#define TRICOVER_PYTHON_ENUM(scope, Name)                                           \
  template <>                                                                       \
  struct type_caster<scope::Name> {                                                 \
    PYBIND11_TYPE_CASTER(scope::Name, const_name("tricover." #Name));               \
    bool load(handle given, bool) {                                                 \
      value = static_cast<scope::Name>(tricover_python::memberOf(given, #Name));    \
      return true;                                                                  \
    }                                                                               \
    static handle cast(scope::Name member, return_value_policy, handle) {           \
      return tricover_python::enumClass(#Name)(static_cast<int>(member)).release(); \
    }                                                                               \
  }
TRICOVER_PYTHON_ENUM(tricover, ContactDetail);
TRICOVER_PYTHON_ENUM(tricover, FillRule);
TRICOVER_PYTHON_ENUM(tricover, Location);
TRICOVER_PYTHON_ENUM(tricover, SelfCrossingKind);
TRICOVER_PYTHON_ENUM(tricover, Simplify);
TRICOVER_PYTHON_ENUM(tricover, Touching);
TRICOVER_PYTHON_ENUM(tricover::paper, InfluenceKind);
#undef TRICOVER_PYTHON_ENUM

}  // namespace pybind11::detail
