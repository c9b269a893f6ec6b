#include "quality/quad_sums.hpp"

#include <algorithm>

#include "base/elementary.hpp"

namespace quadline {

void QuadSums::add(double beta, double jacobian) {
  constexpr double kLeastBeta = 1e-12;
  ++n_;
  n_inverted_ += jacobian <= 0;
  beta_min_ = std::min(beta_min_, beta);
  log_beta_ += logarithm(std::max(beta, kLeastBeta));
  jacobian_min_ = std::min(jacobian_min_, jacobian);
  jacobian_ += jacobian;
}

double QuadSums::beta_mean() const { return n_ > 0 ? exponential(log_beta_ / static_cast<double>(n_)) : 0; }

}  // namespace quadline
