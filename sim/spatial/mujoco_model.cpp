// SPDX-License-Identifier: MIT
#include "sim/spatial/mujoco_model.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "core/errors/sensor_fault.hpp"

namespace scanbed::sim {
namespace {

void on_error(const char* message) {
  std::fprintf(stderr, "MuJoCo: %s\n", message);
  std::abort();
}

void on_warning(const char* message) {
  std::fprintf(stderr, "MuJoCo: warning: %s\n", message);
}

// MuJoCo's own handlers would wait for a key, and write MUJOCO_LOG.TXT into the working directory.
void take_over_messages() {
  static const bool done = [] {
    mju_user_error = on_error;
    mju_user_warning = on_warning;
    return true;
  }();
  static_cast<void>(done);
}

struct VfsDeleter {
  void operator()(mjVFS* vfs) const {
    mj_deleteVFS(vfs);
    delete vfs;
  }
};

[[noreturn]] void fail(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  throw SensorFault(SensorFault::Kind::kSimulator, "MuJoCo refuses the world: " + message);
}

}  // namespace

ModelPtr load_model(const std::string& mjcf) {
  take_over_messages();
  constexpr const char* kName = "world.xml";
  if (mjcf.empty()) fail("the model's text is empty");
  std::unique_ptr<mjVFS, VfsDeleter> vfs(new mjVFS);  // 2 MB: too much for a stack
  mj_defaultVFS(vfs.get());
  if (mj_makeEmptyFileVFS(vfs.get(), kName, static_cast<int>(mjcf.size())) != 0) fail("its text is too long");
  std::copy(mjcf.begin(), mjcf.end(), static_cast<char*>(vfs->filedata[0]));
  std::array<char, 1000> error{};
  // Its reader keeps what it read last in a place of its own that threads would share.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  ModelPtr model(mj_loadXML(kName, vfs.get(), error.data(), static_cast<int>(error.size())));
  if (!model) fail(error.data());
  return model;
}

DataPtr make_data(const mjModel& model) {
  DataPtr data(mj_makeData(&model));
  if (!data) fail("no memory for its state");
  return data;
}

}  // namespace scanbed::sim
