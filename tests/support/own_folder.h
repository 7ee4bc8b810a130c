// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace tricover::support {

/// A folder that no other test has, nor the same one in another build. It goes with all that is in it.
class OwnFolder {
 public:
  OwnFolder() : path_(testing::TempDir() + "tricover_XXXXXX") {
    if (!mkdtemp(path_.data())) throw std::runtime_error("no folder of my own in " + testing::TempDir());
    path_ += '/';
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  /// It ends in '/'.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace tricover::support
