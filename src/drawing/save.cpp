// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/save.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "numbers/errors.h"

namespace tricover::detail {
namespace {

bool write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return static_cast<bool>(file);
}

}  // namespace

void saveText(const std::string& path, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  bool is_written = false;
  if (fs::exists(status) && !fs::is_regular_file(status)) {  // a device or a pipe is written to; a folder can't be
    is_written = write(path, text);
  } else {
    const fs::path target = fs::is_symlink(path, error) ? fs::canonical(path, error) : fs::path(path);
    fs::path part = target;
    part += ".part";
    is_written = write(part, text);
    error.clear();
    if (is_written) fs::rename(part, target, error);
    if (!is_written || error) {
      is_written = false;
      fs::remove(part, error);
    }
  }
  if (!is_written)
    throw std::runtime_error(refusal(path, "it can't be written", "give a file in a folder that exists"));
}

}  // namespace tricover::detail
