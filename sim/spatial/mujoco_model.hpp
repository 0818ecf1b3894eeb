// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

namespace scanbed::sim {

struct MjModelDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct MjDataDeleter {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPtr = std::unique_ptr<mjModel, MjModelDeleter>;
using DataPtr = std::unique_ptr<mjData, MjDataDeleter>;

/// Compiles MJCF. On the first call it also takes over MuJoCo's messages: warnings go to stderr, and errors
/// that MuJoCo cannot return from go to stderr and abort (no exception may pass through its C frames).
///
/// @throws SensorFault (kSimulator) with MuJoCo's own message where it refuses the text.
ModelPtr load_model(const std::string& mjcf);

/// State for a model, at its initial configuration. @throws SensorFault (kSimulator) where memory is short.
DataPtr make_data(const mjModel& model);

}  // namespace scanbed::sim
