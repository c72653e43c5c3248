// Program and subroutine files, and the O words in them.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "block.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {

/// A program or a subroutine file.
struct Source {
  std::string name;  ///< for messages
  std::string kept;  ///< the text, if this object owns it
  std::string_view text;
};

/// A position between two lines.
struct Position {
  const Source* source = nullptr;
  std::size_t offset = 0;
  int line = 0;  ///< number of lines before it
};

/// Reads the next line. Returns false at the end of the file.
bool read_raw_line(Position& position, std::string_view& raw);

/// A parsed flow command: O, its label, its keyword, and the rest of the line.
struct FlowWord {
  std::string label, keyword;
  std::size_t rest = 0;
};

/// Whether a line is a flow command.
bool is_flow(const Line& line);
/// Parses a flow command. Returns false for any other line. `strict`: throws Refusal for an invalid one; otherwise, as
/// in a skipped range, returns false.
bool read_flow_word(const Line& line, const Parameters& parameters, FlowWord& word, bool strict);

/// Number of executed lines, with a limit.
class LineCount {
 public:
  explicit LineCount(std::uint64_t most) : most_(most) {}
  /// Counts a line, or work of a similar duration. Throws Refusal beyond the limit.
  void add() {
    if (++lines_ > most_) refuse("more than {} blocks: this program seems to have no end", most_);
  }
  [[nodiscard]] std::uint64_t lines() const { return lines_; }

 private:
  std::uint64_t lines_ = 0, most_;
};

/// The program, the subroutine files that it calls, and the known places of subroutines in them.
class Sources {
 public:
  Sources(std::string_view text, const std::string& file, const std::vector<std::filesystem::path>& folders,
          LineCount& count, const Parameters& parameters);
  // Positions refer to it.
  Sources(const Sources&) = delete;
  Sources& operator=(const Sources&) = delete;

  [[nodiscard]] const Source& program() const { return program_; }
  /// Stores the place of a subroutine or program. A subroutine replaces an earlier one.
  void define_subroutine(const std::string& label, const Position& start) { places_[label] = start; }
  void define_program(const std::string& label, const Position& start) { places_.emplace(label, start); }
  /// The place after `O label sub`, from `from` on or in a file of that name. Throws Refusal if there is none.
  Position subroutine(const std::string& label, const Position& from);
  /// The place after `O number`, for M98: from `from` on, before it, or in a file of that name. Throws Refusal if there
  /// is none.
  Position program(int number, const Position& from);

 private:
  const Source* open_file(const std::string& label);
  std::optional<Position> find(Position from, const std::string& label, bool program);

  Source program_;
  std::vector<std::filesystem::path> folders_;
  LineCount& count_;
  const Parameters& parameters_;
  std::map<std::string, std::unique_ptr<Source>> files_;
  std::map<std::string, Position> places_;
};

}  // namespace fieldfab::cam::gcode
