// Atomic writes of files, progress, memory, text, disjoint sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include "fieldfab/core/colour.h"
#include "fieldfab/core/copy_of_process.h"
#include "fieldfab/core/disjoint_sets.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/core/text.h"

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

TEST(ProgressOf, ManySmallStepsIsToldByThePercent) {
  std::vector<std::pair<double, std::string>> told;
  Progress progress([&](double fraction, const std::string& stage) { told.emplace_back(fraction, stage); });
  constexpr int steps = 1'000'000;
  const auto began = std::chrono::steady_clock::now();
  for (const char* stage : {"one", "another"})
    for (int i = 1; i <= steps; ++i) progress.report(static_cast<double>(i) / steps, stage);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
  EXPECT_GE(told.size(), 200U);
  EXPECT_LE(told.size(), 204U + static_cast<std::size_t>(took.count() / 5));
  EXPECT_EQ(told.front().second, "one");
  EXPECT_EQ(told.back(), std::pair(1.0, std::string("another")));
  const auto next = std::find_if(told.begin(), told.end(), [](const auto& each) { return each.second == "another"; });
  EXPECT_EQ(std::prev(next)->first, 1);
  EXPECT_EQ(next->first, 1.0 / steps);
}

TEST(ProgressOf, WorkThatOnlyChecksCanBeCancelledByItsListener) {
  int told = 0;
  Progress* work = nullptr;
  Progress progress([&](double fraction, const std::string& doing) {
    EXPECT_EQ(fraction, 0.25);
    EXPECT_EQ(doing, "a quarter");
    if (++told == 3) work->cancel();
  });
  work = &progress;
  progress.report(0.25, "a quarter");
  EXPECT_THROW(
      while (told < 1000) {
        progress.check();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      },
      Error);
  EXPECT_EQ(told, 3);
}

TEST(CopyOfProcess, EndsInThePlaceOfThisOne) {
  int made = 0;
  EXPECT_EQ(run_in_copy([&] { ++made; }, Progress::none()), CopyEnd::completed);
  EXPECT_EQ(made, 0);
  EXPECT_EQ(run_in_copy([] { throw Error(ErrorKind::bad_input, "a", "b"); }, Progress::none()), CopyEnd::completed);
  EXPECT_EQ(run_in_copy([] { std::abort(); }, Progress::none()), CopyEnd::crashed);
  EXPECT_EQ(run_in_copy([] { std::raise(SIGSEGV); }, Progress::none()), CopyEnd::crashed);
}

TEST(CopyOfProcess, IsGivenUpIfItWaitsForLong) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "a thread of the sanitizer uses the processor in the copy";
#endif
  const auto wait = [] { std::this_thread::sleep_for(std::chrono::minutes(10)); };
  EXPECT_EQ(run_in_copy(wait, Progress::none()), CopyEnd::unknown);
}

TEST(CopyOfProcess, KilledByTheSystemMeansTooLittleMemory) {
  try {
    run_in_copy([] { std::raise(SIGKILL); }, Progress::none());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::too_large);
  }
}

TEST(CopyOfProcess, IsKilledWhenTheWorkIsCancelled) {
  Progress progress;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    progress.cancel();
  });
  const auto sleep = [] { std::this_thread::sleep_for(std::chrono::minutes(1)); };
  EXPECT_THROW(run_in_copy(sleep, progress), Error);
  canceller.join();
}

TEST(Memory, RefusesWhatIsNotThere) {
  EXPECT_GT(available_memory(), 1U << 20);
  EXPECT_THROW(require_memory(std::uintmax_t{1} << 60, "a test"), Error);
  EXPECT_NO_THROW(require_memory(1000, "a test"));
}

TEST(Colours, HaveNamesAndNumbers) {
  EXPECT_EQ(colour_named("red"), (Colour{255, 0, 0}));
  EXPECT_EQ(colour_named("RebeccaPurple"), (Colour{0x66, 0x33, 0x99}));
  EXPECT_EQ(colour_named("aliceblue"), (Colour{0xf0, 0xf8, 0xff}));
  EXPECT_EQ(colour_named("yellowgreen"), (Colour{0x9a, 0xcd, 0x32}));
  EXPECT_EQ(colour_named("#1aF"), (Colour{0x11, 0xaa, 0xff}));
  EXPECT_EQ(colour_named("#0180fe"), (Colour{1, 128, 254}));
  EXPECT_EQ(text_of({1, 128, 254}), "#0180fe");
  for (int i = 0; i < 256; ++i) {
    const auto channel = static_cast<std::uint8_t>(i);
    const Colour colour{channel, static_cast<std::uint8_t>(255 - i), static_cast<std::uint8_t>(7 * i)};
    EXPECT_EQ(colour_of_hex(text_of(colour)), colour);
  }
  EXPECT_EQ(colour_of_hex("red"), std::nullopt);
}

TEST(Colours, ThatAreUnknownAreRefusedInOneLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"blurple", "unknown colour 'blurple'; a CSS name or #rrggbb; did you mean 'purple'?"},
      {"Darkgrean", "unknown colour 'Darkgrean'; a CSS name or #rrggbb; did you mean 'darkgreen'?"},
      {"", "unknown colour ''; a CSS name or #rrggbb"},
      {"#", "unknown colour '#'; a CSS name or #rrggbb"},
      {"#12345", "unknown colour '#12345'; a CSS name or #rrggbb"},
      {"#-12345", "unknown colour '#-12345'; a CSS name or #rrggbb"},
      {"#12345g", "unknown colour '#12345g'; a CSS name or #rrggbb"},
      {"#00ff00ff", "unknown colour '#00ff00ff'; a CSS name or #rrggbb"},
      {"123456", "unknown colour '123456'; a CSS name or #rrggbb"},
      {"a\nlong\xff way", "unknown colour 'a long\uFFFD way'; a CSS name or #rrggbb"}};
  for (const auto& [text, message] : cases) {
    try {
      colour_named(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_EQ(error.what(), message);
    }
  }
}

TEST(Text, IsOneLineOfValidCharacters) {
  EXPECT_EQ(printable("Ø 3 mm – ✓ 😀"), "Ø 3 mm – ✓ 😀");
  EXPECT_EQ(printable("a\tb\nc\x7f"), "a b c ");
  EXPECT_EQ(printable("\xcd\x35|\xc0\x80\xed\xa0\x80\xf5"), "\uFFFD5|\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(printable("\xe2\x82"), "\uFFFD\uFFFD");  // a truncated character at the end
  std::mt19937 random(1);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int n = 0; n < 2000; ++n) {
    std::string bytes(static_cast<std::size_t>(n % 40), 0);
    for (char& c : bytes)
      c = static_cast<char>(n % 2 ? byte(random) : "\xf0\x9f\x98\x80\xe2\x82\xac\xc3\xa4z"[byte(random) % 10]);
    const std::string line = printable(bytes);
    EXPECT_NO_THROW((void)nlohmann::json(line).dump());  // the library rejects invalid UTF-8
    EXPECT_EQ(printable(line), line);
    bool valid = true;
    try {
      (void)nlohmann::json(bytes).dump();
    } catch (const nlohmann::json::exception&) {
      valid = false;
    }
    EXPECT_EQ(valid, line.find("\uFFFD") == std::string::npos) << n;
  }
}

TEST(DisjointSets, AreKnownByTheirLeastMember) {
  constexpr std::uint32_t count = 60;
  std::mt19937 random(3);
  std::uniform_int_distribution<std::uint32_t> any(0, count - 1);
  DisjointSets sets(count);
  std::vector<std::uint32_t> least(count);  // the same by renumbering, slow and obvious
  std::iota(least.begin(), least.end(), 0U);
  for (int n = 0; n < 80; ++n) {
    const std::uint32_t a = any(random), b = any(random), low = std::min(least[a], least[b]),
                        high = std::max(least[a], least[b]);
    sets.unite(a, b);
    std::replace(least.begin(), least.end(), high, low);
    for (std::uint32_t v = 0; v < count; ++v) ASSERT_EQ(sets.find(v), least[v]) << n << " " << v;
  }
}

}  // namespace
// The outer loop fails while inner ones are at work: those are complete when they return.
TEST(ParallelFor, IsCompleteWithinALoopThatFails) {
  constexpr std::size_t outer = 8, inner = 2000;
  std::atomic<int> incomplete = 0, returned = 0;
  for (int round = 0; round < 20; ++round) {
    const auto fail_beside_others = [&] {
      parallel_for(outer, [&](std::size_t i) {
        if (i == outer / 2) throw std::runtime_error("one of them");
        std::atomic<std::size_t> calls = 0;
        parallel_for(inner, [&](std::size_t) {
          std::this_thread::sleep_for(std::chrono::microseconds(1));
          ++calls;
        });
        ++returned;
        if (calls != inner) ++incomplete;
      });
    };
    EXPECT_THROW(fail_beside_others(), std::runtime_error);
  }
  EXPECT_GT(returned, 0);
  EXPECT_EQ(incomplete, 0);
}

}  // namespace fieldfab
