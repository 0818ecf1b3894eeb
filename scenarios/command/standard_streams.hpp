// SPDX-License-Identifier: MIT
#pragma once

namespace scanbed::scenarios {

/// Makes sure that standard input, output and error are open. One that is closed gets a stand-in that can be
/// neither read nor written; else the next file that is opened would be taken for it.
void keep_standard_streams();

}  // namespace scanbed::scenarios
