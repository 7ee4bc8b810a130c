// SPDX-License-Identifier: BSD-3-Clause
// rewrite <from> <to>: reads a .geojson, or a .wkt of one geometry a line, and writes what was read. A geometry of WKT
// that is refused becomes a line "refused: <why>".
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include "tricover/geojson.h"
#include "tricover/wkt.h"

namespace {

std::string rewritten(const std::string& wkt) {
  try {
    return tricover::toWkt(tricover::parseWkt(wkt).polygon);
  } catch (const std::exception& error) {
    return std::string("refused: ") + error.what();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string from = argv[1], to = argv[2];
  if (from.size() < 4 || from.substr(from.size() - 4) != ".wkt") try {
      tricover::writeGeoJson(to, tricover::readGeoJson(from));
      return 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      return 1;
    }
  std::ifstream in(from);
  std::ofstream out(to);
  for (std::string line; std::getline(in, line);) out << rewritten(line) << '\n';
  return out ? 0 : 1;
}
