#include "io/text/names.hpp"

#include <algorithm>

#include "base/utf8.hpp"

namespace quadline {
namespace {

constexpr std::size_t kLongestName = 80;
constexpr std::size_t kLongestShown = 32;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::string shown(std::string_view text) { return escaped(text); }

std::string shown_name(std::string_view name) { return shortened(escaped(name), kLongestShown); }

std::size_t shown_width(std::string_view text) { return character_count(text); }

std::string SetNames::make(std::string_view wanted) {
  std::string name;
  for (const char c : wanted) {
    if (is_continuation(c)) continue;  // one '_' for each character, not for each byte
    name += is_letter(c) || is_digit(c) || c == '-' ? c : '_';
  }
  if (name.empty() || !is_letter(name[0])) name.insert(0, "S_");
  name.resize(std::min(name.size(), kLongestName));

  const auto lower = [](std::string text) {
    for (char& c : text)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
  };
  int& times_wanted = taken_[lower(name)];
  if (++times_wanted == 1) return name;
  for (;; ++times_wanted) {
    const std::string ending = "_" + std::to_string(times_wanted);
    const std::string made = name.substr(0, kLongestName - ending.size()) + ending;
    if (taken_.try_emplace(lower(made), 1).second) return made;
  }
}

std::string json_string(std::string_view name) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  while (!name.empty()) {
    const std::size_t n = utf8_length(name);
    if (n == 0) {
      out += "\\ufffd";
    } else if (is_control(name.substr(0, 1))) {
      out += "\\u00";
      out += kHex[name[0] >> 4];
      out += kHex[name[0] & 15];
    } else {
      if (name[0] == '"' || name[0] == '\\') out += '\\';
      out += name.substr(0, n);
    }
    name.remove_prefix(std::max<std::size_t>(n, 1));
  }
  return out + '"';
}

}  // namespace quadline
