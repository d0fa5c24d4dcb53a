#include "study/model/view_report.h"

namespace study {

base::NamedArguments valuesOf(const ViewReport& view) {
  return {
      {"frames", view.frames},
      {"dropped", view.dropped},
      {"rate_per_s", view.rate},
      {"frame_p50_ms", view.frameMedian},
      {"frame_p99_ms", view.frameP99},
      {"period_ms", view.period},
      {"latency_p50_ms", view.latencyMedian},
      {"latency_p99_ms", view.latencyP99},
      {"lost_changes", view.lostChanges},
      {"renderer", view.renderer}};
}

}  // namespace study
