// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/interpret/interpret_options.hpp"
#include "core/interpret/scene.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// What is known of a circle over time.
enum class CircleMotion {
  kUnknown,  ///< not watched for long enough
  kSettled,  ///< it has stood still for a while
  kMobile,   ///< it has moved, or is a leg: no part of the building
};

/// The circles of a scan and what is known of each.
struct WatchedCircles {
  const LaserScan& scan;
  const std::vector<Circle>& circles;
  const std::vector<CircleMotion>& motions;
};

/// Groups arcs that one cylinder shows on both sides of what hides its middle, and tells columns, benches and
/// trash cans. What moves is none of them; a bench is only said of feet that have been seen to stand.
class RoundGroups {
 public:
  /// Appends columns, benches and trash cans.
  void find(const WatchedCircles& seen, const InterpretOptions& options, Scene& scene);

 private:
  /// A cylinder that stands.
  struct Cylinder {
    Eigen::Vector2d center_m;
    double radius_m = 0.0;
    double score = 0.0;
    bool is_settled = false;
    bool is_taken = false;  ///< by a bench
    int first_circle = 0;   ///< the others follow by next_
  };
  struct Pair {
    double off_m = 0.0;  ///< its distance from a bench's
    int a = 0, b = 0;
  };

  void gather(const WatchedCircles& seen);
  bool join_others(const WatchedCircles& seen, int first);
  Cylinder merge(const LaserScan& scan, const std::vector<Circle>& circles, int first) const;
  void add_benches(const InterpretOptions& options, Scene& scene);
  void add_singles(const InterpretOptions& options, Scene& scene) const;
  void append_from(const Cylinder& cylinder, Scene& scene) const;

  std::vector<Cylinder> cylinders_;
  std::vector<int> next_;       ///< of each circle: the next one on its cylinder, or -1
  std::vector<char> is_later_;  ///< of each circle: another one of its cylinder comes before it
  std::vector<Pair> pairs_;
};

}  // namespace scanbed
