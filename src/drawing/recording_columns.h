// SPDX-License-Identifier: BSD-3-Clause
// What a recording's page reads: columns of numbers and texts, each from its begin to its end. recording_page.cpp has
// the reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tricover/pose.h"

namespace tricover::detail {

class RecordingColumns {
 public:
  void real(double value);
  void real(const Vec2& value);
  void real(const Eigen::Matrix2d& value);  ///< Row by row.
  void count(std::size_t value);            ///< Below 2^32.
  void text(const std::string& value) { texts_.push_back(value); }
  /// A float, to 2^-24 of itself, and within the range of floats.
  void single(double value);
  /// Many values, to 2^-24 of the largest difference between two of them; one double if all are equal. NaN stays NaN.
  void values(const std::vector<double>& values);

  /// A JSON object. It is safe within a script element.
  std::string json(const std::string& title) const;

 private:
  std::string reals_, singles_, counts_;  ///< Bytes, little-endian.
  std::vector<std::string> texts_;
};

/// A power of two of which no value between -largest and largest is more than one: floats neither overflow nor
/// underflow there.
double unitOf(double largest);

}  // namespace tricover::detail
