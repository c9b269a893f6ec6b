#pragma once

#include <cstddef>

namespace quadline {

/// Distortion coefficient (beta) and scaled Jacobian of some quads, summed up.
class QuadSums {
 public:
  void add(double beta, double jacobian);

  std::size_t count() const { return n_; }
  std::size_t n_inverted() const { return n_inverted_; }  ///< scaled Jacobian 0 or less
  // 0 where there are no quads
  double beta_min() const { return n_ > 0 ? beta_min_ : 0; }
  double beta_mean() const;  ///< geometric; a beta of nothing counts as 1e-12
  double jacobian_min() const { return n_ > 0 ? jacobian_min_ : 0; }
  double jacobian_mean() const { return n_ > 0 ? jacobian_ / static_cast<double>(n_) : 0; }

 private:
  std::size_t n_ = 0, n_inverted_ = 0;
  double beta_min_ = 1, log_beta_ = 0, jacobian_min_ = 1, jacobian_ = 0;
};

}  // namespace quadline
