// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/detect/leg/leg_features.hpp"

namespace scanbed {

/// Writes down, of each candidate, how likely those around it are legs: a leg seldom stands alone, and of
/// what overlaps one only is a leg.
class LegPartnerReader {
 public:
  static constexpr float kUnlikely = -3.0F;  ///< sums below are all the same

  explicit LegPartnerReader(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions) {}

  /// Fills in kPartner35, kPartner80 and kRival of all the table's candidates.
  /// @param places, sums  of each candidate; the sums say how likely it is a leg by itself.
  void read(std::span<const LegPlace> places, std::span<const float> sums, LegFeatureTable& table);

  /// A candidate that may well be a leg.
  struct Likely {
    LegPlace place;
    float sum = 0.0F;
  };

 private:
  std::span<const Likely> gather(std::span<const LegPlace> places, std::span<const float> sums);

  InstructionSet instructions_;
  std::vector<Likely> likely_;  ///< and room
};

}  // namespace scanbed
