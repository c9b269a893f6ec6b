#pragma once

#include <filesystem>
#include <string_view>

namespace quadline {

/// A file that appears whole or not at all: written beside its target, put in place by `commit`.
///
/// Until then, and where anything fails, whatever stood there before still stands. A link is followed, so that the file
/// it points at changes; the rights of a file that is replaced are kept. What is no plain file (a pipe, a terminal,
/// /dev/null, or what the process holds open as /dev/stdout or /dev/fd/3) is written straight away, for there is
/// nothing to keep. A signal that is caught ends the wait for the reader of a pipe, as an error.
class AtomicFile {
 public:
  /// @throws OutputError  the target is a folder or may not be written, or its folder is missing or may not be written.
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile();  ///< throws away what was not committed
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// @throws OutputError  the disk is full, or the like.
  void write(std::string_view bytes);
  /// Puts the file in place. Nothing may be written afterwards.
  /// @throws OutputError  as `write`.
  void commit();

 private:
  [[noreturn]] void fail(int reason) const;
  void open_in_place();
  void check_descriptor() const;
  void open_beside();

  std::filesystem::path target_;     ///< as given, for messages
  std::filesystem::path place_;      ///< where links lead
  std::filesystem::path temporary_;  ///< empty: written straight away
  int descriptor_ = -1;              ///< of this process, that the target stands for: /dev/stdout, /dev/fd/3
  bool is_stream_ = false;
  int file_ = -1;
};

/// Writes a whole file so.
/// @throws OutputError  the file cannot be written; what stood there before still stands.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

/// Finds out early what `write_atomically` would run into: before work that would be lost. Leaves nothing behind.
/// @throws OutputError  as the constructor of AtomicFile.
void check_can_write(const std::filesystem::path& file);

}  // namespace quadline
