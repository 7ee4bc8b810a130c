// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tricover/svg.h>

#include <fstream>
#include <stdexcept>
#include <string>

/// Throws where the file can't be written, all of it.
inline void savePicture(const tricover::SvgDrawing& drawing, const std::string& path) {
  std::ofstream file(path);
  file << drawing.str();
  file.close();
  if (!file) throw std::runtime_error("can't write " + path);
}
