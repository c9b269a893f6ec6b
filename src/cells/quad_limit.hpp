#pragma once

#include <string>

#include "domain/domain.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// What Options::max_quads allows: the one place that looks at it. Each question is answered by a reason why there are
/// too many quads, which is empty where there are not.
class QuadLimit {
 public:
  explicit QuadLimit(const Options& options) : options_(options) {}

  std::string refuse_expected(const Domain& domain) const;  ///< before anything is made, by an estimate
  std::string refuse_at_least(double n_quads) const;        ///< when the curves have their nodes
  std::string refuse_made(std::size_t n_quads) const;       ///< when the mesh is there

 private:
  std::string refuse(const char* about, double n_quads, int digits, const char* verb) const;
  const Options& options_;
};

}  // namespace quadline
