// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "core/random/philox.hpp"

namespace scanbed::sim {

/// Random numbers to build a world of, one after the other; the same for the same seed and purpose.
class WorldDice {
 public:
  WorldDice(std::uint64_t seed, std::string_view purpose) : source_(seed, purpose) {}

  double uniform(double from, double to) { return from + (to - from) * source_.uniform(0, num_drawn_++); }
  int whole(int from, int to) { return from + static_cast<int>(uniform(0.0, to - from + 1.0)); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

 private:
  RandomSource source_;
  int num_drawn_ = 0;
};

}  // namespace scanbed::sim
