// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/recording_columns.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "numbers/errors.h"

namespace tricover::detail {
namespace {

/// Appends the bytes of a number, the lowest first on every machine.
template <typename Bits, typename Number>
void append(std::string& bytes, Number number) {
  static_assert(sizeof(Bits) == sizeof(Number), "the bits of this number");
  Bits bits;
  std::memcpy(&bits, &number, sizeof bits);
  for (std::size_t i = 0; i < sizeof bits; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xff);
}

std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j) bits = bits << 8 | (j < there ? static_cast<unsigned char>(bytes[i + j]) : 0);
    for (std::size_t j = 0; j < 4; ++j) result += j <= there ? digits[bits >> (18 - 6 * j) & 63] : '=';
  }
  return result;
}

/// '<' is escaped, too: "</script>" or "<!--" in a text would end the element around it, or change how it is read.
std::string quoted(const std::string& text) {
  static const char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == '<')
      result += std::string("\\u00") + digits[c >> 4 & 15] + digits[c & 15];
    else
      result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return result + '"';
}

}  // namespace

double unitOf(double largest) {
  if (!(largest > 0)) return 1;
  int exponent = 0;
  std::frexp(std::min(largest, std::numeric_limits<double>::max()), &exponent);
  return std::ldexp(1.0, std::min(std::max(exponent, -1000), 1023));
}

void RecordingColumns::real(double value) { append<std::uint64_t>(reals_, value); }

void RecordingColumns::real(const Vec2& value) {
  real(value.x());
  real(value.y());
}

void RecordingColumns::real(const Eigen::Matrix2d& value) {
  real(Vec2(value.row(0)));
  real(Vec2(value.row(1)));
}

void RecordingColumns::count(std::size_t value) {
  if (value > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error(refusal("recording", "it has 2^32 things of a kind", "record less"));
  append<std::uint32_t>(counts_, static_cast<std::uint32_t>(value));
}

void RecordingColumns::single(double value) {
  const double most = std::numeric_limits<float>::max();
  append<std::uint32_t>(singles_, static_cast<float>(std::isnan(value) ? value : std::clamp(value, -most, most)));
}

void RecordingColumns::values(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values)
    if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
  const bool varies = std::any_of(values.begin(), values.end(), [&](double value) { return value != low; });
  count(varies);
  if (!varies) return real(values.empty() ? 0 : low);
  const double middle = 0.5 * low + 0.5 * high, unit = unitOf(0.5 * high - 0.5 * low);
  real(middle);
  real(unit);
  for (const double value : values) single((value - middle) / unit);
}

std::string RecordingColumns::json(const std::string& title) const {
  std::string result = "{\"version\":1,\"title\":" + quoted(title) + ",\n\"reals\":\"" + base64(reals_) +
                       "\",\n\"singles\":\"" + base64(singles_) + "\",\n\"counts\":\"" + base64(counts_) +
                       "\",\n\"texts\":[";
  for (std::size_t i = 0; i < texts_.size(); ++i) result += (i > 0 ? "," : "") + quoted(texts_[i]);
  return result + "]}";
}

}  // namespace tricover::detail
