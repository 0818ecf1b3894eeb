// SPDX-License-Identifier: MIT
#pragma once

namespace scanbed::scenarios {

/// From now on the first SIGINT only sets a mark, so that work in hand is finished and written; a second one
/// ends the program at once. A write to a pipe that nobody reads becomes an error of that write.
void watch_signals();

/// Whether SIGINT arrived since watch_signals().
bool is_interrupted();

}  // namespace scanbed::scenarios
