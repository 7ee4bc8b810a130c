// SPDX-License-Identifier: BSD-3-Clause
// A result that grows chunk by chunk, from which an interrupted run goes on. POSIX files.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "job.h"

namespace configuration_space {

/// Until it is complete, `path`.part: the header, every chunk at its place, and a byte a chunk that says whether it is
/// there. A chunk is written before its byte, so whenever the program is killed, what is said to be there is. Complete,
/// it loses those bytes and becomes `path`. It is locked as long as this object lives. What is of another job, or is no
/// result, is never written over.
class ResultFile {
 public:
  ResultFile(const Job& job, const std::string& path)
      : path_(path),
        part_(path + ".part"),
        begin_(job.header().size()),
        bytes_(job.chunkBytes()),
        there_(job.chunks()) {
    const std::size_t marks = begin_ + there_.size() * bytes_, size = marks + there_.size();
    if (isDone(job, marks)) return;
    openLocked();
    const std::size_t found = sizeOf(part_);
    std::string header(std::min(begin_, found), '\0');
    get(0, header.data(), header.size());
    if (found <= size &&
        header.find_first_not_of('\0') == std::string::npos)  // new, or killed before it said what it is
      begin(job, size, found == 0);
    else if (header != job.header() || (found != size && found != marks))
      throw std::runtime_error(part_ + ": is of another job; remove it to begin anew");
    else if (found == size)
      get(marks, there_.data(), there_.size());
    else  // killed between finish()'s two steps
      there_.assign(there_.size(), 1);
    for (std::size_t i = 0; i < there_.size(); ++i)
      if (!there_[i]) left_.push_back(i);
    missing_ = left_.size();
  }
  ~ResultFile() {
    if (file_ >= 0) close(file_);
  }
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  /// Chunks that weren't there when the file was opened.
  const std::vector<std::size_t>& left() const { return left_; }
  bool has(std::size_t chunk) const { return there_[chunk] != 0; }
  /// How many there aren't yet.
  std::size_t missing() const { return missing_; }

  void write(std::size_t chunk, const Bytes& bytes) {
    if (has(chunk)) return;  // by another rank
    put(begin_ + chunk * bytes_, bytes.data(), bytes.size());
    const char mark = 1;
    put(begin_ + there_.size() * bytes_ + chunk, &mark, 1);
    there_[chunk] = mark;
    --missing_;
  }

  void finish() {
    if (file_ < 0) return;
    if (ftruncate(file_, static_cast<off_t>(begin_ + there_.size() * bytes_)) != 0 || fsync(file_) != 0)
      fail("finish", errno);
    std::filesystem::rename(part_, path_);
  }

 private:
  /// Makes room for everything, so that a disk is full now or never.
  void begin(const Job& job, std::size_t size, bool is_new) {
    if (const int error = posix_fallocate(file_, 0, static_cast<off_t>(size))) {
      if (is_new) unlink(part_.c_str());
      fail("make room for " + std::to_string(size) + " bytes in", error);
    }
    put(0, job.header().data(), begin_);
  }

  /// Whether an earlier run of this job has finished.
  bool isDone(const Job& job, std::size_t size) {
    if (!std::filesystem::exists(path_)) return false;
    std::string header(begin_, '\0');
    file_ = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    if (file_ < 0) fail("read", errno, path_);
    const bool has_size = sizeOf(path_) == size;
    if (has_size) get(0, header.data(), begin_);
    close(std::exchange(file_, -1));
    if (!has_size || header != job.header())
      throw std::runtime_error(path_ + ": is no result of this job; remove it, or name another one");
    there_.assign(there_.size(), 1);
    return true;
  }

  /// The file stays the part's while nobody else holds it: who held it before may have renamed it meanwhile.
  void openLocked() {
    struct stat opened, named;
    do {
      if (file_ >= 0) close(file_);
      file_ = open(part_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (file_ < 0) fail("write", errno);
      if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK) fail("lock", errno);
        throw std::runtime_error(part_ + ": another run writes it; wait for that, or end it");
      }
    } while (fstat(file_, &opened) != 0 || stat(part_.c_str(), &named) != 0 || opened.st_ino != named.st_ino);
  }

  std::size_t sizeOf(const std::string& path) const {
    struct stat found;
    if (fstat(file_, &found) != 0) fail("read", errno, path);
    return static_cast<std::size_t>(found.st_size);
  }
  void put(std::size_t at, const char* bytes, std::size_t count) {
    while (count > 0) {
      const ssize_t written = pwrite(file_, bytes, count, static_cast<off_t>(at));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail("write", errno);
      at += static_cast<std::size_t>(written), bytes += written, count -= static_cast<std::size_t>(written);
    }
  }
  void get(std::size_t at, char* bytes, std::size_t count) {
    while (count > 0) {
      const ssize_t read = pread(file_, bytes, count, static_cast<off_t>(at));
      if (read < 0 && errno == EINTR) continue;
      if (read <= 0) fail("read", errno);
      at += static_cast<std::size_t>(read), bytes += read, count -= static_cast<std::size_t>(read);
    }
  }
  [[noreturn]] void fail(const std::string& what, int error) const { fail(what, error, part_); }
  [[noreturn]] void fail(const std::string& what, int error, const std::string& path) const {
    throw std::runtime_error("can't " + what + " " + path + ": " + std::generic_category().message(error));
  }

  std::string path_, part_;
  std::size_t begin_, bytes_;
  int file_ = -1;
  std::vector<char> there_;
  std::vector<std::size_t> left_;
  std::size_t missing_ = 0;
};

}  // namespace configuration_space
