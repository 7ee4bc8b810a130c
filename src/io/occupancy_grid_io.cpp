// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/occupancy_grid_io.h"

#include <filesystem>
#include <fstream>

#include "io/map_fields.h"
#include "io/map_image.h"
#include "numbers/errors.h"
#include "numbers/whole_file.h"

namespace tricover {

OccupancyMap readOccupancyMap(const std::string& yaml) {
  std::ifstream file, image_file;
  const detail::MapFields fields = detail::readMapFields(detail::openFile(file, yaml));
  const std::filesystem::path image = std::filesystem::path(yaml).parent_path() / fields.image;
  return detail::readMap(fields, detail::openFile(image_file, image.string()));
}

void writeOccupancyMap(const OccupancyMap& map, const std::string& yaml, const std::string& image) {
  using std::filesystem::path;
  const std::string ending = detail::modeOf(map.grid) == detail::MapMode::Scale ? ".png" : ".pgm";
  const std::string name = image.empty() ? path(yaml).stem().string() + ending : image;
  const path beside = path(yaml).parent_path() / name;
  if (beside.lexically_normal() == path(yaml).lexically_normal())
    detail::refuse("yaml", "'" + yaml + "' is the image, too", "end it in .yaml");
  const detail::MapFiles files = detail::writeMap(map, name);
  detail::WholeFile image_file(beside.string(), files.image), yaml_file(yaml, files.yaml);
  image_file.commit();
  yaml_file.commit();
}

std::optional<Polygon> outline(const OccupancyMap& map, const IsOccupied& is_occupied) {
  const std::optional<Polygon> in_grid = outline(map.grid, is_occupied);
  if (!in_grid) return std::nullopt;
  return in_grid->transformed(map.pose);
}

}  // namespace tricover
