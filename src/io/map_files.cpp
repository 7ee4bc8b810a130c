// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "io/map_image.h"
#include "numbers/errors.h"
#include "polygon/grid_corners.h"

namespace tricover::detail {
namespace {

/// How far an entry of the pose that is read may be from the one that was written.
constexpr double kYawTolerance = 1e-12;

const std::string kAboveMost = ", more than 2^28 in all", kCutIt = "cut it into several maps";

std::string sizeOf(std::size_t width, std::size_t height) {
  return "has " + std::to_string(width) + " x " + std::to_string(height) + " cells";
}

bool isPng(const Input& image) {
  const bool found = image.in.peek() == 0x89;
  image.in.clear();  // of the end of an empty file
  return found;
}

/// The yaw that poseAt() makes this rotation of, or else the nearest one.
double yawOf(const Pose& pose) {
  const auto off = [&](double yaw) { return (poseAt(0, 0, yaw).linear() - pose.linear()).cwiseAbs().maxCoeff(); };
  const double nearest = std::atan2(pose(1, 0), pose(0, 0));
  constexpr int kMostSteps = 8;  // of an ulp: atan2, cos and sin err by less than one each
  double low = nearest, high = nearest;
  for (int i = 0; i <= kMostSteps; ++i) {
    for (const double yaw : {low, high})
      if (off(yaw) == 0) return yaw;
    low = std::nextafter(low, -4.0);
    high = std::nextafter(high, 4.0);
  }
  if (!(off(nearest) <= kYawTolerance))
    refuse("pose", "no yaw gives its rotation within " + std::to_string(kYawTolerance),
           "tricover::nearestRigid() makes it a rotation");
  return nearest;
}

void checkGrid(const OccupancyGrid& grid) {
  if (grid.width < 1 || grid.height < 1 || grid.width > kMostPixels || grid.height > kMostPixels)
    refuse("grid", "it " + sizeOf(grid.width, grid.height) + ", not 1 x 1 to 65535 x 65535");
  if (grid.width * grid.height > kMostCells)
    refuse("grid", "it " + sizeOf(grid.width, grid.height) + kAboveMost, kCutIt);
  checkCells(grid);
  if (!std::isfinite(grid.resolution)) refuse("resolution", "it must be positive and finite");
  if (grid.origin != Vec2(0, 0))
    refuse("origin", "the grid's own is not (0, 0), and the file has no field for it", "move the map's pose instead");
}

[[noreturn]] void refuseCell(const OccupancyGrid& grid, std::size_t cell, const std::string& wrong,
                             const std::string& instead = {}) {
  refuse("cells",
         "cell " + std::to_string(cell) + " (column " + std::to_string(cell % grid.width) + ", row " +
             std::to_string(cell / grid.width) + ") is " + std::to_string(grid.cells[cell]) + wrong,
         instead);
}

/// The first cell that fits, or else the number of cells.
template <typename Fits>
std::size_t firstCell(const OccupancyGrid& grid, const Fits& fits) {
  return static_cast<std::size_t>(std::find_if(grid.cells.begin(), grid.cells.end(), fits) - grid.cells.begin());
}

}  // namespace

void checkSize(const Input& image, std::size_t width, std::size_t height) {
  if (width * height > kMostCells) refuseFile(image.name, sizeOf(width, height) + kAboveMost, kCutIt);
}

OccupancyMap readMap(const MapFields& fields, const Input& image) {
  OccupancyMap map;
  map.pose = fields.pose;
  map.grid.resolution = fields.resolution;
  (isPng(image) ? readPng : readPgm)(image, fields, map.grid);
  return map;
}

MapMode modeOf(const OccupancyGrid& grid) {
  const auto isGraded = [](std::int8_t value) { return value > kFreeCell && value < kOccupiedCell; };
  return firstCell(grid, isGraded) < grid.cells.size() ? MapMode::Scale : MapMode::Trinary;
}

MapFiles writeMap(const OccupancyMap& map, const std::string& image) {
  const OccupancyGrid& grid = map.grid;
  checkGrid(grid);
  checkPose(map.pose);
  if (map.pose.linear().determinant() < 0)
    refuse("pose", "it mirrors, which no yaw does", "reverse the rows of cells and the pose's second column");
  const std::string ending = lowered(std::filesystem::path(image).extension().string());
  const bool is_png = ending == ".png";
  if (!is_png && ending != ".pgm") refuse("image", "'" + image + "' ends in neither .pgm nor .png");

  const std::size_t none = grid.cells.size();
  const std::size_t odd = firstCell(grid, [](std::int8_t value) { return value < -1 || value > 100; });
  if (odd < none) refuseCell(grid, odd, ", not from -1 to 100");
  CellGreys greys{modeOf(grid), false};
  const std::size_t unknown = firstCell(grid, [](std::int8_t value) { return value == kUnknownCell; });
  greys.is_transparent = greys.mode == MapMode::Scale && unknown < none;
  if (greys.is_transparent && !is_png)
    refuseCell(grid, unknown, ", and a PGM image keeps no unknown cells beside ones from 1 to 99", "write a PNG image");

  MapFields fields{image, greys.mode, grid.resolution, map.pose};
  fields.occupied_thresh = greys.mode == MapMode::Scale ? 1 : 0.65;
  fields.free_thresh = greys.mode == MapMode::Scale ? 0 : 0.196;
  return {writeMapFields(fields, yawOf(map.pose)), is_png ? writePng(grid, greys) : writePgm(grid, greys)};
}

}  // namespace tricover::detail
