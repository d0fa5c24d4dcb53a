#include "protocols/library.h"

#include <gtest/gtest.h>

#include "protocols/loaded_protocol.h"

namespace protocols {
namespace {

TEST(ProtocolLibrary, HoldsTheFourShippedProtocols) {
  std::vector<std::string_view> names;
  for (const auto& file : libraryFiles()) names.push_back(file.name);
  for (const auto* name :
       {"punch-face-validity.json",
        "punch-counterbalanced.json",
        "reaming-hardness.json",
        "two-devices.json",
        "protocol-1.schema.json"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST(ProtocolLibrary, HasNoErrors) {
  for (const auto& file : libraryFiles()) {
    if (file.name == "protocol-1.schema.json") continue;
    questionnaires::Problems problems;
    const auto loaded = loadProtocolFile(std::string(file.name), problems);
    EXPECT_TRUE(loaded.has_value()) << file.name << "\n" << inWords(problems.all());
  }
}

}  // namespace
}  // namespace protocols
