#pragma once

#include "quadline/context.hpp"

namespace quadline::smoothing {

/// Reports a part of the stage's progress; the caller may stop the stage there.
class Progress {
 public:
  explicit Progress(const Context& context, double begin = 0, double end = 1)
      : context_(context), begin_(begin), end_(end) {}

  /// @param part  done of this part, 0..1.
  /// @throws Cancelled when the caller asks for it.
  void report(double part) const { context_.progress("smooth", begin_ + part * (end_ - begin_)); }
  Progress part(double begin, double end) const {
    const double length = end_ - begin_;
    return Progress(context_, begin_ + begin * length, begin_ + end * length);
  }

 private:
  const Context& context_;
  double begin_, end_;
};

}  // namespace quadline::smoothing
