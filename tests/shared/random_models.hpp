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
  bool is_hard = false;     ///< one in ten may be left without a mesh
  double most_refused = 0;  ///< the share of its models that may be no valid input
};

const std::vector<Family>& families();

}  // namespace quadline
