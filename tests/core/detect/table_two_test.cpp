// SPDX-License-Identifier: MIT
#include "core/detect/table_two.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

TEST(TableTwoTest, HoldsThePapersNamesAndDefaultsInItsOrder) {
  const std::pair<const char*, double> printed[] = {{"laser", 0},
                                                    {"seg_threshold", 80},
                                                    {"circles", 1},
                                                    {"lines", 1},
                                                    {"legs", 1},
                                                    {"circle_std_max", 0.15},
                                                    {"circle_max_len", 99999},
                                                    {"circle_min_len", 150},
                                                    {"circle_min_pts", 4},
                                                    {"line_min_len", 150},
                                                    {"line_min_pts", 5},
                                                    {"line_err", 0.1}};
  ASSERT_EQ(table_two().size(), std::size(printed));
  for (std::size_t i = 0; i < std::size(printed); ++i) {
    EXPECT_EQ(table_two()[i].name, printed[i].first);
    EXPECT_EQ(table_two()[i].default_value, printed[i].second);
  }
}

TEST(TableTwoTest, ThePaperPresetIsTableTwosDefaults) {
  const DetectorOptions options = paper_options();
  for (const auto& entry : table_two())
    EXPECT_NEAR(entry.get(options), entry.default_value, 1e-9) << entry.name;
}

TEST(TableTwoTest, EveryNameSetsWhatItGetsAndTheLimitsThemselvesAreValid) {
  for (const auto& entry : table_two()) {
    for (const double value : {entry.min_value, entry.max_value}) {
      DetectorOptions options = paper_options();
      // The two lengths limit each other; give the other one room.
      options.circle.min_length_m = 0.0;
      if (entry.name == "circle_min_len") options.circle.max_length_m = 999.0;
      set_table_two(options, entry.name, value);
      EXPECT_NEAR(entry.get(options), value, 1e-9 * (1.0 + std::abs(value))) << entry.name;
      EXPECT_NO_THROW(options.validate()) << entry.name << " = " << value;
    }
  }
}

TEST(TableTwoTest, LengthsAreMillimetresAndLineErrIsMetres) {
  DetectorOptions options = paper_options();
  set_table_two(options, "seg_threshold", 120);
  set_table_two(options, "line_err", 0.02);
  EXPECT_DOUBLE_EQ(options.segmentation.max_gap_m, 0.12);
  EXPECT_DOUBLE_EQ(options.line.max_error_m, 0.02);
}

std::string message_of(std::string_view name, double value) {
  DetectorOptions options;
  try {
    set_table_two(options, name, value);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TableTwoTest, WrongValuesNameParameterValueAndAllowedRange) {
  EXPECT_EQ(message_of("circle_std_max", 3.0),
            "circle_std_max: value 3 is out of range; allowed: [0.001, 0.402] rad");
  EXPECT_EQ(message_of("circle_min_pts", 4.5),
            "circle_min_pts: value 4.5 is out of range; allowed: whole numbers in [3, 10000]");
  EXPECT_EQ(message_of("laser", 1), "laser: value 1 is out of range; allowed: 0");
  EXPECT_NE(message_of("line_err", std::nan("")).find("line_err: value nan"), std::string::npos);
}

TEST(TableTwoTest, UnknownNamesAreRefusedWithTheKnownOnes) {
  EXPECT_NE(message_of("line_error", 1).find("unknown parameter 'line_error'; known: laser, seg_threshold"),
            std::string::npos);
}

}  // namespace
}  // namespace scanbed
