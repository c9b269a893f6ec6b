#include "io/vtk/vtk_data.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>

namespace quadline {
namespace {

/// Gives out the bytes of an array one after the other.
class ByteSource {
 public:
  ByteSource(std::string_view text, bool is_base64, const SourceFile& file, std::size_t at)
      : text_(text), is_base64_(is_base64), file_(file), at_(at) {}

  /// At most so many bytes are left.
  std::size_t bound() const { return is_base64_ ? text_.size() / 4 * 3 + held_.size() : text_.size(); }

  std::string take(std::size_t n) {
    if (n > bound()) fail("an array ends too early");
    if (!is_base64_) {
      std::string out(text_.substr(0, n));
      text_.remove_prefix(n);
      return out;
    }
    std::string out = std::move(held_);
    out.reserve(n + 2);
    while (out.size() < n) decode_four(out);
    held_ = out.substr(n);
    out.resize(n);
    return out;
  }

  [[noreturn]] void fail(const std::string& message) const { file_.fail_at_byte(at_, message); }

 private:
  /// Padding ends a piece, not the array: VTK pads the counts by themselves.
  void decode_four(std::string& out) {
    std::uint32_t bits = 0;
    int n_padding = 0;
    for (int i = 0; i < 4; ++i) {
      while (!text_.empty() && is_space(text_[0])) text_.remove_prefix(1);
      if (text_.empty()) fail("an array ends too early");
      const int value = value_of(text_[0]);
      if (value < 0 && text_[0] != '=') fail("a character that is not base64");
      n_padding += value < 0;
      bits = bits << 6 | static_cast<std::uint32_t>(std::max(value, 0));
      text_.remove_prefix(1);
    }
    if (n_padding > 2) fail("base64 padding is wrong");
    for (int i = 0; i < 3 - n_padding; ++i) out += static_cast<char>(bits >> (16 - 8 * i) & 0xFF);
  }
  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  static int value_of(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  }

  std::string_view text_;
  bool is_base64_;
  std::string held_;  ///< decoded, not given out yet
  const SourceFile& file_;
  std::size_t at_;
};

template <class T>
T value_at(const char* bytes, bool swapped) {
  char own[sizeof(T)];
  std::memcpy(own, bytes, sizeof(T));
  if (swapped) std::reverse(own, own + sizeof(T));
  T value;
  std::memcpy(&value, own, sizeof(T));
  return value;
}

std::vector<std::uint64_t> take_counts(ByteSource& source, std::size_t n, const VtkEncoding& encoding) {
  const std::size_t width = encoding.wide_headers ? 8 : 4;
  if (n > source.bound() / width) source.fail("an array ends too early");
  const std::string bytes = source.take(n * width);
  std::vector<std::uint64_t> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    const char* const at = bytes.data() + i * width;
    out[i] = encoding.wide_headers ? value_at<std::uint64_t>(at, encoding.swapped)
                                   : value_at<std::uint32_t>(at, encoding.swapped);
  }
  return out;
}

std::string inflated(ByteSource& source, const VtkEncoding& encoding, std::size_t most) {
  const std::uint64_t n_blocks = take_counts(source, 1, encoding)[0];
  const auto sizes = take_counts(source, 2, encoding);
  if (n_blocks > source.bound()) source.fail("an array claims more blocks than the file holds");
  const auto packed = take_counts(source, static_cast<std::size_t>(n_blocks), encoding);

  struct Free {
    void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
  };
  const std::unique_ptr<libdeflate_decompressor, Free> decompressor(libdeflate_alloc_decompressor());
  if (!decompressor) throw std::bad_alloc();
  std::string out;
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const std::uint64_t size = i + 1 == packed.size() && sizes[1] != 0 ? sizes[1] : sizes[0];
    if (packed[i] > source.bound()) source.fail("a compressed block claims more bytes than the file holds");
    if (size > most - out.size()) source.fail("the arrays claim more bytes than a mesh of such a file can take");
    const std::string block = source.take(static_cast<std::size_t>(packed[i]));
    const std::size_t start = out.size();
    out.resize(start + static_cast<std::size_t>(size));
    const auto result = libdeflate_zlib_decompress(decompressor.get(), block.data(), block.size(), out.data() + start,
                                                   static_cast<std::size_t>(size), nullptr);
    if (result != LIBDEFLATE_SUCCESS) source.fail("a compressed block is damaged");
  }
  return out;
}

/// Numbers that are no whole number of 64 bits become -1, which no index is.
template <class T, class Stored>
T cast(Stored value) {
  if constexpr (std::is_floating_point_v<Stored> && std::is_integral_v<T>) {
    constexpr auto kBound = static_cast<Stored>(0x1p62);
    return value > -kBound && value < kBound ? static_cast<T>(value) : T{-1};
  } else {
    return static_cast<T>(value);
  }
}

template <class Stored, class T>
std::vector<T> converted(std::string_view bytes, bool swapped) {
  std::vector<T> out(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = cast<T>(value_at<Stored>(bytes.data() + i * sizeof(Stored), swapped));
  return out;
}

}  // namespace

std::string vtk_binary(std::string_view text, bool is_base64, const VtkEncoding& encoding, std::size_t most,
                       const SourceFile& file, std::size_t at) {
  ByteSource source(text, is_base64, file, at);
  if (encoding.compressed) return inflated(source, encoding, most);
  const std::uint64_t size = take_counts(source, 1, encoding)[0];
  if (size > std::min<std::uint64_t>(source.bound(), most))
    source.fail("an array claims more bytes than the file holds");
  return source.take(static_cast<std::size_t>(size));
}

template <class T>
std::vector<T> vtk_values(std::string_view bytes, std::string_view type, bool swapped, const SourceFile& file,
                          std::size_t at) {
  if (type == "Float64") return converted<double, T>(bytes, swapped);
  if (type == "Float32") return converted<float, T>(bytes, swapped);
  if (type == "Int64") return converted<std::int64_t, T>(bytes, swapped);
  if (type == "UInt64") return converted<std::uint64_t, T>(bytes, swapped);
  if (type == "Int32") return converted<std::int32_t, T>(bytes, swapped);
  if (type == "UInt32") return converted<std::uint32_t, T>(bytes, swapped);
  if (type == "Int16") return converted<std::int16_t, T>(bytes, swapped);
  if (type == "UInt16") return converted<std::uint16_t, T>(bytes, swapped);
  if (type == "Int8") return converted<std::int8_t, T>(bytes, swapped);
  if (type == "UInt8") return converted<std::uint8_t, T>(bytes, swapped);
  file.fail_at_byte(at, "arrays of type '" + std::string(type.substr(0, 20)) + "' are not read");
}

template std::vector<double> vtk_values(std::string_view, std::string_view, bool, const SourceFile&, std::size_t);
template std::vector<std::int64_t> vtk_values(std::string_view, std::string_view, bool, const SourceFile&, std::size_t);

std::array<NodeIndex, 4> checked_nodes(const VtkCellNodes& cell, std::size_t first, std::size_t count,
                                       const SourceFile& file) {
  const std::size_t expected = cell.type == kVtkVertex     ? 1
                               : cell.type == kVtkLine     ? 2
                               : cell.type == kVtkTriangle ? 3
                               : cell.type == kVtkQuad     ? 4
                                                           : 0;
  if (expected == 0)
    file.fail("cell type " + std::to_string(cell.type) + " is not read: vertices, lines, triangles and quads are");
  if (cell.n_nodes != expected) file.fail("a cell has a wrong number of nodes");
  std::array<NodeIndex, 4> out{};
  for (std::size_t i = 0; i < expected; ++i) {
    if (cell.nodes[i] < 0 || static_cast<std::uint64_t>(cell.nodes[i]) >= count)
      file.fail("a cell names node " + std::to_string(cell.nodes[i]) + ", which is not there");
    out[i] = static_cast<NodeIndex>(first + static_cast<std::size_t>(cell.nodes[i]));
  }
  return out;
}

}  // namespace quadline
