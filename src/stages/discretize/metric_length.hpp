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
  /// Sizes at the two ends, model units.
  double begin_size() const { return samples_.front().h; }
  double end_size() const { return samples_.back().h; }

  /// Lowers the sizes, where they are larger, to the ones given at the ends, and where they grow along the curve by
  /// more than `slope` times the way. Says whether any fell.
  bool limit(double slope, double begin_size, double end_size);

  /// How much closer than all along the curve nodes stand at its ends; 0.5 to 2.
  struct Crowding {
    double begin = 1, end = 1;
  };
  /// Arc lengths of the n - 1 nodes that cut the curve into n edges of equal metric length; of exactly equal length
  /// where h is constant. With a crowding edges change smoothly from one end to the middle to the other end.
  std::vector<double> places(std::uint32_t n, Crowding crowding) const;

 private:
  void add_up();

  struct Sample {
    double s;       ///< arc length
    double h;       ///< size there
    double metric;  ///< metric length from the start
  };
  std::vector<Sample> samples_;
  bool is_uniform_ = true;
};

}  // namespace quadline
