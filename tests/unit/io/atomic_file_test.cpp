#include "io/text/atomic_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "quadline/errors.hpp"

namespace quadline {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class AtomicFileTest : public testing::Test {
 protected:
  AtomicFileTest() {
    std::string name = (fs::temp_directory_path() / "quadline-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~AtomicFileTest() override { fs::remove_all(folder_); }

  static void put(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
  static std::string get(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static std::string failure(const fs::path& file) {
    try {
      write_atomically(file, "new");
    } catch (const OutputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(AtomicFileTest, WritesAndReplaces) {
  const fs::path file = folder_ / "mesh.vtu";
  write_atomically(file, std::string("a\0b\n", 4));
  EXPECT_EQ(get(file), std::string("a\0b\n", 4));
  write_atomically(file, "shorter");
  EXPECT_EQ(get(file), "shorter");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(AtomicFileTest, LeavesWhatStoodThereUntilItIsCommitted) {
  const fs::path file = folder_ / "mesh.vtu";
  put(file, "old");
  {
    AtomicFile out(file);
    out.write("half of the ");
    EXPECT_EQ(get(file), "old");
  }
  EXPECT_EQ(get(file), "old");
  EXPECT_EQ(file_count(), 1u);
  AtomicFile out(file);
  out.write("one ");
  out.write("two");
  out.commit();
  EXPECT_EQ(get(file), "one two");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(AtomicFileTest, CheckingLeavesNothingBehind) {
  const fs::path file = folder_ / "mesh.vtu";
  check_can_write(file);
  EXPECT_EQ(file_count(), 0u);
  put(file, "old");
  check_can_write(file);
  EXPECT_EQ(get(file), "old");
  EXPECT_THROW(check_can_write(folder_), OutputError);
}

TEST_F(AtomicFileTest, SaysWhatIsInTheWay) {
  const fs::path missing = folder_ / "none" / "mesh.vtu";
  EXPECT_EQ(failure(missing), missing.string() + ": cannot be written: its folder does not exist");
  EXPECT_EQ(failure(folder_), folder_.string() + ": cannot be written: it is a folder");
  EXPECT_EQ(failure(folder_ / ""), (folder_ / "").string() + ": cannot be written: it is a folder");
  put(folder_ / "file", "");
  EXPECT_EQ(failure(folder_ / "file" / "mesh.vtu"),
            (folder_ / "file" / "mesh.vtu").string() + ": cannot be written: Not a directory");
  EXPECT_NE(failure(folder_ / std::string(300, 'x')).find("File name too long"), std::string::npos);
  EXPECT_NE(failure("").find("cannot be written"), std::string::npos);
}

TEST_F(AtomicFileTest, SaysThatTheDiskIsFull) {
  EXPECT_EQ(failure("/dev/full"), "/dev/full: cannot be written: No space left on device");
}

TEST_F(AtomicFileTest, WritesToDevicesInPlace) {
  struct stat before{}, after{};
  ASSERT_EQ(stat("/dev/null", &before), 0);
  write_atomically("/dev/null", "anything");
  ASSERT_EQ(stat("/dev/null", &after), 0);
  EXPECT_TRUE(S_ISCHR(after.st_mode));
  EXPECT_EQ(after.st_ino, before.st_ino);
}

TEST_F(AtomicFileTest, GoesOnWhereAnOpenDescriptorStands) {
  const fs::path file = folder_ / "log";
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(write(descriptor, "before ", 7), 7);
  write_atomically("/dev/fd/" + std::to_string(descriptor), "mesh");
  ASSERT_EQ(write(descriptor, " after", 6), 6);
  EXPECT_EQ(get(file), "before mesh after");
  close(descriptor);
  EXPECT_NE(failure("/dev/fd/" + std::to_string(descriptor)).find("cannot be written"), std::string::npos);
}

TEST_F(AtomicFileTest, WritesToAPipe) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  write_atomically("/proc/self/fd/" + std::to_string(ends[1]), "mesh");
  char text[5] = {};
  EXPECT_EQ(read(ends[0], text, 4), 4);
  EXPECT_STREQ(text, "mesh");
  EXPECT_NE(failure("/dev/fd/" + std::to_string(ends[0])).find("Bad file descriptor"), std::string::npos);
  close(ends[0]);
  close(ends[1]);
}

TEST_F(AtomicFileTest, FollowsLinks) {
  fs::create_directory(folder_ / "data");
  put(folder_ / "data" / "mesh.vtu", "old");
  fs::create_symlink("data/mesh.vtu", folder_ / "link.vtu");
  fs::create_symlink("data/later.vtu", folder_ / "dangling.vtu");
  fs::create_symlink("circle.vtu", folder_ / "circle.vtu");
  write_atomically(folder_ / "link.vtu", "new");
  write_atomically(folder_ / "dangling.vtu", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.vtu"));
  EXPECT_EQ(get(folder_ / "data" / "mesh.vtu"), "new");
  EXPECT_EQ(get(folder_ / "data" / "later.vtu"), "new");
  EXPECT_NE(failure(folder_ / "circle.vtu").find("symbolic links"), std::string::npos);
}

TEST_F(AtomicFileTest, KeepsTheRightsOfTheFile) {
  const fs::path file = folder_ / "mesh.vtu";
  put(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  write_atomically(file, "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST_F(AtomicFileTest, RespectsReadOnlyFiles) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const fs::path file = folder_ / "mesh.vtu";
  put(file, "old");
  fs::permissions(file, fs::perms::owner_read);
  EXPECT_EQ(failure(file), file.string() + ": cannot be written: Permission denied");
  EXPECT_EQ(get(file), "old");
}

}  // namespace
}  // namespace quadline
