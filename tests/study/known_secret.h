#pragma once

#include "study/storage/blinding_secret.h"

namespace tests {

/// The secret of studies that tests make: 0, 1, … 31. Codes and orders are then known beforehand.
/// Programs have no means to give one.
inline study::storage::BlindingSecret knownSecret() {
  study::storage::BlindingSecret::Bytes bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<unsigned char>(i);
  return study::storage::BlindingSecret(bytes);
}

}  // namespace tests
