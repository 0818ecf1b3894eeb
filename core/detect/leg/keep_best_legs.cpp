// SPDX-License-Identifier: MIT
#include "core/detect/leg/keep_best_legs.hpp"

#include <algorithm>
#include <tuple>

namespace scanbed {
namespace {

constexpr double kApart_m = 0.10;

bool are_one(const Leg& a, const Leg& b) {
  const bool overlap = a.beams.first <= b.beams.last && b.beams.first <= a.beams.last;
  return overlap || (a.middle_m - b.middle_m).squaredNorm() < kApart_m * kApart_m;
}

}  // namespace

void keep_best_legs(std::vector<Leg>& legs) {
  std::sort(legs.begin(), legs.end(), [](const Leg& a, const Leg& b) {
    return std::tie(b.score, a.beams.first, a.beams.last) < std::tie(a.score, b.beams.first, b.beams.last);
  });
  auto kept_end = legs.begin();
  for (const Leg& leg : legs) {
    const bool is_known =
        std::any_of(legs.begin(), kept_end, [&](const Leg& kept) { return are_one(leg, kept); });
    if (!is_known) *kept_end++ = leg;
  }
  legs.erase(kept_end, legs.end());
}

}  // namespace scanbed
