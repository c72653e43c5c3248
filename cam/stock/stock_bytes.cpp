#include "stock_bytes.h"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <sstream>

#include "brick.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

constexpr std::string_view magic = "FFSTOCK\n";
constexpr std::uint32_t version = 1;
constexpr std::size_t header_size = magic.size() + 16;  // version, checksum, size of the unpacked data
static_assert(std::endian::native == std::endian::little);

template <class Value>
void append(std::string& bytes, const Value& value) {
  static_assert(std::is_arithmetic_v<Value>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

[[noreturn]] void damaged(const std::string& place, const std::string& how) {
  throw Error(ErrorKind::bad_input, place, "is damaged or no saved stock: " + how);
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// State of the generator, through its text output.
std::uint32_t state_of(const std::minstd_rand& random) {
  std::stringstream text;
  text << random;
  std::uint32_t state = 0;
  text >> state;
  return state;
}

}  // namespace

/// Sequential reader of bytes that never passes the end.
struct StockBytes::Reader {
  std::string_view bytes;
  const std::string& place;
  std::size_t at = 0;

  [[nodiscard]] std::size_t left() const { return bytes.size() - at; }
  void take(void* to, std::size_t size) {
    if (size > left()) damaged(place, "it ends too early");
    if (size) std::memcpy(to, bytes.data() + at, size);
    at += size;
  }
  template <class Value>
  Value take() {
    Value value;
    take(&value, sizeof value);
    return value;
  }
  void expect(bool possible, const char* what) const {
    if (!possible) damaged(place, fmt::format("it has {} that cannot be", what));
  }
};

std::string StockBytes::of(const Stock& stock) {
  std::string bytes;
  const StockSettings& s = stock.settings_;
  const Box& box = stock.lattice_.box();
  for (const Vec3* const corner : {&box.lower, &box.upper})
    for (int a = 0; a < 3; ++a) append(bytes, (*corner)[a]);
  for (const double number : {s.cell, s.cell_height, s.tolerance}) append(bytes, number);
  append(bytes, static_cast<std::int32_t>(s.brick));
  append(bytes, static_cast<std::uint8_t>(s.both_ends));
  append(bytes, static_cast<std::uint8_t>(s.rules.size()));
  for (const SplitRule rule : s.rules) append(bytes, static_cast<std::uint8_t>(rule));
  for (const int cells : stock.lattice_.cells()) append(bytes, static_cast<std::int32_t>(cells));
  for (const auto& brick : stock.bricks_) put(*brick, bytes);
  return bytes;
}

void StockBytes::put(const Brick& brick, std::string& bytes) {
  append(bytes, state_of(brick.random_));
  for (const std::uint64_t count :
       {brick.tally_.direct, brick.tally_.indirect, brick.tally_.conflict, brick.tally_.halved})
    append(bytes, count);
  append(bytes, static_cast<std::uint64_t>(brick.tidied_));
  append(bytes, static_cast<std::uint64_t>(brick.samples_.slots()));
  append(bytes, static_cast<std::uint64_t>(brick.samples_.size()));
  brick.samples_.for_each([&](SampleMap::Key key, const Sample& sample) {
    append(bytes, key);
    append(bytes, sample.at);
    append(bytes, sample.cut);
  });
  append(bytes, static_cast<std::uint32_t>(brick.nodes_.size()));
  for (const Cell& cell : brick.nodes_) {
    append(bytes, static_cast<std::uint8_t>(cell.content));
    append(bytes, cell.axis);
    append(bytes, cell.facing);
    append(bytes, static_cast<std::int32_t>(cell.plane));
    append(bytes, static_cast<std::int32_t>(cell.children));
    for (const Cell::Ends* const ends : {&cell.upper, &cell.lower}) {
      append(bytes, static_cast<std::uint32_t>(ends->at.size()));
      bytes.append(reinterpret_cast<const char*>(ends->at.data()), ends->at.size() * sizeof(float));
      bytes.append(reinterpret_cast<const char*>(ends->cut.data()), ends->cut.size() * sizeof(std::uint32_t));
    }
  }
}

Stock StockBytes::read(std::string_view bytes, const std::string& place) {
  Reader reader{bytes, place};
  Box box;
  for (Vec3* const corner : {&box.lower, &box.upper})
    for (int a = 0; a < 3; ++a) (*corner)[a] = reader.take<double>();
  StockSettings s;
  for (double* const number : {&s.cell, &s.cell_height, &s.tolerance}) *number = reader.take<double>();
  s.brick = reader.take<std::int32_t>();
  const auto both_ends = reader.take<std::uint8_t>(), rules = reader.take<std::uint8_t>();
  s.both_ends = both_ends != 0;
  s.rules.clear();
  for (int i = 0; i < rules; ++i) {
    const auto rule = reader.take<std::uint8_t>();
    reader.expect(rule <= static_cast<std::uint8_t>(SplitRule::random_selection), "a rule");
    s.rules.push_back(static_cast<SplitRule>(rule));
  }
  reader.expect(box.valid() && box.size().minCoeff() > 0 && box.size().allFinite(), "a box");
  reader.expect(s.cell > 0 && std::isfinite(s.cell) && std::isfinite(s.cell_height) && s.tolerance >= 0 &&
                    std::isfinite(s.tolerance) && both_ends <= 1,
                "settings");
  const StockLattice lattice(box, s.cell, s.cell_height);
  double bricks = 1;
  const int along = s.brick > 0 ? s.brick : 1020;
  for (const int cells : lattice.cells()) {
    reader.expect(reader.take<std::int32_t>() == cells, "cells");
    bricks *= std::max(1, cells / std::min(along, 1020) + 1);
  }
  constexpr double least = 80;  // bytes of a brick
  reader.expect(bricks * least <= static_cast<double>(reader.left()), "fewer bricks than its box");
  Stock stock(lattice, s);
  for (std::size_t i = 0; i < stock.bricks_.size(); ++i) {
    const auto nx = static_cast<std::size_t>(stock.bricks_along_[0]),
               ny = static_cast<std::size_t>(stock.bricks_along_[1]);
    stock.bricks_[i] = take(
        reader,
        stock.brick_region({static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / nx / ny)}),
        lattice);
  }
  reader.expect(reader.left() == 0, "more bricks than its box");
  return stock;
}

std::shared_ptr<Brick> StockBytes::take(Reader& reader, const Region& region, const StockLattice& lattice) {
  auto brick = std::make_shared<Brick>(region, true);
  const auto state = reader.take<std::uint32_t>();
  reader.expect(state > 0 && state < std::minstd_rand::modulus, "a random state");
  std::stringstream text(std::to_string(state));
  text >> brick->random_;
  for (std::uint64_t* const count :
       {&brick->tally_.direct, &brick->tally_.indirect, &brick->tally_.conflict, &brick->tally_.halved})
    *count = reader.take<std::uint64_t>();
  brick->tidied_ = reader.take<std::uint64_t>();
  take_samples(reader, *brick, lattice);
  const auto nodes = reader.take<std::uint32_t>();
  constexpr std::size_t least = 19;  // bytes of a cell
  reader.expect(nodes > 0 && nodes < 1u << 31 && nodes <= reader.left() / least, "a number of cells");
  brick->nodes_.assign(nodes, Cell{});
  brick->nodes_[0].region = region;
  std::vector<bool> reached(nodes, false);
  reached[0] = true;
  for (std::size_t node = 0; node < nodes; ++node) take_cell(reader, *brick, node, reached, lattice);
  return brick;
}

void StockBytes::take_samples(Reader& reader, Brick& brick, const StockLattice& lattice) {
  const auto slots = reader.take<std::uint64_t>(), count = reader.take<std::uint64_t>();
  constexpr std::size_t size = 12;  // bytes of a sample
  // Pruning leaves at most 5/4 slots per sample plus 8; growth adds half of the slots plus 16.
  reader.expect(
      count <= reader.left() / size && slots <= 4 * count + 64 && (slots == 0 ? count == 0 : count * 6 <= slots * 5),
      "a number of samples");
  brick.samples_.make_slots(slots);
  const Region& region = brick.region_;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto key = reader.take<SampleMap::Key>();
    Sample sample;
    sample.at = reader.take<float>();
    sample.cut = reader.take<std::uint32_t>();
    const int axis = static_cast<int>(key & 3);
    bool inside = axis < 3;
    Index3 from{};
    for (std::size_t a = 0; a < 3; ++a) {
      const int part = static_cast<int>(key >> (2 + 10 * a) & 1023);
      from[a] = region.lower[a] - 1 + part;
      inside = inside && part <= region.count(static_cast<int>(a)) + 1;
    }
    reader.expect(inside && !brick.samples_.find(key), "a sample's edge");
    const int k = from[static_cast<std::size_t>(axis)];
    reader.expect(sample.at >= lattice.at(axis, k - 1) && sample.at <= lattice.at(axis, k + 2), "a sample");
    brick.samples_.put(key, sample);
  }
  reader.expect(brick.samples_.slots() == slots, "a number of slots");
}

void StockBytes::take_cell(Reader& reader, Brick& brick, std::size_t node, std::vector<bool>& reached,
                           const StockLattice& lattice) {
  reader.expect(reached[node], "a cell");
  Cell& cell = brick.nodes_[node];
  const auto content = reader.take<std::uint8_t>();
  reader.expect(content <= static_cast<std::uint8_t>(Cell::Content::split), "a cell's content");
  cell.content = static_cast<Cell::Content>(content);
  cell.axis = reader.take<std::int8_t>();
  cell.facing = reader.take<std::int8_t>();
  reader.expect(cell.axis >= 0 && cell.axis < 3 && cell.facing >= -1 && cell.facing <= 1, "an axis");
  cell.plane = reader.take<std::int32_t>();
  cell.children = reader.take<std::int32_t>();
  const Region& r = cell.region;
  const int axis = cell.axis;
  if (cell.content == Cell::Content::split) {
    const auto child = static_cast<std::size_t>(cell.children);
    reader.expect(cell.children > 0 && child > node && child + 1 < brick.nodes_.size() && !reached[child] &&
                      !reached[child + 1] && cell.plane > r.first(axis) && cell.plane <= r.last(axis),
                  "a division");
    for (std::size_t i = 0; i < 2; ++i) brick.nodes_[child + i].region = r, reached[child + i] = true;
    brick.nodes_[child].region.upper[static_cast<std::size_t>(axis)] = cell.plane - 1;
    brick.nodes_[child + 1].region.lower[static_cast<std::size_t>(axis)] = cell.plane;
  }
  const bool columns = cell.content == Cell::Content::columns;
  const std::size_t count =
      columns ? static_cast<std::size_t>(r.count((axis + 1) % 3)) * static_cast<std::size_t>(r.count((axis + 2) % 3))
              : 0;
  const float low = lattice.at(axis, r.first(axis) - 1), high = lattice.at(axis, r.last(axis) + 1);
  for (Cell::Ends* const ends : {&cell.upper, &cell.lower}) {
    const auto given = reader.take<std::uint32_t>();
    reader.expect(given == count || (given == 0 && ends == &cell.lower), "columns");
    reader.expect(given <= reader.left() / 8, "columns");
    ends->at.resize(given), ends->cut.resize(given);
    reader.take(ends->at.data(), given * sizeof(float));
    reader.take(ends->cut.data(), given * sizeof(std::uint32_t));
    for (const float at : ends->at)
      reader.expect(at == beyond || at == -beyond || (at >= low && at <= high), "a column's end");
  }
}

void write_stock(const Stock& stock, const std::filesystem::path& path) {
  const std::string raw = StockBytes::of(stock);
  constexpr int level = 3;
  uLongf size = compressBound(raw.size());
  std::string body(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(body.data()), &size, reinterpret_cast<const Bytef*>(raw.data()), raw.size(),
                level) != Z_OK)
    throw Error(ErrorKind::too_large, path.string(), "cannot be compressed");
  body.resize(size);
  std::string sized;
  append(sized, static_cast<std::uint64_t>(raw.size()));
  sized += body;
  PendingFile file(path);
  file.write(magic);
  std::string numbers;
  append(numbers, version);
  append(numbers, checksum(sized));
  file.write(numbers);
  file.write(sized);
  file.commit();
}

Stock read_stock(const std::filesystem::path& path) {
  const std::string place = path.string(), file = read_file(path);
  if (!file.starts_with(magic) || file.size() < header_size) damaged(place, "it does not begin as one");
  std::uint32_t numbers[2];
  std::memcpy(numbers, file.data() + magic.size(), sizeof numbers);
  if (numbers[0] != version)
    throw Error(ErrorKind::bad_input, place,
                fmt::format("is of version {} of saved stocks; known is version {}", numbers[0], version));
  const std::string_view sized = std::string_view(file).substr(magic.size() + sizeof numbers);
  if (checksum(sized) != numbers[1]) damaged(place, "its checksum is wrong");
  std::uint64_t size = 0;
  std::memcpy(&size, sized.data(), sizeof size);
  const std::string_view body = sized.substr(sizeof size);
  if (size > 1100 * static_cast<std::uint64_t>(body.size()) + 1000) damaged(place, "its size is wrong");
  require_memory(2 * size, place);
  std::string raw(size, '\0');
  uLongf unpacked = size;
  if (uncompress(reinterpret_cast<Bytef*>(raw.data()), &unpacked, reinterpret_cast<const Bytef*>(body.data()),
                 body.size()) != Z_OK ||
      unpacked != size)
    damaged(place, "it cannot be unpacked");
  return StockBytes::read(raw, place);
}

}  // namespace fieldfab::cam
