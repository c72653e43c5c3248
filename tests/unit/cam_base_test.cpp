// What files name by words: tools' shapes, kinds of machines and of files.
#include <gtest/gtest.h>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

/// The message of the error that a call ends with; its place is in it.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    return error.what();
  }
  return "nothing";
}

TEST(Names, AreReadBack) {
  for (const ToolShape shape : {ToolShape::flat, ToolShape::ball, ToolShape::bull, ToolShape::v, ToolShape::tapered,
                                ToolShape::drill, ToolShape::profile, ToolShape::form})
    EXPECT_EQ(tool_shape_named(name_of(shape), "here"), shape);
  for (const Coolant coolant : {Coolant::none, Coolant::mist, Coolant::flood})
    EXPECT_EQ(coolant_named(name_of(coolant), "here"), coolant);
  EXPECT_EQ(name_of(Kinematics::Kind::head_table), "head-table");
  EXPECT_EQ(name_of(MachineInput::height_map), "height map");
}

TEST(Names, UnknownOnesAreRefusedWithTheNearest) {
  EXPECT_EQ(refusal([] { (void)tool_shape_named("bal", "job.toml:3"); }),
            "job.toml:3: shape is 'bal'; it must be one of flat, ball, bull, v, tapered, drill, profile, form; did you mean "
            "'ball'?");
  EXPECT_EQ(refusal([] { (void)coolant_named("water", "x"); }), "x: coolant is 'water'; it must be one of none, mist, flood");
}

// Each at the line that says it, when the file is read.
TEST(Names, OfMachineFiles) {
  const auto read = [](const std::string& toml) {
    return refusal([&] { (void)read_machine("name = \"m\"\nextension = \".nc\"\n" + toml, "m.toml"); });
  };
  EXPECT_EQ(read("format = \"svgg\"\n"),
            "m.toml:3: format is 'svgg'; it must be one of text, dxf, svg, png, stl; did you mean 'svg'?");
  EXPECT_EQ(read("takes = \"path\"\n"),
            "m.toml:3: takes is 'path'; it must be one of paths, flat paths, height map, mesh; did you mean 'paths'?");
  EXPECT_EQ(read("[kinematics]\nkind = \"table\"\n"),
            "m.toml:4: kind is 'table'; it must be one of none, head-head, table-table, head-table");
}

}  // namespace
}  // namespace fieldfab::cam
