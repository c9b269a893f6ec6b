#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace quadline {

/// Length in bytes of the UTF-8 character at the start of a text, 0 where there is none (RFC 3629).
/// @pre  the text is not empty.
inline std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t n = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < n) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // The second byte rules out overlong forms, surrogates and what lies beyond U+10FFFF.
  if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F)) return 0;
  if ((lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F)) return 0;
  return n;
}

/// Is a UTF-8 character one that ends a line, steers a terminal, or that XML does not know?
inline bool is_control(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return lead < 0x20 || lead == 0x7F;
  return (lead == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0) ||  // U+0080 to U+009F
         character == "\u2028" || character == "\u2029" || character == "\uFFFE" || character == "\uFFFF";
}

/// The text with other characters in place of control characters and of bytes that are not UTF-8.
inline std::string printable(std::string_view text, char for_control = '_', char for_broken = '_') {
  std::string out;
  while (!text.empty()) {
    const std::size_t n = utf8_length(text);
    if (n == 0) {
      out += for_broken;
    } else if (is_control(text.substr(0, n))) {
      out += for_control;
    } else {
      out += text.substr(0, n);
    }
    text.remove_prefix(std::max<std::size_t>(n, 1));
  }
  return out;
}

/// The text on one line, for people: control characters and bytes that are not UTF-8 as C writes them, "\\n", "\\x1b".
inline std::string escaped(std::string_view text) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out;
  while (!text.empty()) {
    const std::size_t n = utf8_length(text), length = std::max<std::size_t>(n, 1);
    if (n > 0 && !is_control(text.substr(0, n))) {
      out += text.substr(0, n);
    } else if (const std::size_t letter = std::string_view("\n\t\r").find(text[0]); letter != std::string_view::npos) {
      out += std::string("\\") + "ntr"[letter];
    } else {
      for (const char c : text.substr(0, length)) {
        const auto byte = static_cast<unsigned char>(c);
        out += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
      }
    }
    text.remove_prefix(length);
  }
  return out;
}

/// Number of characters, code points, of UTF-8.
inline std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The text with the middle left out where it has more than `most` characters: "stiffener-of-t…-of-frame-17".
/// @pre  UTF-8; most > 0.
inline std::string shortened(const std::string& text, std::size_t most) {
  if (character_count(text) <= most) return text;
  const auto is_start = [](char c) { return (c & 0xC0) != 0x80; };
  const std::size_t n_head = most / 2, n_tail = most - 1 - n_head;
  std::size_t head = 0, tail = text.size();
  for (std::size_t n = 0; n <= n_head; ++head) n += is_start(text[head]);
  for (std::size_t n = 0; n < n_tail;) n += is_start(text[--tail]);
  return text.substr(0, head - 1) + "\u2026" + text.substr(tail);
}

}  // namespace quadline
