#pragma once

#include <sys/types.h>

#include <string>

#include "quadline/model.hpp"

namespace quadline {

/// How the meshing of one model ended.
struct Outcome {
  /// "" for a valid mesh; else its kind, without numbers and names: "input: ...", "qmorph: ...", "crash: ...", "hang".
  std::string kind;
  int attempts = 0;
  double elapsed_s = 0;

  bool is_input_error() const { return kind.starts_with("input:"); }
  bool is_failure() const { return !kind.empty() && !is_input_error(); }
};

/// Meshes a model in a process of its own, so that a crash or a hang ends that process only.
class Trial {
 public:
  Trial(const Model& model, double limit_s);
  int fd() const { return fd_; }  ///< readable when the process has ended
  double left_s() const;          ///< until it counts as a hang
  Outcome finish();               ///< waits for the end, at most `left_s`; call once

 private:
  pid_t pid_ = 0;
  int fd_ = -1;
  double start_s_ = 0, limit_s_ = 0;
};

}  // namespace quadline
