// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/truth.hpp"

namespace scanbed {

enum class SceneKind { kWall, kCorner, kColumn, kBench, kDoor, kTrashCan };

inline constexpr int kNumSceneKinds = 6;

/// "wall", "corner", "column", "bench", "door" or "trash_can".
std::string_view to_string(SceneKind kind);

/// A feature by its list (kLine, kCircle or kLeg) and its place in it.
struct FeatureRef {
  Primitive kind = Primitive::kNone;
  int index = 0;

  friend bool operator==(const FeatureRef&, const FeatureRef&) = default;
};

/// An architectonic entity that features of one scan show; sensor frame S.
struct SceneObject {
  SceneKind kind = SceneKind::kWall;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d left_m = Eigen::Vector2d::Zero();   ///< wall, door, bench: one end
  Eigen::Vector2d right_m = Eigen::Vector2d::Zero();  ///< the other end
  double radius_m = 0.0;                              ///< column, trash can; of a bench's feet
  bool is_outer = false;                              ///< corner: it points at the sensor
  bool is_open = false;                               ///< door: beams pass through
  double score = 0.0;                                 ///< [0, 1]
  int first_from = 0;                                 ///< into Scene::from
  int num_from = 0;
};

/// What one scan shows, as entities. Features that no entity takes stand for themselves.
struct Scene {
  std::vector<SceneObject> objects;
  std::vector<FeatureRef> from;  ///< which features the objects came from, one after the other

  std::span<const FeatureRef> from_of(const SceneObject& object) const {
    return std::span(from).subspan(object.first_from, object.num_from);
  }
  void clear() {
    objects.clear();
    from.clear();
  }
};

}  // namespace scanbed
