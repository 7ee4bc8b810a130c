// SPDX-License-Identifier: BSD-3-Clause
#include "countries.h"

#include <algorithm>
#include <stdexcept>

namespace tricover::bench {

Countries readCountries(std::istream& in) {
  Countries countries = workloads::readPolygons(in);
  const auto spansTheMap = [](const workloads::NamedPolygon& country) {
    double west = 180, east = -180;
    for (const Ring& ring : country.polygon.rings()) {
      for (const Vec2& v : ring) {
        west = std::min(west, v.x());
        east = std::max(east, v.x());
      }
    }
    return east - west > 300;
  };
  countries.erase(std::remove_if(countries.begin(), countries.end(), spansTheMap), countries.end());
  return countries;
}

std::size_t findCountry(const Countries& countries, const std::string& name) {
  const std::string ending = "_" + name;
  for (std::size_t i = 0; i < countries.size(); ++i) {
    const std::string& full = countries[i].name;
    if (full.size() >= ending.size() && full.compare(full.size() - ending.size(), ending.size(), ending) == 0) return i;
  }
  throw std::invalid_argument("countries: no '" + name + "'");
}

Polygon centred(const Polygon& polygon) {
  std::vector<Ring> rings = polygon.rings();
  for (Ring& ring : rings) {
    for (Vec2& v : ring) v -= polygon.origin();
  }
  return Polygon(std::move(rings), polygon.fillRule());
}

}  // namespace tricover::bench
