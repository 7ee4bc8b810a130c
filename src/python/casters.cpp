// SPDX-License-Identifier: BSD-3-Clause
#include "python/casters.h"

namespace tricover_python {
namespace {

/// An attribute of a module that is imported once. The dictionary is never destroyed: the interpreter may be gone then.
py::object attributeOf(const char* module, const char* name) {
  static py::dict* const known = new py::dict;
  if (!known->contains(name)) (*known)[name] = py::module_::import(module).attr(name);
  return (*known)[name];
}

}  // namespace

py::object resultClass(const char* name) { return attributeOf("tricover", name); }
py::object enumClass(const char* name) { return attributeOf("tricover._enums", name); }

int memberOf(py::handle given, const char* enumeration) {
  const py::object type = enumClass(enumeration);
  if (!py::isinstance(given, type)) {
    std::string members;
    for (const py::handle member : type)
      members += (members.empty() ? "" : ", ") + py::str(member.attr("name")).cast<std::string>();
    throw py::type_error(std::string("a member of ") + enumeration + " is wanted (" + members + "), not " +
                         py::repr(given).cast<std::string>());
  }
  return py::int_(py::reinterpret_borrow<py::object>(given)).cast<int>();
}

std::string noPolygon(py::handle given) {
  const std::string type = py::str(py::type::handle_of(given).attr("__name__")).cast<std::string>();
  if (py::hasattr(given, "__geo_interface__"))
    return "a tricover.Polygon is wanted, not a " + type + ": make one of it first, once, by tricover.Polygon(it)";
  if (py::isinstance<py::sequence>(given) || py::hasattr(given, "__array__"))
    return "a tricover.Polygon is wanted, not a " + type +
           ": make one of its vertices by tricover.Polygon(vertices); " +
           "the order of arguments is a, pose_a, b, pose_b";
  return "a tricover.Polygon is wanted, not a " + type;
}

}  // namespace tricover_python
