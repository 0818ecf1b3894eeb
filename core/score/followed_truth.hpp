// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/scan/truth.hpp"

namespace scanbed {

/// Something that tracks may follow, as one scan has it; sensor frame S.
struct FollowedTruth {
  std::string id;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  Visibility visibility = Visibility::kHidden;
};

/// The people of a truth: "NAME.left_leg" and "NAME.right_leg" are one person, NAME, between them. A person
/// is as visible as the better visible of its legs. Who is not there yet, or has left, is left out.
std::vector<FollowedTruth> people_of(const Truth& truth);

/// The cylinders of a truth, standing or moving.
std::vector<FollowedTruth> cylinders_of(const Truth& truth);

}  // namespace scanbed
