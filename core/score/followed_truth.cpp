// SPDX-License-Identifier: MIT
#include "core/score/followed_truth.hpp"

#include <algorithm>
#include <string_view>

namespace scanbed {
namespace {

constexpr std::string_view kLeft = ".left_leg";
constexpr std::string_view kRight = ".right_leg";

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

// What is absent has no place; truth leaves it in the sensor's origin, where nothing can be.
bool is_present(const ObjectTruth& object) {
  return object.center_m.squaredNorm() > 0.0;
}

Visibility better_of(Visibility a, Visibility b) {
  return std::min(a, b);
}
static_assert(Visibility::kResolvable < Visibility::kMarginal && Visibility::kMarginal < Visibility::kHidden);

}  // namespace

std::vector<FollowedTruth> people_of(const Truth& truth) {
  std::vector<FollowedTruth> people;
  for (const ObjectTruth& left : truth.objects) {
    if (left.primitive != Primitive::kLeg || !ends_with(left.id, kLeft) || !is_present(left)) continue;
    const std::string name = left.id.substr(0, left.id.size() - kLeft.size());
    const auto right =
        std::find_if(truth.objects.begin(), truth.objects.end(), [&](const ObjectTruth& object) {
          return object.primitive == Primitive::kLeg && object.id == name + std::string(kRight);
        });
    if (right == truth.objects.end()) continue;
    people.push_back(
        {name, (left.center_m + right->center_m) / 2, better_of(left.visibility, right->visibility)});
  }
  return people;
}

std::vector<FollowedTruth> cylinders_of(const Truth& truth) {
  std::vector<FollowedTruth> cylinders;
  for (const ObjectTruth& object : truth.objects) {
    if (object.primitive != Primitive::kCircle || !is_present(object)) continue;
    cylinders.push_back({object.id, object.center_m, object.visibility});
  }
  return cylinders;
}

}  // namespace scanbed
