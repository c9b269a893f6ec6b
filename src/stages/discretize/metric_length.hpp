#pragma once

#include <cstdint>
#include <vector>

#include "domain/size/size_field.hpp"
#include "geom/curve.hpp"

namespace quadline {

/// Length of a curve measured in local sizes (the integral of 1/h along it), and its inverse [BorouchakiGeorge1997].
///
/// 1/h is taken as linear between samples; these halve until they lie half a local size apart, which the gradation of
/// h makes close enough. A curve walked backwards has the same samples.
class MetricLength {
 public:
  MetricLength(const CurvePiece& piece, const SizeField& size);

  /// Number of edges that the sizes ask for, not rounded; > 0.
  double total() const { return samples_.back().metric; }

  /// Arc lengths of the n - 1 nodes that cut the curve into n edges of equal metric length; of exactly equal length
  /// where h is constant.
  std::vector<double> places(std::uint32_t n) const;

 private:
  struct Sample {
    double s;       ///< arc length
    double h;       ///< size there
    double metric;  ///< metric length from the start
  };
  std::vector<Sample> samples_;
  bool is_uniform_ = true;
};

}  // namespace quadline
