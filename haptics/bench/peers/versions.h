#pragma once

#include <string>

namespace haptics::bench::peers {

/// The libraries that we are compared with.
std::string versions();

}  // namespace haptics::bench::peers
