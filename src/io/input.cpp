// SPDX-License-Identifier: BSD-3-Clause
#include "io/input.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <locale>
#include <stdexcept>
#include <system_error>

#include "numbers/errors.h"

namespace tricover::detail {

void refuseFile(const std::string& file, const std::string& wrong, const std::string& instead) {
  throw std::runtime_error(refusal(file, wrong, instead));
}

Input openFile(std::ifstream& file, const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) refuseFile(path, "can't be read: " + error.message());
  file.open(path, std::ios::binary);
  if (!file) refuseFile(path, "can't be opened", "check its permissions");
  file.imbue(std::locale::classic());
  return {file, size, path};
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string readText(const std::string& path) {
  std::ifstream file;
  const Input input = openFile(file, path);
  std::string text(static_cast<std::size_t>(input.size), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

}  // namespace tricover::detail
