#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "protocols/model/protocol.h"

namespace study {

/// How often each condition is at each position, and how often each condition directly follows each
/// other one, if @p participants of a cohort take part: a few lines for each block. The protocol
/// must be valid.
std::string balanceInWords(
    const protocols::Protocol& protocol, std::size_t participants, std::uint64_t seed);

}  // namespace study
