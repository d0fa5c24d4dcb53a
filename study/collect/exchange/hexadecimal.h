#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace study::collect {

std::string hexadecimalOf(std::span<const std::byte> bytes);

/// The inverse of hexadecimalOf().
std::vector<std::byte> bytesOfHexadecimal(const std::string& text);

}  // namespace study::collect
