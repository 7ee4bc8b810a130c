// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>

namespace tricover::detail {

/// Some elements of a vector, in a row.
template <typename T>
class Slice {
 public:
  Slice() = default;
  Slice(T* begin, std::size_t size) : begin_(begin), size_(size) {}

  const T* begin() const { return begin_; }
  const T* end() const { return begin_ + size_; }
  const T& operator[](std::size_t k) const { return begin_[k]; }
  const T& front() const { return *begin_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// To be filled: first so many more are counted, then they get a place, of which the end is returned, then they come.
  void count(std::size_t more) { size_ += more; }
  T* place(T* begin) {
    begin_ = begin;
    return begin + std::exchange(size_, 0);
  }
  void push(const T& element) { begin_[size_++] = element; }

 private:
  T* begin_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace tricover::detail
