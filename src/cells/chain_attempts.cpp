#include "cells/chain_attempts.hpp"

#include <optional>
#include <utility>

namespace quadline {

MeshResult chain_attempts(FallbackPlan& plan, const std::string& file,
                          const std::function<Attempt(CellCache&)>& attempt) {
  CellCache cache(plan.domain().cells.count());
  Attempt last = attempt(cache);
  if (!last.too_many.empty()) throw InputError(ErrorCode::TooManyQuads, last.too_many, Where{file, {}, {}});

  std::optional<MeshResult> first;
  if (last.result.failure) first = last.result;
  bool is_limited = false;
  while (last.result.failure && plan.advance(last.troubles)) {
    Attempt next = attempt(cache);
    is_limited |= !next.too_many.empty();
    if (next.too_many.empty()) last = std::move(next);
  }
  if (last.result.failure) {
    last.result = std::move(*first);
    last.result.report.findings = plan.failures(last.troubles);
    if (is_limited)
      last.result.report.findings.push_back(
          {"what may help needs more quads than allowed", {}, last.result.failure->at});
  }
  return std::move(last.result);
}

}  // namespace quadline
