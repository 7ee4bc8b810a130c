// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "numbers/errors.h"

namespace tricover::detail {

/// A file that appears whole or not at all: it has another name beside its path until commit().
class WholeFile {
 public:
  /// Writes the bytes under the other name.
  WholeFile(const std::string& path, const std::string& bytes) : path_(path), target_(path) {
    std::error_code error;
    const auto kind = std::filesystem::status(target_, error).type();
    if (kind != std::filesystem::file_type::not_found) {
      // A rename would put a plain file in the place of a device or a link.
      if (kind != std::filesystem::file_type::regular) refuse("it is no plain file");
      target_ = std::filesystem::canonical(target_, error);
      if (error) refuse(error.message());
    }
    std::FILE* const file = create();
    written_ = true;
    bool is_whole = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    int fault = errno;
    if (std::fclose(file) != 0 && is_whole) is_whole = false, fault = errno;  // of what was still to be written
    if (is_whole) return;
    remove();
    refuse(std::generic_category().message(fault));
  }
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile() { remove(); }

  /// Gives the file its name.
  void commit() {
    std::error_code error;
    std::filesystem::rename(part_, target_, error);
    if (error) refuse(error.message());
    written_ = false;
  }

 private:
  /// Opens a file that wasn't there.
  std::FILE* create() {
    constexpr int kMostNames = 100;  // beyond, something else is wrong than files that a crash has left
    for (int i = 0; i < kMostNames; ++i) {
      part_ = target_;
      part_ += ".part" + std::to_string(i);
      errno = 0;
      if (std::FILE* file = std::fopen(part_.string().c_str(), "wbx")) return file;
      if (errno != EEXIST) break;
    }
    refuse(std::generic_category().message(errno));
  }
  void remove() {
    std::error_code ignored;
    if (written_) std::filesystem::remove(part_, ignored);
    written_ = false;
  }
  [[noreturn]] void refuse(const std::string& wrong) const {
    throw std::runtime_error(refusal(path_, "can't be written: " + wrong));
  }

  std::string path_;
  std::filesystem::path target_, part_;
  bool written_ = false;  ///< under the other name
};

/// Writes a file whole or not at all.
inline void writeWhole(const std::string& path, const std::string& bytes) { WholeFile(path, bytes).commit(); }

}  // namespace tricover::detail
