/// Serialization of stocks.
#pragma once

#include <string>
#include <string_view>

#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

class StockBytes {
 public:
  static std::string of(const Stock& stock);
  /// Throws Error(bad_input) at `place` for bytes that represent no valid stock, and
  /// Error(too_large).
  static Stock read(std::string_view bytes, const std::string& place);

 private:
  struct Reader;
  static void put(const Brick& brick, std::string& bytes);
  static std::shared_ptr<Brick> take(Reader& reader, const Region& region, const StockLattice& lattice);
  static void take_samples(Reader& reader, Brick& brick, const StockLattice& lattice);
  static void take_cell(Reader& reader, Brick& brick, std::size_t node, std::vector<bool>& reached,
                        const StockLattice& lattice);
};

}  // namespace fieldfab::cam
