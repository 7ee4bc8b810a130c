// SPDX-License-Identifier: BSD-3-Clause
// The chunks on the ranks of an MPI program. Rank 0 has the result file; whoever is done with a chunk gets the next
// one. When all have been given away, those that aren't back are given away again: a rank that is late holds nobody up.
#pragma once

#include <mpi.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "job.h"
#include "progress.h"
#include "result_file.h"

namespace configuration_space {

constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

/// Ranks but the first: messages are a chunk's number (kNone at first) and its bytes; answers the next number, kNone at
/// the end.
inline void work(const Job& job) {
  std::vector<char> message(sizeof kNone);
  std::uint64_t chunk = kNone;
  for (;;) {
    std::memcpy(message.data(), &chunk, sizeof chunk);
    MPI_Send(message.data(), static_cast<int>(message.size()), MPI_BYTE, 0, 0, MPI_COMM_WORLD);
    MPI_Recv(&chunk, sizeof chunk, MPI_BYTE, 0, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (chunk == kNone) return;
    const Bytes bytes = job.chunk(chunk);
    message.resize(sizeof chunk);
    message.insert(message.end(), bytes.begin(), bytes.end());
  }
}

/// All ranks must have read the same map, which may be another file on another machine, or have changed meanwhile.
inline void agreeOn(const Job& job) {
  std::string first = job.header();
  std::uint64_t size = first.size();
  MPI_Bcast(&size, sizeof size, MPI_BYTE, 0, MPI_COMM_WORLD);
  first.resize(size);
  MPI_Bcast(first.data(), static_cast<int>(size), MPI_BYTE, 0, MPI_COMM_WORLD);
  if (first != job.header()) throw std::runtime_error("the ranks have read different maps");
}

/// Rank 0: hands chunks out, and computes some itself while nobody asks.
class Dispatcher {
 public:
  Dispatcher(const Job& job, ResultFile& result)
      : job_(job), result_(result), message_(sizeof kNone + job.chunkBytes()) {
    MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  }

  void run(Progress& progress) {
    while (result_.missing() > 0) {
      if (answerOne()) continue;
      const std::uint64_t own = given_ < result_.left().size() ? next() : kNone;
      if (own != kNone)
        result_.write(own, job_.chunk(own));
      else
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      progress.show(result_.missing());
    }
  }

  /// Everybody goes home; called when the result is safe.
  void dismiss() {
    while (dismissed_ + 1 < ranks_)
      if (!answerOne()) std::this_thread::sleep_for(std::chrono::microseconds(200));
  }

 private:
  /// A chunk that isn't there, one that nobody has been given first.
  std::uint64_t next() {
    const std::vector<std::size_t>& left = result_.left();
    for (std::size_t i = 0; i < left.size(); ++i, ++given_)
      if (!result_.has(left[given_ % left.size()])) return left[given_++ % left.size()];
    return kNone;
  }

  /// Takes a rank's message, if there is one.
  bool answerOne() {
    int there = 0, bytes = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
    if (!there) return false;
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    MPI_Recv(message_.data(), bytes, MPI_BYTE, status.MPI_SOURCE, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    std::uint64_t chunk;
    std::memcpy(&chunk, message_.data(), sizeof chunk);
    if (chunk != kNone && result_.missing() > 0)
      result_.write(chunk, Bytes(message_.begin() + sizeof chunk, message_.begin() + bytes));
    const std::uint64_t answer = result_.missing() > 0 ? next() : kNone;
    if (answer == kNone) ++dismissed_;
    MPI_Send(&answer, sizeof answer, MPI_BYTE, status.MPI_SOURCE, 0, MPI_COMM_WORLD);
    return true;
  }

  const Job& job_;
  ResultFile& result_;
  std::vector<char> message_;
  std::size_t given_ = 0;
  int ranks_ = 1, dismissed_ = 0;
};

}  // namespace configuration_space
