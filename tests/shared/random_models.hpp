#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quadline/model.hpp"

namespace quadline {

/// The same numbers on every machine, unlike the distributions of <random>.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 1) {}
  double number(double low, double high);
  int whole(int low, int high);  ///< both ends included

 private:
  std::uint64_t state_;
};

/// A kind of random models; each asks for something else.
struct Family {
  std::string name;
  Model (*make)(Dice& dice);
  bool lines_stay_inside = true;  ///< no line leaves the domain
  bool is_hard = false;           ///< one mesh in ten may be refused
};

const std::vector<Family>& families();

}  // namespace quadline
