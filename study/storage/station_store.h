#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace study::storage {

/// What a station keeps for itself, in a folder outside of all studies: its name, an Ed25519 key
/// pair with which it signs audit trails (docs/decisions/0041), and lists. A station is one account
/// on one computer. The folder and its files are for their owner alone.
class StationStore {
 public:
  /// $PALPATE_STATION; else palpate/station in $XDG_DATA_HOME; else
  /// ~/.local/share/palpate/station. Empty if the account has no home folder.
  static std::filesystem::path usualFolder();

  /// Opens the store in @p folder; makes it if there is none.
  /// @throws StorageError  if it cannot be made or read, or if others may read its key.
  static StationStore findOrMake(const std::filesystem::path& folder);

  /// Opens the store if there is one. @throws StorageError  as above
  static std::optional<StationStore> find(const std::filesystem::path& folder);

  /// 128 random bits in hexadecimal; the same for all studies.
  const std::string& uuid() const noexcept { return uuid_; }

  /// 256 bits in hexadecimal. Signatures are checked with it; it is no secret.
  const std::string& publicKey() const noexcept { return publicKey_; }

  /// The signature of @p text (Ed25519, 512 bits in hexadecimal).
  std::string sign(std::string_view text) const;

  /// Whether @p signature is a valid signature of @p text by that public key. False also for
  /// malformed keys and signatures.
  static bool isSigned(
      std::string_view text, const std::string& signature, const std::string& publicKey);

  /// Seals @p text so that only the station of @p publicKey can open it (crypto_box_seal of
  /// libsodium). @throws UserError  if that is no key of a station
  static std::vector<std::byte> sealFor(std::string_view text, const std::string& publicKey);

  /// The text that was sealed for this station; std::nullopt if it was sealed for another one, or
  /// was changed.
  std::optional<std::string> openSealed(std::span<const std::byte> sealed) const;

  /// Appends a line to a list; it is on the disk on return. Several programs may do so at a time.
  /// @param list  a name for a file: "heads-1a2b"
  /// @throws StorageError
  void append(const std::string& list, const std::string& line) const;

  /// Replaces the content of a list by @p lines; it is on the disk on return. @throws StorageError
  void rewrite(const std::string& list, const std::vector<std::string>& lines) const;

  /// The lines of a list; none if there is no such list. @throws StorageError  if it cannot be read
  std::vector<std::string> lines(const std::string& list) const;

 private:
  explicit StationStore(std::filesystem::path folder);

  std::filesystem::path folder_;
  std::string uuid_;
  std::string publicKey_;
  std::array<unsigned char, 64> secretKey_{};
};

}  // namespace study::storage
