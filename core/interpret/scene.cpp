// SPDX-License-Identifier: MIT
#include "core/interpret/scene.hpp"

#include <array>

namespace scanbed {
namespace {

constexpr std::array<std::string_view, kNumSceneKinds> kNames = {"wall",  "corner", "column",
                                                                 "bench", "door",   "trash_can"};

}  // namespace

std::string_view to_string(SceneKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace scanbed
