#pragma once

namespace study::bench {

/// The peak memory use of this process since its start, or since resetPeakMemory() [MB].
double peakMemory();

/// Resets the peak to the present memory use (proc(5), clear_refs).
void resetPeakMemory();

}  // namespace study::bench
