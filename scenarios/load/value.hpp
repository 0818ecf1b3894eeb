// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "scenarios/load/asked.hpp"
#include "scenarios/load/expression.hpp"
#include "scenarios/load/node.hpp"
#include "sim/world/world_limits.hpp"

namespace scanbed::scenarios {

/// Sizes and lengths: more than nothing, less than the world.
inline constexpr Allowed kLength{.least = 0.0, .greatest = sim::kFarthest_m, .open = true};
inline constexpr Allowed kCoordinate{.least = -sim::kFarthest_m, .greatest = sim::kFarthest_m};
inline constexpr Allowed kShare{.least = 0.0, .greatest = 1.0};
/// Of robots and people, m/s.
inline constexpr Allowed kSpeed{.least = 0.0, .greatest = 5.0, .open = true};
inline constexpr Allowed kAngle_deg{.least = -36'000.0, .greatest = 36'000.0};

/// One value of a file, with the name of its key and the variables in force. A light handle: node and
/// variables must outlive it. All readers throw InputError "file:line:column: key: ..." for what does not
/// fit.
class Value {
 public:
  Value(const TreeNode& node, std::string name, const Variables& variables, const Notes& notes = {})
      : node_(&node), name_(std::move(name)), variables_(&variables), notes_(notes) {}

  const TreeNode& node() const { return *node_; }
  const std::string& name() const { return name_; }
  const Variables& variables() const { return *variables_; }
  const Notes& notes() const { return notes_; }

  /// A number, or arithmetic over numbers and variables (in quotes where it holds a comma or a colon).
  double number(const Allowed& allowed = {}) const;
  std::int64_t count(const Allowed& allowed = {}) const;
  bool flag() const;         ///< true or false, and no other spelling
  std::string text() const;  ///< not empty
  /// One of the words. @returns its index.
  std::size_t choice(std::span<const std::string> words) const;
  bool is(
      const std::string& word) const;  ///< whether it is this word, where it may be something else as well
  std::vector<Value> items() const;    ///< of a list
  std::vector<Value> items(std::size_t num_items) const;           ///< of a list of that many
  Eigen::Vector2d point_m() const;                                 ///< [x, y]
  std::vector<Eigen::Vector2d> points_m(std::size_t least) const;  ///< [[x, y], ...]
  Pose2 pose() const;                                              ///< [x, y, degrees]

  [[noreturn]] void refuse(std::string_view message) const;

 private:
  const std::string& scalar(std::string_view expected) const;
  double resolve(std::string_view expected) const;

  const TreeNode* node_;
  std::string name_;
  std::vector<Value> listed(std::size_t least, std::size_t greatest) const;
  void note(Asked::Form form) const;
  void note_number(Asked::Form form, const Allowed& allowed) const;

  const Variables* variables_;
  Notes notes_;
};

}  // namespace scanbed::scenarios
