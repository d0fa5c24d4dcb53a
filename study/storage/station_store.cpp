#include "study/storage/station_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <sodium.h>

#include "study/model/new_file.h"
#include "study/model/storage_error.h"
#include "study/model/user_error.h"
#include "study/storage/hasher.h"

namespace study::storage {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kUuidSize = 16;  // [bytes]
constexpr const char* kFirstLine = "palpate station 1";
constexpr const char* kKeyFile = "key";

using Seed = std::array<unsigned char, crypto_sign_SEEDBYTES>;
using PublicKey = std::array<unsigned char, crypto_sign_PUBLICKEYBYTES>;
using Signature = std::array<unsigned char, crypto_sign_BYTES>;
static_assert(crypto_sign_SECRETKEYBYTES == 64);

const unsigned char* bytesOf(std::string_view text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw StorageError(
      "This station's own folder cannot be used: " + path.string() + " (" + why +
      "). Check who owns it and may write it.");
}

[[noreturn]] void fail(const fs::path& path) {
  fail(path, std::generic_category().message(errno));
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  if (error) fail(folder, error.message());
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) fail(folder);
}

/// Draws uuid and key and writes them to the folder. If two programs do this at the same time, both
/// use the key that was written first.
void makeKey(const fs::path& folder) {
  std::array<unsigned char, kUuidSize> uuid{};
  Seed seed{};
  randombytes_buf(uuid.data(), uuid.size());
  randombytes_buf(seed.data(), seed.size());
  const auto unfinished = folder / (std::string(kKeyFile) + "." + inHexadecimal(uuid));
  writeNewFile(
      unfinished.string(),
      std::string(kFirstLine) + "\n" + inHexadecimal(uuid) + "\n" + inHexadecimal(seed) + "\n");
  // link() instead of rename(), because link() does not replace an existing key.
  const int code = link(unfinished.c_str(), (folder / kKeyFile).c_str());
  const int reason = code == 0 ? 0 : errno;
  unlink(unfinished.c_str());
  if (reason != 0 && reason != EEXIST) {
    fail(folder / kKeyFile, std::generic_category().message(reason));
  }
  const int names = open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  fsync(names);  // some file systems cannot flush a folder; the key is written nevertheless
  close(names);
}

void requirePrivate(const fs::path& file) {
  struct stat facts {};
  if (stat(file.c_str(), &facts) != 0) fail(file);
  if ((facts.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    fail(file, "others than its owner may use it: chmod 600");
  }
}

}  // namespace

fs::path StationStore::defaultFolder() {
  const auto named = [](const char* variable) {
    const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): no thread sets it
    return value == nullptr ? fs::path() : fs::path(value);
  };
  if (auto folder = named("PALPATE_STATION"); !folder.empty()) return folder;
  if (auto data = named("XDG_DATA_HOME"); data.is_absolute()) return data / "palpate" / "station";
  const auto home = named("HOME");
  return home.empty() ? home : home / ".local" / "share" / "palpate" / "station";
}

StationStore StationStore::openOrCreate(const fs::path& folder) {
  if (auto found = find(folder)) return std::move(*found);
  if (folder.empty()) {
    throw StorageError(
        "This account has no home folder (the variable HOME is empty), so that the station's own "
        "folder has no place. Set HOME, or name that folder in the variable PALPATE_STATION.");
  }
  makeFolder(folder);
  makeKey(folder);
  return StationStore(folder);
}

std::optional<StationStore> StationStore::find(const fs::path& folder) {
  std::error_code error;
  const bool isThere = !folder.empty() && fs::exists(folder / kKeyFile, error);
  if (error) fail(folder, error.message());
  return isThere ? std::optional(StationStore(folder)) : std::nullopt;
}

StationStore::StationStore(fs::path folder) : folder_(std::move(folder)) {
  if (sodium_init() < 0) throw std::logic_error("libsodium does not start");
  const auto file = folder_ / kKeyFile;
  requirePrivate(file);
  std::ifstream stream(file);
  std::string first;
  std::string secret;
  if (!std::getline(stream, first) || !std::getline(stream, uuid_) || !std::getline(stream, secret))
    fail(file, "it cannot be read");
  const auto seed = fromHexadecimal<Seed>(secret);
  if (first != kFirstLine || !seed || uuid_.size() != 2 * kUuidSize) {
    fail(file, "it is no key of a station, or one of a later version");
  }
  PublicKey key{};
  crypto_sign_seed_keypair(key.data(), secretKey_.data(), seed->data());
  publicKey_ = inHexadecimal(key);
}

std::string StationStore::sign(std::string_view text) const {
  Signature signature{};
  crypto_sign_detached(signature.data(), nullptr, bytesOf(text), text.size(), secretKey_.data());
  return inHexadecimal(signature);
}

bool StationStore::isSigned(
    std::string_view text, const std::string& signature, const std::string& publicKey) {
  const auto bytes = fromHexadecimal<Signature>(signature);
  const auto key = fromHexadecimal<PublicKey>(publicKey);
  return bytes && key &&
         crypto_sign_verify_detached(bytes->data(), bytesOf(text), text.size(), key->data()) == 0;
}

std::vector<std::byte> StationStore::sealFor(std::string_view text, const std::string& publicKey) {
  const auto key = fromHexadecimal<PublicKey>(publicKey);
  std::array<unsigned char, crypto_box_PUBLICKEYBYTES> box{};
  if (!key || crypto_sign_ed25519_pk_to_curve25519(box.data(), key->data()) != 0) {
    throw UserError(
        "'" + publicKey +
        "' is no key of a station: that has 64 digits or letters a to f. 'palpate collect key' "
        "prints it on the station.");
  }
  std::vector<std::byte> sealed(text.size() + crypto_box_SEALBYTES);
  crypto_box_seal(
      reinterpret_cast<unsigned char*>(sealed.data()), bytesOf(text), text.size(), box.data());
  return sealed;
}

std::optional<std::string> StationStore::unseal(std::span<const std::byte> sealed) const {
  std::array<unsigned char, crypto_box_PUBLICKEYBYTES> publicBox{};
  std::array<unsigned char, crypto_box_SECRETKEYBYTES> secretBox{};
  const auto key = fromHexadecimal<PublicKey>(publicKey_);
  const bool isUsable =
      sealed.size() >= crypto_box_SEALBYTES && key &&
      crypto_sign_ed25519_pk_to_curve25519(publicBox.data(), key->data()) == 0 &&
      crypto_sign_ed25519_sk_to_curve25519(secretBox.data(), secretKey_.data()) == 0;
  if (!isUsable) return std::nullopt;
  std::string text(sealed.size() - crypto_box_SEALBYTES, '\0');
  const int code = crypto_box_seal_open(
      reinterpret_cast<unsigned char*>(text.data()),
      reinterpret_cast<const unsigned char*>(sealed.data()),
      sealed.size(),
      publicBox.data(),
      secretBox.data());
  sodium_memzero(secretBox.data(), secretBox.size());
  return code == 0 ? std::optional(text) : std::nullopt;
}

void StationStore::append(const std::string& list, const std::string& line) const {
  const auto path = folder_ / list;
  const int file = open(path.c_str(), O_CREAT | O_APPEND | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0) fail(path);
  flock(file, LOCK_EX);  // until the file is closed; some file systems cannot
  const off_t before = lseek(file, 0, SEEK_END);
  char last = '\n';
  // A power failure may have left a part of a line.
  const bool isCutOff = before > 0 && pread(file, &last, 1, before - 1) == 1 && last != '\n';
  const std::string bytes = (isCutOff ? "\n" : "") + line + "\n";
  // A single call of write(), so that lines of several programs do not mix.
  errno = 0;
  const auto written = write(file, bytes.data(), bytes.size());
  const bool isWhole = written == static_cast<ssize_t>(bytes.size());
  const bool isOnDisk = isWhole && fsync(file) == 0;
  const int reason = errno != 0 ? errno : ENOSPC;  // a short write sets none
  // If the rest cannot be cut off either, the next call begins a line of its own.
  [[maybe_unused]] const int left = written > 0 && !isWhole ? ftruncate(file, before) : 0;
  close(file);
  if (!isOnDisk) fail(path, std::generic_category().message(reason));
}

void StationStore::rewrite(const std::string& list, const std::vector<std::string>& lines) const {
  const auto unfinished = folder_ / (list + ".new");
  std::error_code error;
  fs::remove(unfinished, error);  // left by a program that was killed
  std::string content;
  for (const auto& line : lines) content += line + "\n";
  writeNewFile(unfinished.string(), content);
  fs::rename(unfinished, folder_ / list, error);
  if (error) fail(folder_ / list, error.message());
  const int names = open(folder_.c_str(), O_RDONLY | O_CLOEXEC);
  fsync(names);
  close(names);
}

std::vector<std::string> StationStore::lines(const std::string& list) const {
  const auto path = folder_ / list;
  std::error_code error;
  if (!fs::exists(path, error)) return {};
  std::ifstream stream(path);
  if (!stream) fail(path, "it cannot be read");
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace study::storage
