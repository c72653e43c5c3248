#include "decoder.h"

#include <fmt/format.h>

#include "sources.h"

namespace fieldfab::cam::gcode {

void Decoder::decode(Line& line, int& motion, Command& command) {
  command.kind = Command::Kind::nothing;
  if (line.deleted && block_delete_) return;
  if (forgiving() && !forgive_line(line)) return;
  if (!line.closed) refuse("'(' without its ')'");
  if (line.text.empty()) {
    if (line.comment.starts_with("py,")) refuse("Python in a program is not carried out");
    return;
  }
  if (line.text == "%") {
    command.kind = Command::Kind::delimiter;
    return;
  }
  if (is_flow(line)) {
    command.kind = Command::Kind::flow;
    return;
  }
  command.kind = Command::Kind::block;
  reader_.read(line.text, command.block);
  if (forgiving()) forgive_block(line, command.block, motion);
  check_words(command.block, motion);
  command.modal = modal_words(command.block);
}

ModalWords modal_words(const Block& block) {
  ModalWords set;
  const auto code = [&](auto group, const auto& use) {
    if (const int found = block.code(group); found != Block::none) use(found);
  };
  code(GGroup::feed_mode, [&](int c) { set.feed_mode = c; });
  code(GGroup::plane, [&](int c) { set.plane = c == 170 ? ArcPlane::xy : c == 180 ? ArcPlane::zx : ArcPlane::yz; });
  code(GGroup::units, [&](int c) { set.inch = c == 200; });
  code(GGroup::lathe, [&](int c) { set.diameter = c == 70; });
  code(GGroup::distance, [&](int c) { set.absolute = c == 900; });
  code(GGroup::arc_distance, [&](int c) { set.arcs_absolute = c == 901; });
  code(GGroup::retract, [&](int c) { set.retract_to_start = c == 980; });
  code(GGroup::system, [&](int c) { set.system = c >= 591 ? 7 + c - 591 : 1 + (c - 540) / 10; });
  code(GGroup::path, [&](int c) { set.path = c; });
  code(MGroup::spindle, [&](int c) {
    if (c == 3 || c == 4) set.spindle = c == 3 ? 1 : -1;
    if (c == 5 || c == 19) set.spindle = 0;
  });
  code(MGroup::kinematics, [&](int c) {
    set.control = c == 428 ? ControlMode::tip : c == 429 ? ControlMode::axes : ControlMode::user;
  });
  return set;
}

/// Applies the rules of controls other than LinuxCNC to a line before its words are read. Returns
/// false if the line becomes empty.
bool Decoder::forgive_line(Line& line) {
  std::string& text = line.text;
  if (!line.closed) {
    note_("'(' without its ')': the rest of the line is a comment");
    line.closed = true;
  }
  if (text.starts_with('%')) text = "%";
  if (text.starts_with(':')) text[0] = 'o';  // O in ISO code
  if (dialect_ == Dialect::grbl && !text.empty() && std::string_view("$!?~").find(text[0]) != std::string_view::npos) {
    note_(fmt::format("'{}' is a command to the control: passed over", shown(text)));
    return false;
  }
  Cursor cursor{text};
  skip_line_number(cursor);
  for (const std::string_view word : {"if[", "while[", "goto", "do", "end", "then"})
    if (std::string_view(text).substr(cursor.at).starts_with(word))
      refuse("macros (IF, WHILE, GOTO) are not carried out");
  return true;
}

/// Applies the rules of these controls to a block.
void Decoder::forgive_block(const Line& line, Block& block, int& motion_in_force) {
  int& motion = block.g[static_cast<std::size_t>(GGroup::motion)];
  if (motion == 800) {  // G80 ends a cycle and restores the motion mode from before it
    motion_in_force = plain_motion_;
    motion = Block::none;
  } else if (motion == 0 || motion == 10 || motion == 20 || motion == 30) {
    plain_motion_ = motion;
  }
  const int action = block.code(GGroup::action);
  if ((motion == 0 || motion == 10) &&
      (action == 100 || action == 280 || action == 300 || action == 520 || action == 920)) {
    motion_in_force = motion;  // G0 G28 Z0: the axis words belong to G28
    motion = Block::none;
  }
  if (dialect_ != Dialect::fanuc || block.code(GGroup::action) != 40) return;
  for (const char letter : {'x', 'u'})  // dwell in seconds
    if (!block.has('p') && block.has(letter)) {
      block.words ^= 1U << static_cast<unsigned>(letter - 'a') | 1U << static_cast<unsigned>('p' - 'a');
      block.values['p' - 'a'] = block[letter];
      return;
    }
  const std::size_t at = line.text.find('p');
  if (at == std::string::npos) return;
  const std::size_t end = line.text.find_first_not_of("0123456789", at + 1);
  if (end == std::string::npos || line.text[end] != '.') block.values['p' - 'a'] /= 1000;
}

/// Checks for words that no code of the block uses, or that two codes use.
void Decoder::check_words(const Block& block, int motion_in_force) const {
  const int action = block.code(GGroup::action), motion_code = block.code(GGroup::motion);
  const bool axes = block.has_any("xyzabcuvw") || block.has_radius || block.has_angle;
  const bool action_axes = action == 100 || action == 280 || action == 300 || action == 520 || action == 920;
  const bool takes_axes = action_axes || block.code(GGroup::length) == 431 || block.code(GGroup::rotation) == 680;
  if (axes && !takes_axes && motion_code == Block::none && motion_in_force == 800)
    refuse("axis words, but no G code in force that uses them");
  if (takes_axes && motion_code != Block::none && motion_code != 800)
    refuse("{} and another G code both want the axis words", g_name(motion_code));
  if (motion_code == 800 && axes && !takes_axes) refuse("G80 has no use for axis words");
  const int used = motion_code != Block::none ? motion_code : axes && !takes_axes ? motion_in_force : 800;
  const bool cycle = used >= 730 && used <= 890 && used != 800 && used != 760;
  const bool arc = used == 20 || used == 30;
  const int m_io = block.code(MGroup::in_out), m_stop = block.code(MGroup::stop),
            m_override = block.code(MGroup::override_);
  const int compensation = block.code(GGroup::compensation), length = block.code(GGroup::length);
  const bool user = block.code(MGroup::user) != Block::none;
  const auto need = [&](char letter, bool use) {
    if (!block.has(letter) || use || block.passed_over) return;
    if (!forgiving()) refuse("nothing in the block uses its {} word", static_cast<char>(letter - 32));
    note_(fmt::format("{} in a block that has no use for it is passed over", static_cast<char>(letter - 32)));
  };
  need('d', compensation != Block::none || block.code(GGroup::spindle_mode) == 960);
  need('e', used == 760 || (m_io >= 66 && m_io <= 68));
  need('h', length == 430 || length == 432 || length == 434 || used == 760);
  need('i', arc || used == 50 || used == 51 || used == 760 || used == 870 || (action == 100));
  need('j', arc || used == 50 || used == 51 || used == 760 || used == 870 || (action == 100));
  need('k', arc || used == 330 || used == 331 || used == 760 || used == 870);
  need('l', cycle || action == 100 || compensation != Block::none || used == 52 || used == 760 || m_io == 66 ||
                m_stop == 98);
  need('p', arc || cycle || action == 40 || action == 100 || used == 50 || used == 52 || used == 760 ||
                block.code(GGroup::path) == 640 || m_override >= 50 || m_io != Block::none || m_stop == 98 || user ||
                block.code(MGroup::spindle) == 19);
  need('q', used == 50 || used == 730 || used == 760 || used == 830 || used == 870 || block.code(GGroup::path) == 640 ||
                user || (m_io >= 66 && m_io <= 68) || action == 100 || block.code(MGroup::tool) == 61 ||
                block.code(MGroup::spindle) == 19);
  need('r', arc || cycle || used == 760 || action == 100 || block.code(MGroup::spindle) == 19 ||
                block.code(GGroup::rotation) == 680);
  if (block.machine_coordinates && ((used != 0 && used != 10) || takes_axes)) {
    if (axes || motion_code != Block::none) refuse("G53 goes with G0 and G1 only");
  }
}

}  // namespace fieldfab::cam::gcode
