// SPDX-License-Identifier: MIT
#include "core/track/leg_circle.hpp"

#include <algorithm>

namespace scanbed {
namespace {

constexpr double kMaxLegRadius_m = 0.12;
constexpr double kMinLegScore = 0.5;

bool overlap(const BeamSpan& a, const BeamSpan& b) {
  return a.first <= b.last && b.first <= a.last;
}

}  // namespace

bool is_leg_too(const Circle& circle, const std::vector<Leg>& legs) {
  if (circle.radius_m > kMaxLegRadius_m) return false;
  return std::any_of(legs.begin(), legs.end(), [&](const Leg& leg) {
    return leg.score >= kMinLegScore && overlap(leg.beams, circle.beams);
  });
}

}  // namespace scanbed
