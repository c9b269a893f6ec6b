#include "stages/discretize/metric_length.hpp"

#include <algorithm>
#include <cmath>

// [BorouchakiGeorge1997] gives closed forms for a linear or geometric h between two ends. Here h comes from a field and
// is sampled; the linear 1/h of a short interval needs no logarithm, so that every platform finds the same nodes.

namespace quadline {
namespace {

/// The part of the metric length before a part of the edges. Their density along it is, over its mean, the crowding
/// at the ends, with a parabola between that makes the mean 1; its integral is a cubic, inverted by Newton's method.
double part_before(double edges, MetricLength::Crowding crowding) {
  const double u = crowding.begin, v = crowding.end, bow = 1 - 0.5 * (u + v);
  if (u == 1 && v == 1) return edges;
  constexpr int kSteps = 8;
  double t = edges;
  for (int k = 0; k < kSteps; ++k) {
    const double sum = t * (u + t * (0.5 * (v - u) + bow * (3 - 2 * t)));
    const double density = u + t * (v - u + 6 * bow * (1 - t));
    t = std::clamp(t - (sum - edges) / density, 0.0, 1.0);
  }
  return t;
}

}  // namespace

MetricLength::MetricLength(const CurvePiece& piece, const SizeField& size) {
  const double whole = length(piece);
  const auto sample = [&](double s) { return Sample{s, size.at(point_at(piece, s)), 0}; };
  std::vector<Sample> pending{sample(whole)};
  samples_.push_back(sample(0));
  // At least four intervals: a short curve between two coarse places may have a fine one between.
  for (int i = 3; i >= 1; --i) pending.push_back(sample(0.25 * i * whole));
  while (!pending.empty()) {
    const Sample from = samples_.back(), to = pending.back();
    const double step = to.s - from.s;
    if (step > 0.5 * std::min(from.h, to.h) && step > 1e-12 * whole) {
      pending.push_back(sample(from.s + 0.5 * step));
      continue;
    }
    pending.pop_back();
    samples_.push_back(to);
  }
  add_up();
}

void MetricLength::add_up() {
  for (std::size_t k = 1; k < samples_.size(); ++k) {
    const Sample& from = samples_[k - 1];
    Sample& to = samples_[k];
    to.metric = from.metric + 0.5 * (to.s - from.s) * (1 / from.h + 1 / to.h);
  }
  const double h = samples_.front().h;
  is_uniform_ = std::all_of(samples_.begin(), samples_.end(), [&](const Sample& k) { return k.h == h; });
  if (is_uniform_) samples_.back().metric = samples_.back().s / h;
}

bool MetricLength::limit(double slope, double begin_size, double end_size) {
  if (is_uniform_ && std::min(begin_size, end_size) >= samples_.front().h) return false;
  bool falls = false;
  const auto lower = [&](Sample& k, double most) {
    if (k.h <= most) return;
    k.h = most;
    falls = true;
  };
  lower(samples_.front(), begin_size);
  lower(samples_.back(), end_size);
  for (std::size_t k = 1; k < samples_.size(); ++k)
    lower(samples_[k], samples_[k - 1].h + slope * (samples_[k].s - samples_[k - 1].s));
  for (std::size_t k = samples_.size() - 1; k-- > 0;)
    lower(samples_[k], samples_[k + 1].h + slope * (samples_[k + 1].s - samples_[k].s));
  if (falls) add_up();
  return falls;
}

std::vector<double> MetricLength::places(std::uint32_t n, Crowding crowding) const {
  std::vector<double> found;
  found.reserve(n - 1);
  std::size_t k = 1;
  for (std::uint32_t i = 1; i < n; ++i) {
    const double part = part_before(static_cast<double>(i) / n, crowding);
    if (is_uniform_) {
      found.push_back(samples_.back().s * part);
      continue;
    }
    const double target = total() * part;
    while (k + 1 < samples_.size() && samples_[k].metric < target) ++k;
    const Sample &from = samples_[k - 1], &to = samples_[k];
    // Invert metric(x) = a x + (b - a) x^2 / 2 on 0..1, with a and b the metric lengths at the rates of the two ends.
    const double step = to.s - from.s, a = step / from.h, b = step / to.h, wanted = target - from.metric;
    const double root = std::sqrt(std::max(0.0, a * a + 2 * (b - a) * wanted));
    found.push_back(from.s + step * std::clamp(2 * wanted / (a + root), 0.0, 1.0));
  }
  return found;
}

}  // namespace quadline
