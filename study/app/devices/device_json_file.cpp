#include "study/app/devices/device_json_file.h"

#include <nlohmann/json.hpp>

namespace study::app {

std::string checksAsJson(const std::vector<DeviceFindings>& found) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["fit"] = isFit(found);
  json["problems"] = Json::array();
  json["devices"] = Json::array();
  for (const auto& device : found) {
    Json findings = Json::array();
    for (const auto& result : device.results) {
      findings.push_back(
          {{"finding", haptics::devices::nameOf(result.finding)},
           {"what", base::describe(result.what)},
           {"measured", base::describe(result.measured)},
           {"fix", result.fix.empty() ? Json(nullptr) : Json(base::describe(result.fix))}});
    }
    json["devices"].push_back(
        {{"id", device.device}, {"fit", isFit({device})}, {"findings", findings}});
  }
  return json.dump(2) + "\n";
}

std::string problemAsJson(const std::string& why) {
  nlohmann::ordered_json json;
  json["fit"] = false;
  json["problems"] = {why};
  json["devices"] = nlohmann::ordered_json::array();
  return json.dump(2) + "\n";
}

}  // namespace study::app
