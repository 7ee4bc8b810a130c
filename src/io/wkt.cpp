// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/wkt.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/parts.h"

namespace tricover {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }
bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  std::vector<detail::Part> parts() {
    skipByteOrderMark();
    std::string_view word = nextWord();
    if (is(word, "SRID")) {
      while (at_ < text_.size() && text_[at_] != ';') ++at_;
      expect(';', "after the SRID");
      word = nextWord();
    }
    // The dimensions may be a word of their own.
    for (const char* suffix : {"ZM", "Z", "M"}) {
      const std::size_t before = word.size() - std::min(word.size(), std::string_view(suffix).size());
      if (is(word.substr(before), suffix)) word = word.substr(0, before);
    }
    is_multi_ = is(word, "MULTIPOLYGON");
    if (!is_multi_ && !is(word, "POLYGON"))
      refuse(word.empty() ? "it doesn't begin with a word" : "it is a " + std::string(word.substr(0, 40)),
             "POLYGON and MULTIPOLYGON are read");
    readDimensions();
    std::vector<detail::Part> parts;
    if (!is_multi_) {
      parts.emplace_back();
      readPart(parts.back());
    } else {
      expect('(', "before the parts");
      do {
        parts.emplace_back();
        readPart(parts.back());
        ++part_;
      } while (take(','));
      expect(')', "after the parts");
    }
    if (peek() != '\0' || at_ < text_.size()) refuse("something is left after the last bracket", "read one at a time");
    return parts;
  }

 private:
  [[noreturn]] void refuse(const std::string& wrong, const std::string& instead = {}) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(at_);
    std::string name = "WKT: line " + std::to_string(std::count(text_.begin(), end, '\n') + 1);
    if (is_in_part_) {
      if (is_multi_) name += ", part " + std::to_string(part_);
      name += ", ring " + std::to_string(ring_) + ", vertex " + std::to_string(vertex_);
    }
    detail::refuseFile(name, wrong, instead);
  }

  void skipByteOrderMark() {
    if (text_.compare(0, 3, "\xef\xbb\xbf") == 0) at_ = 3;
  }
  void skipSpace() {
    while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
  }
  /// '\0' at the end.
  char peek() {
    skipSpace();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c || at_ == text_.size()) return false;
    ++at_;
    return true;
  }
  void expect(char c, const char* where) {
    if (take(c)) return;
    requireNotEmpty();
    const std::string expected = std::string("'") + c + "' is missing " + where;
    refuse(at_ < text_.size() ? expected : "it ends early: " + expected);
  }
  std::string_view nextWord() {
    skipSpace();
    const std::size_t begin = at_;
    while (at_ < text_.size() && isLetter(text_[at_])) ++at_;
    return std::string_view(text_).substr(begin, at_ - begin);
  }
  static bool is(std::string_view word, std::string_view upper) {
    return std::equal(word.begin(), word.end(), upper.begin(), upper.end(),
                      [](char c, char d) { return (c >= 'a' ? c - 'a' + 'A' : c) == d; });
  }
  void requireNotEmpty() {
    const std::size_t begin = at_;
    if (is(nextWord(), "EMPTY")) refuse("it is EMPTY, and a polygon has a region", "leave it out");
    at_ = begin;
  }
  void readDimensions() {
    if (!isLetter(peek())) return;
    requireNotEmpty();
    const std::string_view word = nextWord();
    if (!is(word, "Z") && !is(word, "M") && !is(word, "ZM"))
      refuse("'" + std::string(word.substr(0, 40)) + "' is none of Z, M and ZM");
  }

  void readPart(detail::Part& part) {
    ring_ = vertex_ = 0;
    is_in_part_ = true;
    expect('(', "before the rings");
    do {
      vertex_ = 0;
      expect('(', "before the positions");
      part.emplace_back();
      do {
        part.back().push_back(position());
        ++vertex_;
      } while (take(','));
      expect(')', "after the positions");
      ++ring_;
    } while (take(','));
    expect(')', "after the rings");
    is_in_part_ = false;
  }

  Vec2 position() {
    const double x = number(), y = number();
    for (int beyond = 0; beyond < 2; ++beyond)
      if (const char next = peek(); next != ',' && next != ')' && next != '\0') number();
    return {x, y};
  }
  double number() {
    skipSpace();
    const char *begin = text_.data() + at_, *const end = text_.data() + text_.size();
    if (begin != end && *begin == '+') ++begin;
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    const std::string text(begin, std::min(stop, begin + 40));
    if (error == std::errc::invalid_argument)
      refuse(begin == end ? "it ends early: a number is missing" : "a number is missing");
    if (error == std::errc::result_out_of_range) refuse("'" + text + "' is beyond the range of doubles");
    if (!std::isfinite(value)) refuse("'" + text + "' is not a finite number");
    at_ = static_cast<std::size_t>(stop - text_.data());
    if (stop != end && !isSpace(*stop) && *stop != ',' && *stop != ')') refuse("'" + text + *stop + "' is no number");
    return value;
  }

  const std::string& text_;
  std::size_t at_ = 0, part_ = 0, ring_ = 0, vertex_ = 0;
  bool is_multi_ = false, is_in_part_ = false;
};

void append(std::string& text, const detail::Part& part) {
  text += '(';
  for (const Ring& ring : part) {
    text += &ring == part.data() ? "(" : ", (";
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Vec2& vertex = ring[i < ring.size() ? i : 0];
      if (i > 0) text += ", ";
      detail::appendNumber(text, vertex.x());
      text += ' ';
      detail::appendNumber(text, vertex.y());
    }
    text += ')';
  }
  text += ')';
}

}  // namespace

GeoFeature parseWkt(const std::string& text, const GeoOptions& options) {
  detail::requireOrigin(options);
  return detail::featureOf(Reader(text).parts(), options, "WKT");
}

std::string toWkt(const Polygon& polygon) {
  const std::vector<detail::Part> parts = detail::partsOf(polygon, "polygon", "WKT");
  std::string text = parts.size() == 1 ? "POLYGON " : "MULTIPOLYGON (";
  for (const detail::Part& part : parts) {
    if (&part != parts.data()) text += ", ";
    append(text, part);
  }
  return parts.size() == 1 ? text : text + ')';
}

}  // namespace tricover
