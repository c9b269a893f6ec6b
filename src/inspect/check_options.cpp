#include <charconv>

#include "quadline/errors.hpp"
#include "quadline/options.hpp"

namespace quadline {

namespace {

std::string text_of(double x) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

void refuse_outside(const Range& range, double value, const std::string& option) {
  if (range.contains(value)) return;
  throw InputError(ErrorCode::InvalidOption,
                   "Options::" + option + " is " + text_of(value) + ": expected " + range.text());
}

}  // namespace

std::string Range::text() const {
  const bool is_open = !(high < std::numeric_limits<double>::max());
  if (is_above) return "a number above " + text_of(low) + (is_open ? "" : " and up to " + text_of(high));
  return is_open ? "a number of " + text_of(low) + " or more"
                 : "a number from " + text_of(low) + " to " + text_of(high);
}

void check(const Options& options) {
  if (options.size) refuse_outside(kLengthRange, *options.size, "size");
  refuse_outside(kEdgesPerCircleRange, options.edges_per_circle, "edges_per_circle");
  if (options.tolerance) refuse_outside(kLengthRange, *options.tolerance, "tolerance");
  refuse_outside(kGrowthRange, options.growth, "growth");
  refuse_outside(kMaxQuadsRange, options.max_quads, "max_quads");
  if (!options.criteria) return;
  for (const CriteriaField& field : criteria_fields())
    if (const std::optional<double> limit = *options.criteria.*field.limit)
      refuse_outside({.low = field.low, .high = field.high}, *limit, "criteria." + std::string(field.name));
}

}  // namespace quadline
