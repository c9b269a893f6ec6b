#pragma once

#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "io/found/found_mesh.hpp"
#include "io/text/number_text.hpp"

namespace quadline {

/// Reads a file from front to back, words or raw values; every error points at the place.
class Cursor {
 public:
  explicit Cursor(const SourceFile& file) : file_(file) {}

  std::size_t at() const { return at_; }
  std::size_t left() const { return file_.bytes.size() - at_; }
  void move_to(std::size_t offset) { at_ = offset; }
  /// Errors tell the byte in place of the line.
  void set_binary(bool binary) { binary_ = binary; }
  /// Raw values stand in the byte order that is not the machine's.
  void set_swapped(bool swapped) { swapped_ = swapped; }

  [[noreturn]] void fail(const std::string& message) const {
    if (binary_) file_.fail_at_byte(at_, message);
    file_.fail_at_line(at_, message);
  }

  /// The rest of this line, without its end; moves to the next.
  std::string_view line() {
    const std::string_view rest = file_.bytes.substr(at_);
    const std::size_t end = rest.find('\n');
    at_ += end == rest.npos ? rest.size() : end + 1;
    std::string_view text = rest.substr(0, end);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    return text;
  }

  /// The next word, which spaces and line ends bound; empty at the end of the file.
  std::string_view next_word() {
    const std::string_view bytes = file_.bytes;
    while (at_ < bytes.size() && is_space(bytes[at_])) ++at_;
    const std::size_t start = at_;
    while (at_ < bytes.size() && !is_space(bytes[at_])) ++at_;
    return bytes.substr(start, at_ - start);
  }

  template <class Number>
  Number number() {
    const std::string_view text = next_word();
    const auto value = parse_number<Number>(text);
    if (!value) {
      const std::string found = text.empty() ? "the end of the file" : "'" + std::string(text.substr(0, 40)) + "'";
      at_ -= text.size();
      fail("a number was expected, not " + found);
    }
    return *value;
  }

  template <class T>
  T raw() {
    if (left() < sizeof(T)) fail("the file ends too early");
    char bytes[sizeof(T)];
    std::memcpy(bytes, file_.bytes.data() + at_, sizeof(T));
    if (swapped_)
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
    at_ += sizeof(T);
    return std::bit_cast<T>(bytes);
  }

  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

 private:
  const SourceFile& file_;
  std::size_t at_ = 0;
  bool binary_ = false, swapped_ = false;
};

}  // namespace quadline
