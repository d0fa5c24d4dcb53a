#pragma once

#include <string>
#include <utility>
#include <vector>

namespace haptics::bench {

/// What a measurement was taken with: processor, kernel, governor, load, compiler, peers. Pairs of
/// a name and words.
std::vector<std::pair<std::string, std::string>> machineInWords();

}  // namespace haptics::bench
