// SPDX-License-Identifier: BSD-3-Clause
// The scene of robot_in_map.cpp and planner_ompl.cpp: the Baltic, a ship that turns in it, and others at anchor.
#pragma once

#include <tricover/polygon.h>

#include <vector>

namespace baltic {

/// The map's sheet, with the sea as a hole in it and Zealand in the sea: coasts of Natural Earth 1:110m (public
/// domain), in km from 18 E, 59.5 N, x to the east.
inline const tricover::Polygon& land() {
  static const tricover::Ring sheet = {{-700, -700}, {700, -700}, {700, 780}, {-700, 780}};
  static const tricover::Ring sea = {
      {-425, -197}, {-427, -254}, {-444, -290}, {-437, -321}, {-406, -338}, {-420, -380}, {-437, -368}, {-478, -448},
      {-463, -502}, {-462, -545}, {-404, -571}, {-404, -611}, {-346, -590}, {-314, -559}, {-249, -603}, {-222, -639},
      {-183, -606}, {-94, -555},  {-22, -517},  {36, -536},   {40, -563},   {95, -564},   {108, -515},  {187, -479},
      {175, -386},  {177, -302},  {205, -232},  {259, -194},  {305, -277},  {351, -275},  {362, -190},  {368, -124},
      {347, -138},  {311, -99},   {306, -35},   {378, -4},    {450, 12},    {512, -6},    {572, -3},    {637, 59},
      {577, 112},   {473, 103},   {372, 62},    {279, 38},    {246, 99},    {190, 136},   {203, 245},   {175, 345},
      {203, 410},   {255, 480},   {385, 601},   {424, 624},   {418, 671},   {338, 724},   {239, 692},   {184, 614},
      {193, 546},   {102, 457},   {-9, 361},    {-50, 205},   {-10, 126},   {45, 65},     {-8, -61},    {-67, -87},
      {-89, -273},  {-121, -378}, {-191, -367}, {-223, -455}, {-290, -460}, {-308, -355}, {-356, -229}, {-399, -72},
      {-438, -3},   {-551, -132}, {-627, -158}, {-627, -664}, {-566, -664}, {-527, -609}, {-540, -568}, {-543, -505},
      {-566, -443}, {-568, -329}, {-558, -299}, {-542, -266}, {-491, -259}, {-471, -228}};
  static const tricover::Ring zealand = {{-322, -377}, {-304, -433}, {-338, -523}, {-398, -460}, {-406, -414}};
  static const tricover::Polygon polygon({sheet, sea, zealand});
  return polygon;
}

/// A floating dock, open at its bow; not to scale.
inline const tricover::Polygon& ship() {
  static const tricover::Polygon polygon(
      {{{-20, -9}, {20, -9}, {20, -5}, {-14, -5}, {-14, 5}, {20, 5}, {20, 9}, {-20, 9}}});
  return polygon;
}

struct Berth {
  double x, y, angle;
};

/// Where other such ships lie at anchor.
inline const std::vector<Berth>& anchored() {
  static const std::vector<Berth> berths = {{90, 330, 0.4},   {60, 130, 1.8},   {180, -20, 2.9},   {60, -160, 0.9},
                                            {100, -330, 2.2}, {-40, -400, 1.2}, {-150, -480, 0.3}, {-500, -170, 2.5},
                                            {-450, -60, 1.4}, {460, 60, 0.1}};
  return berths;
}

}  // namespace baltic
