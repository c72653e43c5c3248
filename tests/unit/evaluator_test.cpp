// Evaluators: equal results for all models, machine code that is never writable, and failure of
// memory allocation.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::frep {
namespace {

namespace s = shapes;

struct Samples {
  std::vector<float> x, y, z;
  Samples(std::size_t count, float reach) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> anywhere(-reach, reach);
    for (std::size_t i = 0; i < count; ++i)
      x.push_back(anywhere(random)), y.push_back(anywhere(random)), z.push_back(anywhere(random));
  }
  [[nodiscard]] Points points() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

/// Values and gradients in sequence, as bits, without regard to kinds of NaN and the sign of zero.
std::vector<float> all_numbers(const Field& field, const Samples& samples) {
  const std::size_t n = samples.x.size();
  std::vector<float> out(5 * n);
  field.values(samples.points(), out.data());
  field.gradients(samples.points(), out.data() + n, {out.data() + 2 * n, out.data() + 3 * n, out.data() + 4 * n});
  for (float& number : out) number = number != number ? 12345.0F : number + 0.0F;
  return out;
}

std::vector<Evaluator> those_there_are() {
  std::vector<Evaluator> all;
  for (int i = 1; i <= static_cast<int>(Evaluator::jit_avx512); ++i)
    if (available(static_cast<Evaluator>(i))) all.push_back(static_cast<Evaluator>(i));
  return all;
}

TEST(Evaluators, AgreeOnEveryModel) {
  int models = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TEST_DATA "/frep")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".math" && extension != ".vm") continue;
    ++models;
    const std::string text = read_file(entry.path());
    const Expression expression = extension == ".vm" ? parse_vm(text) : parse_math(text);
    const Samples samples(203, 2);
    const std::vector<float> expected = all_numbers(*make_field(expression, Evaluator::reference), samples);
    for (const Evaluator evaluator : those_there_are())
      ASSERT_EQ(all_numbers(*make_field(expression, evaluator), samples), expected)
          << entry.path() << ' ' << name(evaluator);
  }
  EXPECT_GT(models, 50);
}

TEST(Evaluators, ManySlotsAndFewPointsAgree) {
  // More live values than registers, and batches that do not fill a vector.
  Expression sum = 0.0;
  std::vector<Expression> alive;
  for (int i = 0; i < 60; ++i)
    alive.push_back(sqrt(square(Expression::x() - i * 0.1) + square(Expression::y() + i * 0.2)) * Expression::z());
  for (const Expression& part : alive) sum = sum + sin(part);
  for (std::size_t i = alive.size(); i-- > 0;) sum = min(sum, alive[i] * alive[alive.size() - 1 - i]);
  for (const std::size_t count : {1, 7, 8, 9, 15, 16, 17, 33, 1000}) {
    const Samples samples(count, 3);
    const std::vector<float> expected = all_numbers(*make_field(sum, Evaluator::reference), samples);
    for (const Evaluator evaluator : those_there_are())
      ASSERT_EQ(all_numbers(*make_field(sum, evaluator), samples), expected) << count << ' ' << name(evaluator);
  }
}

TEST(Evaluators, AutomaticCompilesWhatIsUsedMuchAndGivesTheSame) {
  const Expression torus = s::twist(s::torus(2, 0.5), 0.3);
  const FieldPtr field = make_field(torus);
  const Samples samples(5000, 3);
  const std::vector<float> expected = all_numbers(*make_field(torus, Evaluator::reference), samples);
  for (int round = 0; round < 100; ++round) ASSERT_EQ(all_numbers(*field, samples), expected);
}

TEST(Evaluators, HaveNames) {
  for (const Evaluator evaluator : those_there_are()) EXPECT_EQ(evaluator_named(name(evaluator)), evaluator);
  EXPECT_THROW(evaluator_named("abacus"), Error);
  if (!available(Evaluator::avx512)) {
    EXPECT_THROW(make_field(Expression::x(), Evaluator::avx512), Error);
    EXPECT_THROW(make_field(Expression::x(), Evaluator::jit_avx512), Error);
  }
}

#if defined(__x86_64__)

Evaluator machine_code() { return available(Evaluator::jit_avx512) ? Evaluator::jit_avx512 : Evaluator::jit_avx2; }

/// Number of anonymous memory pages of this process with the given permissions.
int anonymous_pages(const char* permissions) {
  std::ifstream maps("/proc/self/maps");
  int found = 0;
  for (std::string line; std::getline(maps, line);)
    found += line.find(permissions) != std::string::npos && line.find('/') == std::string::npos &&
             line.find('[') == std::string::npos;
  return found;
}

TEST(MachineCode, IsNeverWritableAndExecutable) {
  ASSERT_TRUE(available(machine_code()));
  const int before = anonymous_pages(" r-xp ");
  const FieldPtr field = make_field(s::sphere(1), machine_code());
  EXPECT_EQ(field->value({0, 0, 3}), 2);
  EXPECT_GT(anonymous_pages(" r-xp "), before);
  EXPECT_EQ(anonymous_pages("rwx"), 0);
}

/// Exits the process with 0 if a machine-code evaluator gives correct numbers although memory can
/// no longer be allocated.
[[noreturn]] void evaluate_without_memory() {
  const Samples samples(64, 2);
  const std::vector<float> expected = all_numbers(*make_field(s::torus(1, 0.2), Evaluator::portable), samples);
  const FieldPtr field = make_field(s::torus(1, 0.2), machine_code()), again = make_field(s::sphere(1), machine_code());
  const rlimit none{0, 0};
  setrlimit(RLIMIT_AS, &none);
  std::_Exit(all_numbers(*field, samples) == expected && again->value({0, 0, 3}) == 2 ? 0 : 1);
}

TEST(MachineCode, IsDoneWithoutWhereThereIsNoMemoryForIt) {
  if (dlsym(RTLD_DEFAULT, "__asan_init") != nullptr) GTEST_SKIP() << "the address sanitizer needs memory of its own";
  EXPECT_EXIT(evaluate_without_memory(), testing::ExitedWithCode(0),
              "^fieldfab: no executable memory [^\n]*; formulas are interpreted instead\n$");
}

#endif

}  // namespace
}  // namespace fieldfab::frep
