// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "families.h"
#include "random.h"

/// Laws that hold of random cases: against an exact reference, or beside other queries where there is none. CTest asks
/// a fixed number of cases of each law (laws_test.cpp); soak asks as many as there is time for (soak.cpp). A case is a
/// law's, a seed's and a number's, and the same in both.
namespace tricover::laws {

using support::Case;
using support::Family;
using support::Random;

/// A trait's share of the questions that have it or not.
struct Share {
  const char* trait;
  double least, most;
};
using Shares = std::vector<Share>;

/// What a law's questions were like.
class Tally {
 public:
  void count(const std::string& trait, bool is_so);
  /// Of each trait how many have it, on one line.
  std::string line() const;
  /// The first share that is out of its bounds; empty if there is none. `cases` are those asked. Where these are a
  /// sample of all, shares may be out by four of their standard deviations.
  std::string wrongShare(const Shares& shares, long cases, bool is_sample) const;

 private:
  struct Count {
    long asked = 0, so = 0;
  };
  std::map<std::string, Count> counts_;
};

struct Law {
  std::string family;  ///< of cases: letters, digits and underscores
  int cases;           ///< that CTest asks; soak draws laws as often as these say
  /// What is wrong with one more case, followed by the case as C++; empty if nothing is.
  std::function<std::string(Random& random, Tally& tally)> wrong;
  /// Cases are not all alike.
  Shares shares = {{"hits", 0.02, 0.98}};
  std::string query = "";  ///< set by allLaws()
};
using Laws = std::vector<Law>;

/// One a file: `const Register registered("collide", collideLaws);`
struct Register {
  Register(const char* query, Laws (*laws)());
};
/// Of every file that is linked.
Laws allLaws();

/// Asks the case of this number, of polygons from which all is derived, or anything up to some stage. Says, too, how
/// soak asks it alone.
std::string wrongCase(const Law& law, std::uint64_t seed, std::uint64_t number, Tally& tally);

/// One more family of pairs.
Family family(const char* name, Case (*make)(Random& random));

/// What is wrong with a pair; empty if nothing is. May change the pair before it asks.
using WrongPair = std::function<std::string(Random& random, Tally& tally, Case& c)>;

/// One law for each family of pairs, whose name follows the prefix.
void add(Laws& laws, const std::vector<Family>& families, int cases, const WrongPair& wrong,
         const Shares& shares = {{"hits", 0.02, 0.98}}, const std::string& prefix = "");

}  // namespace tricover::laws
