#pragma once

#include <cstddef>
#include <string>

#include "quadline/errors.hpp"

namespace quadline {

/// Watches a loop that ends by an argument, in case the argument is wrong: throws InternalError instead of spinning.
class StepLimit {
 public:
  /// @param loop  its name, for the message.
  /// @param most  steps that it may take.
  StepLimit(const char* loop, std::size_t most) : loop_(loop), most_(most) {}

  void step() {
    if (++steps_ > most_)
      throw InternalError(std::string(loop_) + " does not end within " + std::to_string(most_) + " steps");
  }
  std::size_t steps() const { return steps_; }

 private:
  const char* loop_;
  std::size_t most_, steps_ = 0;
};

}  // namespace quadline
