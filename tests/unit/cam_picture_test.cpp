// Colours of deviations: perceptual properties.
#include <gtest/gtest.h>

#include "fieldfab/cam/simulate/picture.h"

namespace fieldfab::cam {
namespace {

TEST(DeviationScales, AreGreyWithinAndOneColourOnEachSide) {
  const DeviationScale scale{0.05, 0.1, 1};
  const Colour within = scale.colour(0);
  for (const double d : {-0.05, -0.01, 0.02, 0.1}) EXPECT_EQ(scale.colour(d), within) << d;
  EXPECT_NEAR(within[0], within[2], 4);
  const auto brightness = [&](double d) {
    const Colour c = scale.colour(d);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  };
  double before_red = brightness(0), before_blue = before_red;
  for (double over = 0.001; over < 0.9; over += 0.01) {
    const Colour red = scale.colour(-0.05 - over), blue = scale.colour(0.1 + over);
    EXPECT_GT(red[0], red[2] + 60) << over;
    EXPECT_GT(blue[2], blue[0] + 60) << over;
    // A greater deviation is darker.
    EXPECT_LE(brightness(-0.05 - over), before_red) << over;
    EXPECT_LE(brightness(0.1 + over), before_blue) << over;
    before_red = brightness(-0.05 - over), before_blue = brightness(0.1 + over);
  }
  EXPECT_EQ(scale.colour(-1), scale.colour(-9));
  EXPECT_EQ(scale.colour(1), scale.colour(9));
}

TEST(ToolColours, TellNeighboursApart) {
  for (std::size_t i = 0; i < 20; ++i) EXPECT_NE(colour_of_tool(i), colour_of_tool(i + 1)) << i;
}

}  // namespace
}  // namespace fieldfab::cam
