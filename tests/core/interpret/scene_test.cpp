// SPDX-License-Identifier: MIT
#include "core/interpret/scene.hpp"

#include <gtest/gtest.h>

#include <set>

namespace scanbed {
namespace {

TEST(SceneTest, EachKindHasANameOfItsOwn) {
  EXPECT_EQ(to_string(SceneKind::kWall), "wall");
  EXPECT_EQ(to_string(SceneKind::kTrashCan), "trash_can");
  std::set<std::string_view> names;
  for (int kind = 0; kind < kNumSceneKinds; ++kind) names.insert(to_string(static_cast<SceneKind>(kind)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kNumSceneKinds));
}

}  // namespace
}  // namespace scanbed
