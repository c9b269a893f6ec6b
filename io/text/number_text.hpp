#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace quadline {

/// Appends the shortest text that reads back as the same number. Does not depend on the locale.
inline void append_number(std::string& out, double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, end);
}

inline void append_number(std::string& out, std::integral auto value) {
  char text[24];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, end);
}

/// Appends a number in at most `width` >= 14 characters: the shortest exact text where it fits, else as many digits as
/// fit. For readers with fixed columns.
inline void append_number_within(std::string& out, double value, std::ptrdiff_t width) {
  char text[32];
  auto end = std::to_chars(text, text + sizeof text, value).ptr;
  for (int digits = 16; end - text > width; --digits)
    end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1).ptr;
  out.append(text, end);
}

/// The number that the whole text is, with or without a sign; empty where it is none or does not fit the type.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace quadline
