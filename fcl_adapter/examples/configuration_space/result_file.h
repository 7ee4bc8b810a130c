// SPDX-License-Identifier: BSD-3-Clause
// A result that grows chunk by chunk, from which an interrupted run goes on.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "job.h"

namespace configuration_space {

/// Until it is complete, `path`.part: the header, every chunk at its place, and a byte a chunk that says whether it is
/// there. A chunk is written before its byte, so whatever ends the program, what is said to be there is. Complete, it
/// loses those bytes and becomes `path`.
class ResultFile {
 public:
  ResultFile(const Job& job, const std::string& path)
      : path_(path),
        part_(path + ".part"),
        begin_(job.header().size()),
        bytes_(job.chunkBytes()),
        there_(job.chunks()) {
    const std::size_t marks = begin_ + there_.size() * bytes_, size = marks + there_.size();
    std::error_code none;
    if (std::filesystem::file_size(part_, none) != size || none) {
      std::ofstream(part_, std::ios::binary) << job.header();
      std::filesystem::resize_file(part_, size);
    }
    file_.open(part_, std::ios::binary | std::ios::in | std::ios::out);
    std::string header(begin_, '\0');
    file_.read(header.data(), static_cast<std::streamsize>(begin_));
    if (header != job.header()) throw std::runtime_error(part_ + ": is of another job; remove it to begin anew");
    file_.seekg(static_cast<std::streamoff>(marks));
    file_.read(there_.data(), static_cast<std::streamsize>(there_.size()));
    check();
    for (std::size_t i = 0; i < there_.size(); ++i)
      if (!there_[i]) left_.push_back(i);
    missing_ = left_.size();
  }

  /// Chunks that weren't there when the file was opened.
  const std::vector<std::size_t>& left() const { return left_; }
  bool has(std::size_t chunk) const { return there_[chunk] != 0; }
  /// How many there aren't yet.
  std::size_t missing() const { return missing_; }

  void write(std::size_t chunk, const Bytes& bytes) {
    if (has(chunk)) return;  // by another rank
    put(begin_ + chunk * bytes_, bytes.data(), bytes.size());
    there_[chunk] = 1;
    put(begin_ + there_.size() * bytes_ + chunk, &there_[chunk], 1);
    --missing_;
  }

  void finish() {
    file_.close();
    std::filesystem::resize_file(part_, begin_ + there_.size() * bytes_);
    std::filesystem::rename(part_, path_);
  }

 private:
  void put(std::size_t at, const char* bytes, std::size_t count) {
    file_.seekp(static_cast<std::streamoff>(at));
    file_.write(bytes, static_cast<std::streamsize>(count));
    file_.flush();
    check();
  }
  void check() const {
    if (!file_) throw std::runtime_error("can't read or write " + part_);
  }

  std::string path_, part_;
  std::size_t begin_, bytes_;
  std::fstream file_;
  std::vector<char> there_;
  std::vector<std::size_t> left_;
  std::size_t missing_ = 0;
};

}  // namespace configuration_space
