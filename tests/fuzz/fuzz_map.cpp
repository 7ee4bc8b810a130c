// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a map's YAML file and image: a map or std::runtime_error, never anything else. A map that is read is written
// and read again to the same. Checksums of PNG chunks are made right, so that what they guard is reached.
//
// The first two bytes are the length of the YAML text; without one, fields of the next byte's kind are taken.
#include <png.h>

#include <algorithm>
#include <cstdint>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

#include "byte_reader.h"
#include "io/map_fields.h"
#include "io/map_image.h"

namespace {

using namespace tricover;

std::uint32_t checksum(const char* bytes, std::size_t count) {
  std::uint32_t sum = 0xffffffff;
  for (std::size_t i = 0; i < count; ++i) {
    sum ^= static_cast<unsigned char>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? 0xedb88320 ^ sum >> 1 : sum >> 1;
  }
  return ~sum;
}

/// Gives each whole chunk of a PNG file its checksum.
void mend(std::string& png) {
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = png_get_uint_32(reinterpret_cast<png_const_bytep>(&png[at]));
    if (length > png.size() - at - 12) return;
    png_save_uint_32(reinterpret_cast<png_bytep>(&png[at + 8 + length]), checksum(&png[at + 4], length + 4));
    at += 12 + length;
  }
}

OccupancyMap read(const std::string& yaml, const std::string& image) {
  std::istringstream yaml_in(yaml), image_in(image);
  yaml_in.imbue(std::locale::classic());
  image_in.imbue(std::locale::classic());
  return detail::readMap(detail::readMapFields({yaml_in, yaml.size(), "yaml"}), {image_in, image.size(), "image"});
}

std::string anyFields(unsigned kind) {
  const char* modes[] = {"trinary", "scale", "raw", "Scale"};
  return std::string("image: a\nresolution: 0.1\norigin: [1, 2, 0.5]\nmode: ") + modes[kind % 4] +
         "\nnegate: " + (kind & 4 ? "1" : "0") + "\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

/// Poses that are read may be of a yaw beyond pi, which comes back within 1e-12.
void checkSame(const OccupancyMap& map, const OccupancyMap& again) {
  if (map.grid.cells != again.grid.cells || map.grid.width != again.grid.width ||
      map.grid.resolution != again.grid.resolution || map.pose.translation() != again.pose.translation() ||
      !((map.pose.linear() - again.pose.linear()).cwiseAbs().maxCoeff() <= 1e-12))
    fuzz::fail("a map that was written is read as another one", "");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  if (size < 3) return 0;
  const std::size_t length = std::size_t{256} * data[0] + data[1];
  const std::string yaml = length > 0 ? bytes.substr(2, length) : anyFields(data[2]);
  std::string image = length > 0 ? bytes.substr(std::min(size, 2 + length)) : bytes.substr(3);
  if (!image.empty() && static_cast<unsigned char>(image[0]) == 0x89) mend(image);
  try {
    const OccupancyMap map = read(yaml, image);
    for (const char* name : {"a.png", "a.pgm"}) {
      detail::MapFiles files;
      try {
        files = detail::writeMap(map, name);
      } catch (const std::invalid_argument&) {
        if (name == std::string("a.png")) throw;
        continue;  // unknown cells among grades
      }
      checkSame(map, read(files.yaml, files.image));
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
