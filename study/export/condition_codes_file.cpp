#include <filesystem>
#include <iterator>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "study/export/condition_codes.h"
#include "study/model/user_error.h"

namespace study {
namespace {

constexpr std::size_t kDigits = 32;

bool isCodeSet(const std::string& text) {
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// The value of "codes" in a JSON file; empty if the file has none.
std::string codesIn(const std::filesystem::path& file) {
  constexpr std::uintmax_t kLargest = 64ULL * 1024 * 1024;  // [bytes]: no codebook is larger
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error || size > kLargest) return {};
  const auto text = base::readFile(file).value_or("");
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  const auto nested = json.find("palpate");  // the files of Psych-DS and BIDS have it inside this
                                             // key
  const auto& metadata = nested != json.end() && nested->is_object() ? *nested : json;
  const auto codes = metadata.find("codes");
  return codes != metadata.end() && codes->is_string() ? codes->get<std::string>() : std::string();
}

}  // namespace

std::string codeSetOf(const std::string& folder) {
  for (const char* file : {"codebook.json", "study.json", "dataset_description.json"}) {
    const auto codes = codesIn(std::filesystem::path(folder) / file);
    if (isCodeSet(codes)) return codes;
  }
  throw UserError(
      folder +
      " is no blinded export with codes of its own. Name the folder of an export of live or pilot "
      "sessions, as it was written.");
}

}  // namespace study
