#include "cells/cell_loop.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <numeric>
#include <vector>

namespace quadline {

namespace {

std::vector<CellId> largest_first(const IdVector<CellId, double>& weights) {
  std::vector<CellId> cells;
  for (std::size_t i = 0; i < weights.count(); ++i) cells.emplace_back(i);
  std::stable_sort(cells.begin(), cells.end(), [&](CellId a, CellId b) { return weights[a] > weights[b]; });
  return cells;
}

// Tells the progress of one cell as part of the stage's.
class CellProgress {
 public:
  CellProgress(std::string_view stage, double share, std::atomic<double>& done, const Context& context)
      : stage_(stage), share_(share), done_(done), context_(context) {}

  Context context() {
    Context own;
    own.is_cancelled = context_.is_cancelled;
    if (context_.on_progress) own.on_progress = [this](std::string_view, double fraction) { advance(fraction); };
    return own;
  }
  void advance(double fraction) {
    const double step = share_ * (std::clamp(fraction, told_, 1.0) - told_);
    told_ = std::clamp(fraction, told_, 1.0);
    const double sum = done_.fetch_add(step) + step;
    if (context_.on_progress) context_.on_progress(stage_, std::min(sum, 1.0));
  }

 private:
  std::string_view stage_;
  double share_, told_ = 0;
  std::atomic<double>& done_;
  const Context& context_;
};

}  // namespace

void for_each_cell(std::string_view stage, const IdVector<CellId, double>& weights, const Context& context,
                   const std::function<void(CellId, Context&)>& work) {
  const std::vector<CellId> order = largest_first(weights);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::atomic<double> done = 0;
  std::atomic<bool> is_over = false;
  IdVector<CellId, std::exception_ptr> errors(weights.count());
  const auto job = [&](std::size_t i) {
    if (is_over) return;
    try {
      CellProgress progress(stage, weights[order[i]] / sum, done, context);
      Context own = progress.context();
      work(order[i], own);
      progress.advance(1);
    } catch (...) {  // a thread of the caller's may not see it
      errors[order[i]] = std::current_exception();
      is_over = true;
    }
  };
  if (context.run_all) {
    context.run_all(order.size(), job);
  } else {
    for (std::size_t i = 0; i < order.size(); ++i) job(i);
  }
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace quadline
