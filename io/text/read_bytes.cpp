#include "io/text/read_bytes.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "quadline/errors.hpp"

namespace quadline {

std::string read_bytes(const std::filesystem::path& file) {
  const auto fail = [&](int reason) {
    throw InputError(ErrorCode::FileUnreadable, "cannot be read: " + std::generic_category().message(reason),
                     Where{file.string(), {}, {}});
  };
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  const std::unique_ptr<std::FILE, Close> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) fail(errno);
  std::string bytes;
  std::array<char, 1 << 16> piece;
  while (const std::size_t n = std::fread(piece.data(), 1, piece.size(), stream.get())) bytes.append(piece.data(), n);
  if (std::ferror(stream.get())) fail(errno);
  return bytes;
}

}  // namespace quadline
