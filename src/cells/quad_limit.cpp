#include "cells/quad_limit.hpp"

#include <charconv>

#include "domain/expected_quads.hpp"

namespace quadline {

namespace {

std::string text_of(double number, int digits) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::general, digits).ptr};
}

}  // namespace

std::string QuadLimit::refuse(const char* about, double n_quads, int digits, const char* verb) const {
  if (n_quads <= options_.max_quads) return {};
  return about + text_of(n_quads, digits) + " quads are " + verb + ", more than " + text_of(options_.max_quads, 6) +
         ": choose a larger size, or raise --max-quads";
}

std::string QuadLimit::refuse_expected(const Domain& domain) const {
  return refuse("about ", expected_quads(domain, options_), 2, "expected");
}

std::string QuadLimit::refuse_at_least(double n_quads) const { return refuse("at least ", n_quads, 9, "needed"); }

std::string QuadLimit::refuse_made(std::size_t n_quads) const {
  return refuse("", static_cast<double>(n_quads), 9, "needed");
}

}  // namespace quadline
