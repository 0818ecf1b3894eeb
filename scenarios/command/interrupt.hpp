// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "hw/serial/stop_signal.hpp"

namespace scanbed::scenarios {

/// From now on the first SIGINT, and any SIGTERM or SIGHUP, only sets a mark, so that work in hand is
/// finished and written; a second SIGINT ends the program at once. SIGHUP stays ignored where it is (nohup).
/// A write to a pipe that nobody reads, or beyond a limit on the size of files, becomes an error of that
/// write.
void watch_signals();

/// Which of these arrived last since watch_signals(); 0 where none did.
int interrupting_signal();

/// Whether one of them arrived since watch_signals().
bool is_interrupted();

/// Does what waits for a device, in a thread of its own; gives it the signal to stop when the program is
/// interrupted, and once `duration_s` has passed where there is one. Returns when it has ended.
///
/// @throws what `work` throws, but for hw::Stopped.
void work_until_interrupted(const std::function<void(const hw::StopSignal&)>& work,
                            const std::optional<double>& duration_s = std::nullopt);

}  // namespace scanbed::scenarios
