// SPDX-License-Identifier: BSD-3-Clause
#include "reproduction.h"

#include <ios>
#include <sstream>

namespace tricover::support {
namespace {

std::string vertex(const Vec2& p) { return "{" + hex(p.x()) + ", " + hex(p.y()) + "}"; }

std::string polygonText(const char* name, const Polygon& polygon) {
  std::string text = std::string("const Polygon ") + name + "({";
  for (const Ring& ring : polygon.rings()) {
    text += &ring == &polygon.rings().front() ? "{" : ", {";
    for (std::size_t i = 0; i < ring.size(); ++i) text += (i == 0 ? "" : ", ") + vertex(ring[i]);
    text += "}";
  }
  text += std::string("}, FillRule::") + (polygon.fillRule() == FillRule::EvenOdd ? "EvenOdd" : "NonZero");
  return (polygon.isComplement() ? text.insert(text.find('('), " = Polygon") + ").complement();\n" : text + ");\n");
}

std::string poseText(const std::string& name, const Pose& pose) {
  std::string text = "Pose " + name + " = Pose::Identity();\n" + name + ".matrix().topRows<2>() << ";
  for (int i = 0; i < 6; ++i) text += (i == 0 ? "" : ", ") + hex(pose.matrix()(i / 3, i % 3));
  return text + ";\n";
}

}  // namespace

std::string hex(double value) {
  std::ostringstream out;
  out << std::hexfloat << value;
  return out.str();
}

std::string reproduction(const Case& c) {
  return polygonText("a", c.a) + poseText("pose_a", c.pose_a) + polygonText("b", c.b) + poseText("pose_b", c.pose_b);
}

std::string reproduction(const Polygon& polygon, const Vec2& point) {
  return polygonText("polygon", polygon) + "const Vec2 point" + vertex(point) + ";\n";
}

std::string reproduction(const char* name, const Motion& motion) {
  std::string text = poseText(std::string("start_") + name, motion.start);
  text += std::string("Motion ") + name + ";\n" + name + ".start = start_" + name + ";\n";
  const auto set = [&](const char* field, const std::string& value) {
    text += std::string(name) + "." + field + " = " + value + ";\n";
  };
  set("shift", "Vec2" + vertex(motion.shift));
  set("angle", hex(motion.angle));
  set("pivot", "Vec2" + vertex(motion.pivot));
  set("shift_2", "Vec2" + vertex(motion.shift_2));
  set("shift_3", "Vec2" + vertex(motion.shift_3));
  set("angle_2", hex(motion.angle_2));
  set("angle_3", hex(motion.angle_3));
  return text;
}

std::string reproduction(const MovingCase& c) {
  return reproduction({c.a, c.motion_a.start, c.b, c.motion_b.start}) + reproduction("motion_a", c.motion_a) +
         reproduction("motion_b", c.motion_b);
}

}  // namespace tricover::support
