// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace scanbed::scenarios {

/// Work on numbered jobs that may be done at the same time, and what follows it one after the other.
struct OrderedJobs {
  int num_jobs = 0;
  int num_workers = 1;              ///< threads; 1 or more
  std::function<void(int)> work;    ///< of one job, on any thread
  std::function<bool(int)> finish;  ///< on the calling thread, in the order of the jobs; false ends it all
};

/// Does all jobs: whatever the number of workers, `finish` sees them in the same order, each as soon as those
/// before it are done. At its end no work is under way.
///
/// @throws what `work` throws, in place of that job's `finish`; and what `finish` throws. Jobs behind it are
///         not begun.
void do_in_order(const OrderedJobs& jobs);

}  // namespace scanbed::scenarios
