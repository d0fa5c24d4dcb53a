#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "study/collect/exchange/batch.h"
#include "study/collect/exchange/outbox.h"
#include "study/model/user_error.h"
#include "study/storage/blinding_secret.h"
#include "study/storage/station_store.h"

namespace study::collect {

// A bundle: the data that a station has for the server in one file, for a hospital without a
// network. It is encrypted (XChaCha20-Poly1305 of libsodium), can be opened with the study's
// secret, and is signed with the station's key (Ed25519).

/// The public key with which stations seal bundles of a study, hexadecimal. All stations receive
/// it.
std::string bundleKeyOf(const storage::BlindingSecret& secret);

/// The header of a bundle, and its size.
struct BundleHeader {
  std::string study;       ///< uuid
  std::string station;     ///< uuid
  std::int64_t first = 0;  ///< number of the first event in the bundle
  std::int64_t last = 0;   ///< number of the last event in the bundle
  std::uint64_t bytes = 0;
};

/// Writes all data after the event @p after to a new file.
/// @throws UserError  if there is nothing to be sent. @throws storage::StorageError
BundleHeader writeBundle(
    Outbox& outbox,
    const storage::StationStore& station,
    const std::string& bundleKey,
    std::int64_t after,
    const std::filesystem::path& file);

/// A bundle is incomplete, was changed, or is not of the station and study that its header names.
class InvalidBundle : public UserError {
 public:
  using UserError::UserError;
};

/// Reads the header of a bundle. Its study and station are not verified yet.
/// @throws UserError  if the file is no bundle.
BundleHeader readBundleHeader(const std::filesystem::path& file);

/// Checks the signature of the whole file, then calls @p take with each batch in order: its text,
/// and the bytes of its chunks. Stops if @p take returns false.
/// @param key  the station's public key, as it was enrolled
/// @throws InvalidBundle
void readBundle(
    const std::filesystem::path& file,
    const storage::BlindingSecret& secret,
    const std::string& key,
    const std::function<
        bool(const std::string& text, const std::vector<std::vector<std::byte>>& chunks)>& take);

}  // namespace study::collect
