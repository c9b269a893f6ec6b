#include "io/text/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "io/text/number_text.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace fs = std::filesystem;

namespace {

/// The number of /dev/fd/3 or /proc/self/fd/3; -1 for other places.
int descriptor_at(const fs::path& place) {
  const fs::path folder = place.parent_path();
  if (folder != "/proc/self/fd" && folder != "/dev/fd") return -1;
  return parse_number<int>(place.filename().string()).value_or(-1);
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& target) : target_(target), place_(target) {
  if (target.empty()) fail(ENOENT);
  std::error_code error;
  // A link whose target is missing is followed too: the file shall appear where it points.
  for (int hops = 0; fs::is_symlink(place_, error); ++hops) {
    descriptor_ = descriptor_at(place_);
    if (descriptor_ >= 0) {
      check_descriptor();
      return;
    }
    if (hops == 40) fail(ELOOP);
    const fs::path next = fs::read_symlink(place_, error);
    if (error) fail(error.value());
    place_ = next.is_absolute() ? next : place_.parent_path() / next;
  }
  struct stat old{};
  const bool is_there = ::stat(place_.c_str(), &old) == 0;
  if (!is_there && errno != ENOENT) fail(errno);
  if (!is_there && !place_.has_filename()) fail(EISDIR);
  if (is_there && S_ISDIR(old.st_mode)) fail(EISDIR);
  if (is_there && ::access(place_.c_str(), W_OK) != 0) fail(errno);
  if (is_there && !S_ISREG(old.st_mode)) return;  // opened late: to open a pipe waits for its reader
  open_beside();
  if (is_there) ::fchmod(file_, old.st_mode & 07777);  // where it may not be kept, the usual rights are no failure
}

/// To open it by its name would start at the front of a file that others have written to, and not work for a socket.
void AtomicFile::check_descriptor() const {
  const int flags = ::fcntl(descriptor_, F_GETFL);
  if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) fail(EBADF);
}

void AtomicFile::open_in_place() {
  file_ = descriptor_ >= 0 ? ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0) : ::open(place_.c_str(), O_WRONLY | O_CLOEXEC);
  struct stat status{};
  if (file_ < 0 || ::fstat(file_, &status) != 0) fail(errno);
  is_stream_ = !S_ISREG(status.st_mode);
}

void AtomicFile::open_beside() {
  const std::string stem = ".quadline-" + std::to_string(::getpid()) + "-";
  for (int i = 0;; ++i) {
    const fs::path name = place_.parent_path() / (stem + std::to_string(i) + ".tmp");
    file_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ >= 0) {
      temporary_ = name;
      return;
    }
    if (errno != EEXIST) fail(errno);
  }
}

AtomicFile::~AtomicFile() {
  if (file_ >= 0) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  if (file_ < 0) open_in_place();
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), std::min(bytes.size(), std::size_t{1} << 30));
    if (written < 0 && (errno != EINTR || is_stream_)) fail(errno);  // the reader of a stream may never come
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  if (file_ < 0) open_in_place();
  const int file = std::exchange(file_, -1);
  if (::close(file) != 0) fail(errno);  // some file systems tell only now that the disk is full
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), place_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void AtomicFile::fail(int reason) const {
  std::string why = std::generic_category().message(reason);
  if (reason == ENOENT) why = "its folder does not exist";
  if (reason == EISDIR) why = "it is a folder";
  throw OutputError("cannot be written: " + why, Where{target_.string(), {}, {}});
}

void write_atomically(const fs::path& file, std::string_view bytes) {
  AtomicFile out(file);
  out.write(bytes);
  out.commit();
}

void check_can_write(const fs::path& file) { const AtomicFile out(file); }

}  // namespace quadline
