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

bool is_better(const Leg& a, const Leg& b) {
  if (a.score != b.score) return a.score > b.score;
  return std::tie(a.beams.first, a.beams.last) < std::tie(b.beams.first, b.beams.last);
}

}  // namespace

void keep_best_legs(std::vector<Leg>& legs) {
  for (auto rest = legs.begin(); rest != legs.end();) {
    std::iter_swap(rest, std::min_element(rest, legs.end(), is_better));
    const Leg& best = *rest++;
    legs.erase(std::remove_if(rest, legs.end(), [&](const Leg& leg) { return are_one(leg, best); }),
               legs.end());
  }
}

}  // namespace scanbed
