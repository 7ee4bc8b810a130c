// SPDX-License-Identifier: BSD-3-Clause
// Fills pages.html with what is in the report directory: a line `@picture <file>` with an SVG, a line `@tables <file>`
// with a Markdown file, `@details <file> <title>` with one that is folded away. What isn't there is said to be missing.
#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "report.h"

namespace tricover::bench {
namespace {

/// As HTML, `code` and **strong** text too.
std::string escaped(const std::string& text) {
  std::string result;
  bool code = false, strong = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '`') {
      code = !code;
      result += code ? "<code>" : "</code>";
    } else if (text.compare(i, 2, "**") == 0) {
      strong = !strong;
      result += strong ? "<strong>" : "</strong>";
      ++i;
    } else {
      result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    }
  }
  return result;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

/// Of `| one | two |`.
std::vector<std::string> cellsOf(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream in(row.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    if (!in.eof()) cells.push_back(trimmed(cell));
  }
  return cells;
}

/// How pages.html colours a cell.
std::string styleOf(const std::string& cell) {
  if (cell == "yes") return "yes";
  if (cell == "no" || cell == "**no**") return "no";
  if (cell == "0") return "zero";
  if (cell.find("fail") != std::string::npos) return "fails";
  const bool count = !cell.empty() && cell.find_first_not_of("0123456789") == std::string::npos;
  return count ? "some" : cell.size() > 16 ? "text" : "";
}

/// The Markdown that our reports are made of: headings, tables, lists of `- ` with indented lines, paragraphs. The
/// title is left out: the page has its own.
class Html {
 public:
  explicit Html(std::istream& markdown) {
    bool title = true;
    for (std::string line; std::getline(markdown, line); title = false) {
      if (!title || line[0] != '#') add(line);
    }
    close();
  }
  const std::string& str() const { return html_; }

 private:
  void add(const std::string& line) {
    if (trimmed(line).empty()) return close();
    if (line[0] == '|') return addRow(line);
    if (startsWith(line, "- ")) {
      if (open_ != "</li></ul>\n") {
        close();
        open_ = "</li></ul>\n";
        html_ += "<ul><li>";
      } else {
        html_ += "</li><li>";
      }
      html_ += escaped(line.substr(2));
    } else if (startsWith(line, "#")) {
      close();
      const std::size_t level = line.find_first_not_of('#');
      const std::string tag = level == 1 ? "h3" : "h4";
      html_ += "<" + tag + ">" + escaped(trimmed(line.substr(level))) + "</" + tag + ">\n";
    } else {
      if (open_.empty()) {
        open_ = "</p>\n";
        html_ += "<p>";
      }
      html_ += " " + escaped(trimmed(line));
    }
  }

  void addRow(const std::string& line) {
    if (line.find_first_not_of("|:- ") == std::string::npos) return;  // below the head
    const bool head = open_ != "</tbody></table></div>\n";
    if (head) {
      close();
      open_ = "</tbody></table></div>\n";
      html_ += "<div class=\"wide\"><table><thead>";
    }
    html_ += "<tr>";
    bool first = true;
    for (const std::string& cell : cellsOf(line)) {
      const std::string style = head || first ? "" : styleOf(cell);
      const std::string tag = head || first ? "th" : "td";
      html_ += "<" + tag + (style.empty() ? "" : " class=\"" + style + "\"") + ">" + escaped(cell) + "</" + tag + ">";
      first = false;
    }
    html_ += head ? "</tr></thead><tbody>\n" : "</tr>\n";
  }

  void close() {
    html_ += open_;
    open_.clear();
  }

  std::string html_, open_;
};

bool isDirective(const std::string& line) {
  return startsWith(line, "@picture ") || startsWith(line, "@tables ") || startsWith(line, "@details ");
}

std::string filled(const std::string& directive, const std::string& directory) {
  std::istringstream in(directive);
  std::string kind, file, title;
  in >> kind >> file >> std::ws;
  std::getline(in, title);
  std::ifstream source(directory + "/" + file);
  if (!source) return "<p class=\"missing\">" + file + " was not made in this run.</p>\n";
  if (kind == "@picture") return "<a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"" + file + "\"></a>\n";
  const std::string html = Html(source).str();
  if (kind == "@tables") return html;
  return "<details><summary>" + escaped(title) + "</summary>\n" + html + "</details>\n";
}

int run(const std::string& page, const std::string& directory) {
  std::ifstream in(page);
  if (!in) throw std::runtime_error("cannot read " + page);
  std::string html;
  for (std::string line; std::getline(in, line);) {
    html += isDirective(line) ? filled(line, directory) : line + "\n";
  }
  writeFile(directory + "/index.html", html);
  return 0;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  return runProgram(argv[0], "<page to fill> <report directory>", argc == 3, [&] { return run(argv[1], argv[2]); });
}
