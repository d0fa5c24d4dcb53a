#include <cstdlib>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>
#include <sodium.h>

#include "study/collect/exchange/enrolment.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"

namespace study::collect {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;
constexpr const char* kHomeFile = "collect.json";

[[noreturn]] void refuseEnrolment(const std::string& why) {
  throw UserError("This is no enrolment that can be used here: " + why);
}

std::string inBase64(const std::vector<std::byte>& bytes) {
  std::string text(sodium_base64_ENCODED_LEN(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  sodium_bin2base64(
      text.data(),
      text.size(),
      reinterpret_cast<const unsigned char*>(bytes.data()),
      bytes.size(),
      sodium_base64_VARIANT_ORIGINAL);
  text.resize(text.find('\0'));
  return text;
}

std::vector<std::byte> fromBase64(const std::string& text) {
  std::vector<std::byte> bytes(text.size());
  std::size_t size = 0;
  const int code = sodium_base642bin(
      reinterpret_cast<unsigned char*>(bytes.data()),
      bytes.size(),
      text.data(),
      text.size(),
      nullptr,
      &size,
      nullptr,
      sodium_base64_VARIANT_ORIGINAL);
  if (code != 0) refuseEnrolment("it is damaged.");
  bytes.resize(size);
  return bytes;
}

std::string textIn(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string())
    refuseEnrolment("it is damaged, or of a later release.");
  return found->get<std::string>();
}

storage::BlindingSecret secretIn(const json& object) {
  const auto text = textIn(object, "secret");
  storage::BlindingSecret::Bytes bytes{};
  std::size_t size = 0;
  const int code =
      sodium_hex2bin(bytes.data(), bytes.size(), text.data(), text.size(), nullptr, &size, nullptr);
  if (code != 0 || size != bytes.size()) refuseEnrolment("it is damaged.");
  return storage::BlindingSecret(bytes);
}

}  // namespace

std::string asText(const StationEnrolment& enrolment, const std::string& publicKey) {
  std::string secret(2 * enrolment.secret.bytes().size() + 1, '\0');
  sodium_bin2hex(
      secret.data(),
      secret.size(),
      enrolment.secret.bytes().data(),
      enrolment.secret.bytes().size());
  secret.pop_back();
  json files = json::object();
  for (const auto& file : enrolment.files) files[file.name] = file.text;
  const json inside{
      {"study", enrolment.study},
      {"title", enrolment.title},
      {"seed", std::to_string(enrolment.seed)},
      {"secret", secret},
      {"site", enrolment.station.site},
      {"station", enrolment.station.label},
      {"station_uuid", enrolment.station.uuid},
      {"server", enrolment.server},
      {"role", enrolment.role},
      {"bundle_key", enrolment.bundleKey},
      {"expires_utc", enrolment.expiresUtc},
      {"protocol", enrolment.protocol},
      {"files", std::move(files)}};
  const json outside{
      {"palpate_enrolment", kFormat},
      {"title", enrolment.title},
      {"site", enrolment.station.site},
      {"station", enrolment.station.label},
      {"for_key", publicKey},
      {"expires_utc", enrolment.expiresUtc},
      {"sealed", inBase64(storage::StationStore::sealFor(inside.dump(), publicKey))}};
  return outside.dump(1) + "\n";
}

StationEnrolment enrolmentIn(const std::string& text, const storage::StationStore& station) {
  const auto outside = json::parse(text, nullptr, false);
  if (!outside.is_object() || !outside.contains("palpate_enrolment")) {
    refuseEnrolment("'palpate collect init --station' writes one.");
  }
  if (outside["palpate_enrolment"] != kFormat) refuseEnrolment("a later release wrote it.");
  if (textIn(outside, "for_key") != station.publicKey()) {
    refuseEnrolment(
        "it is for another computer or account. 'palpate collect key' prints the key of this one.");
  }
  const auto opened = station.openSealed(fromBase64(textIn(outside, "sealed")));
  const auto inside = opened ? json::parse(*opened, nullptr, false) : json();
  if (!inside.is_object()) refuseEnrolment("it was changed on its way.");
  const auto files = inside.find("files");
  if (files == inside.end() || !files->is_object()) refuseEnrolment("it is damaged.");
  StationEnrolment enrolment{
      .study = textIn(inside, "study"),
      .title = textIn(inside, "title"),
      .seed = std::strtoull(textIn(inside, "seed").c_str(), nullptr, 10),
      .secret = secretIn(inside),
      .station =
          {.site = textIn(inside, "site"),
           .label = textIn(inside, "station"),
           .uuid = textIn(inside, "station_uuid")},
      .server = textIn(inside, "server"),
      .role = textIn(inside, "role"),
      .bundleKey = textIn(inside, "bundle_key"),
      .expiresUtc = textIn(inside, "expires_utc"),
      .protocol = textIn(inside, "protocol")};
  for (const auto& [name, content] : files->items()) {
    if (!content.is_string()) refuseEnrolment("it is damaged.");
    enrolment.files.push_back({name, content.get<std::string>()});
  }
  return enrolment;
}

void write(const HomeServer& home, const std::filesystem::path& folder) {
  const json content{{"server", home.server}, {"role", home.role}, {"bundle_key", home.bundleKey}};
  writeNewFile((folder / kHomeFile).string(), content.dump(1) + "\n");
}

HomeServer homeServerOf(const std::filesystem::path& folder) {
  std::ifstream file(folder / kHomeFile);
  std::ostringstream text;
  text << file.rdbuf();
  const auto content = json::parse(text.str(), nullptr, false);
  if (!content.is_object()) {
    throw UserError(
        folder.string() +
        " is a study of this computer alone: it was not made by 'palpate collect join', and "
        "nothing of it is collected.");
  }
  return {
      .server = textIn(content, "server"),
      .role = textIn(content, "role"),
      .bundleKey = textIn(content, "bundle_key")};
}

}  // namespace study::collect
