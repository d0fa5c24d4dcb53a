#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "protocols/model/protocol.h"

namespace study {

/// How often every condition is at every position, and directly after every other, if so many of a
/// cohort take part: a few lines for each block of a valid protocol.
std::string balanceInWords(
    const protocols::Protocol& protocol, std::size_t participants, std::uint64_t seed);

}  // namespace study
