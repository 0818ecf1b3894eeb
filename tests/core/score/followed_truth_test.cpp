// SPDX-License-Identifier: MIT
#include "core/score/followed_truth.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

ObjectTruth object(const char* id, Primitive primitive, const Eigen::Vector2d& center_m,
                   Visibility visibility) {
  ObjectTruth object;
  object.id = id;
  object.primitive = primitive;
  object.center_m = center_m;
  object.visibility = visibility;
  return object;
}

TEST(FollowedTruthTest, TwoLegsAreOnePersonAsVisibleAsTheBetterOne) {
  Truth truth;
  truth.objects = {object("a.left_leg", Primitive::kLeg, {2.0, 0.2}, Visibility::kHidden),
                   object("a.right_leg", Primitive::kLeg, {2.2, 0.0}, Visibility::kResolvable),
                   object("b.left_leg", Primitive::kLeg, {0.0, 0.0}, Visibility::kHidden),  // not there yet
                   object("b.right_leg", Primitive::kLeg, {0.0, 0.0}, Visibility::kHidden),
                   object("stool", Primitive::kLeg, {1.0, 0.0}, Visibility::kResolvable)};  // of nobody
  const std::vector<FollowedTruth> people = people_of(truth);
  ASSERT_EQ(people.size(), 1u);
  EXPECT_EQ(people[0].id, "a");
  EXPECT_NEAR((people[0].center_m - Eigen::Vector2d(2.1, 0.1)).norm(), 0.0, 1e-12);
  EXPECT_EQ(people[0].visibility, Visibility::kResolvable);
}

TEST(FollowedTruthTest, CylindersAreAllRoundThingsThatAreThere) {
  Truth truth;
  truth.objects = {object("col", Primitive::kCircle, {2.0, 0.2}, Visibility::kMarginal),
                   object("cyl", Primitive::kCircle, {0.0, 0.0}, Visibility::kHidden),
                   object("wall", Primitive::kLine, {1.0, 0.0}, Visibility::kResolvable)};
  const std::vector<FollowedTruth> cylinders = cylinders_of(truth);
  ASSERT_EQ(cylinders.size(), 1u);
  EXPECT_EQ(cylinders[0].id, "col");
  EXPECT_EQ(cylinders[0].visibility, Visibility::kMarginal);
}

}  // namespace
}  // namespace scanbed
