#pragma once

#include <cstdint>
#include <string>

namespace study::app {

struct RehearseArguments {
  std::string out;
  std::string protocol = "two-devices";
  std::string firmware;  ///< for QEMU; empty: native
  int participants = 1;
  std::uint64_t seed = 1;
};

/// Both emulators as processes of their own, a device file for them, the check of `device check`,
/// and participants who do not exist, on real wires and in real time. Exit status.
int rehearse(const RehearseArguments& arguments);

}  // namespace study::app
