// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_file.h"

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "io/parts.h"

namespace tricover::detail {

std::string readText(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) refuseFile(path, "can't be read: " + error.message());
  std::ifstream file(path, std::ios::binary);
  if (!file) refuseFile(path, "can't be opened", "check its permissions");
  std::string text(static_cast<std::size_t>(size), '\0');
  file.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

void writeText(const std::string& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) refuseFile(path, "can't be written: " + std::generic_category().message(errno));
}

}  // namespace tricover::detail
