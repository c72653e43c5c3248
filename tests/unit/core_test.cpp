// Files written whole or not at all, progress, memory.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/progress.h"

namespace fieldfab {
namespace {

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("fieldfab_core_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
  }
  std::filesystem::path folder;
};

TEST_F(Files, AreLeftAloneWithoutCommit) {
  write_file(folder / "kept.txt", "before");
  {
    PendingFile pending(folder / "kept.txt");
    pending.write("after");
  }
  EXPECT_EQ(read_file(folder / "kept.txt"), "before");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Files, AreReplacedWholeByCommit) {
  write_file(folder / "kept.txt", "before");
  PendingFile pending(folder / "kept.txt");
  pending.write("aXter");
  pending.rewrite(1, "f", 1);
  pending.commit();
  EXPECT_EQ(read_file(folder / "kept.txt"), "after");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Files, SayWhatIsWrong) {
  EXPECT_THROW(read_file(folder / "absent"), Error);
  EXPECT_THROW(read_file(folder), Error);
  EXPECT_THROW(write_file(folder / "no" / "such" / "folder", ""), Error);
  write_file(folder / "long", std::string(100, 'x'));
  try {
    read_file(folder / "long", 99);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::too_large);
    EXPECT_EQ(error.place(), (folder / "long").string());
  }
}

TEST_F(Files, FullDiskIsAnErrorAndTheDeviceStays) {
  if (!std::filesystem::exists("/dev/full")) GTEST_FAIL() << "this system lacks /dev/full";
  EXPECT_THROW(write_file("/dev/full", std::string(1 << 21, 'x')), Error);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(ProgressOf, WorkIsReportedAndCancelled) {
  double last = 0;
  Progress progress([&](double fraction, const std::string&) { last = fraction; });
  progress.report(0.5, "half");
  EXPECT_EQ(last, 0.5);
  EXPECT_NO_THROW(progress.check());
  progress.cancel();
  EXPECT_THROW(progress.check(), Error);
}

TEST(Memory, RefusesWhatIsNotThere) {
  EXPECT_GT(available_memory(), 1U << 20);
  EXPECT_THROW(require_memory(std::uintmax_t{1} << 60, "a test"), Error);
  EXPECT_NO_THROW(require_memory(1000, "a test"));
}

}  // namespace
}  // namespace fieldfab
