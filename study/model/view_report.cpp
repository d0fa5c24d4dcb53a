#include "study/model/view_report.h"

#include <fmt/format.h>

namespace study {

std::string inWords(const ViewReport& view) {
  return fmt::format(
      "frames {}, dropped {}, {:.1f} 1/s; from frame to frame p50 {:.1f} ms, p99 {:.1f} ms, meant "
      "{:.1f} ms; latency p50 {:.1f} ms, p99 {:.1f} ms; changes lost {}; drawn by {}",
      view.frames,
      view.dropped,
      view.rate,
      view.frameMedian,
      view.frameP99,
      view.period,
      view.latencyMedian,
      view.latencyP99,
      view.lostChanges,
      view.renderer);
}

}  // namespace study
