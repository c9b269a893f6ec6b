#pragma once

#include "cli/arguments.hpp"

namespace quadline {

// Exit codes, the same for every command. docs/command-line.md describes them.
constexpr int kDone = 0;
constexpr int kWrongInput = 2;     ///< the command line, the model or the mesh is wrong
constexpr int kBrokenPromise = 3;  ///< no valid mesh could be made, or the mesh checked is not valid
constexpr int kCannotWrite = 4;
constexpr int kInterrupted = 130;

// Each returns its exit code, and throws the errors of quadline/errors.hpp.
int run(const MeshArguments& arguments);
int run(const CheckArguments& arguments);
int run(const InfoArguments& arguments);
int run(const DrawArguments& arguments);

}  // namespace quadline
