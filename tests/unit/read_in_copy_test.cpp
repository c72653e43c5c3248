// Reading by libraries in a copy of the process: what arrives, and what a library's faults do.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <thread>
#include <vector>

#include "volume/read_in_copy.h"

namespace fieldfab {
namespace {

Samples samples_of(int nx, int ny, int nz) {
  Samples samples;
  samples.lattice.size = {nx, ny, nz};
  samples.lattice.spacing = {0.5, 0.75, 1};
  samples.lattice.origin = {1, 2, 3};
  samples.lattice.axes.col(0) = Vec3(0, 1, 0);
  samples.type = SampleType::int16;
  samples.own_threshold = 12.5;
  return samples;
}

/// The error of a reader.
Error error_of(const Reader& reader) {
  try {
    read_in_copy("scan.abc", "Library", reader, Progress::none());
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorKind::internal, "", "none was thrown");
}

TEST(ReadInCopy, HandsOverWhatWasRead) {
  const Samples told = samples_of(30, 20, 10);
  const auto read = [&](const Room& room) {
    float* const densities = room(told.lattice.count());
    for (std::size_t i = 0; i < told.lattice.count(); ++i) densities[i] = static_cast<float>(i) / 3;
    return told;
  };
  const VolumePtr volume = volume_read_in_copy("scan.abc", "Library", read, Progress::none());
  EXPECT_EQ(volume->lattice().size, told.lattice.size);
  EXPECT_EQ(volume->lattice().spacing, told.lattice.spacing);
  EXPECT_EQ(volume->lattice().origin, told.lattice.origin);
  EXPECT_EQ(volume->lattice().axes, told.lattice.axes);
  EXPECT_EQ(volume->type(), SampleType::int16);
  EXPECT_EQ(volume->own_threshold(), 12.5);
  const std::vector<float> densities = read_all(*volume);
  for (std::size_t i = 0; i < densities.size(); ++i) ASSERT_EQ(densities[i], static_cast<float>(i) / 3);
}

TEST(ReadInCopy, ReadsHeadersAlone) {
  const auto [samples, densities] = read_in_copy(
      "scan.abc", "Library", [](const Room&) { return samples_of(3, 4, 5); }, Progress::none());
  EXPECT_EQ(samples.lattice.count(), 60U);
  EXPECT_EQ(densities, nullptr);
}

TEST(ReadInCopy, OverwritesNothingHere) {
  std::vector<char> here(64, 'a');
  const auto read = [&](const Room& room) {
    room(8);
    std::memset(here.data(), 'b', here.size());
    return samples_of(2, 2, 2);
  };
  EXPECT_NE(read_in_copy("scan.abc", "Library", read, Progress::none()).densities, nullptr);
  EXPECT_EQ(here, std::vector<char>(64, 'a'));
}

TEST(ReadInCopy, ACrashIsAnErrorOfTheFile) {
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE}) {
    const Error error = error_of([&](const Room& room) {
      room(1000)[0] = 1;
      std::raise(signal);
      return samples_of(10, 10, 10);
    });
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_STREQ(error.what(), "scan.abc: is damaged: Library, which reads it, gives up at it");
  }
}

TEST(ReadInCopy, ErrorsComeAcross) {
  const Error refused = error_of([](const Room&) -> Samples { refuse("other.raw", "is: too short"); });
  EXPECT_STREQ(refused.what(), "other.raw: is: too short");
  EXPECT_EQ(refused.place(), "other.raw");
  EXPECT_EQ(refused.kind(), ErrorKind::bad_input);
  const Error placeless = error_of([](const Room&) -> Samples { throw Error(ErrorKind::too_large, "", "8 GB"); });
  EXPECT_STREQ(placeless.what(), "8 GB");
  EXPECT_EQ(placeless.kind(), ErrorKind::too_large);
  const Error strange = error_of([](const Room&) -> Samples { throw std::runtime_error("of a library"); });
  EXPECT_EQ(strange.kind(), ErrorKind::bad_input);
  const Error far_too_long = error_of([](const Room&) -> Samples { refuse("a", std::string(100'000, 'x')); });
  EXPECT_EQ(std::string(far_too_long.what()).substr(0, 5), "a: xx");
  EXPECT_THROW(read_in_copy(
                   "scan.abc", "Library", [](const Room&) -> Samples { throw std::bad_alloc(); }, Progress::none()),
               std::bad_alloc);
  EXPECT_EQ(error_of([](const Room& room) {
              room(std::size_t{1} << 50);
              return samples_of(2, 2, 2);
            }).kind(),
            ErrorKind::too_large);
}

TEST(ReadInCopy, IsEndedByCancellation) {
  Progress progress;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    progress.cancel();
  });
  const auto read = [](const Room&) {
    std::this_thread::sleep_for(std::chrono::minutes(1));
    return samples_of(2, 2, 2);
  };
  EXPECT_THROW(read_in_copy("scan.abc", "Library", read, progress), Error);
  canceller.join();
}

}  // namespace
}  // namespace fieldfab
