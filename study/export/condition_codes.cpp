#include "study/export/condition_codes.h"

#include <algorithm>
#include <array>
#include <vector>

#include <sodium.h>

#include "base/random.h"
#include "study/storage/hasher.h"

namespace study {
namespace {

constexpr std::size_t kBytes = 16;

}  // namespace

std::map<std::string, std::string> conditionCodes(
    Study& study, RunMode mode, const std::string& set) {
  const auto* secret = study.secretFor(mode);
  std::map<std::string, std::string> codes;
  std::uint64_t version = 0;
  for (const auto id : study.protocols().all()) {
    std::vector<std::string> added;
    for (const auto& known : study.protocol(id).protocol.conditions) {
      if (codes.count(known.id) == 0) added.push_back(known.id);
    }
    std::ranges::sort(added);
    if (secret != nullptr) {
      secret->arrange(added, "codes/" + std::string(nameOf(mode)) + (set.empty() ? "" : "/" + set));
    } else {
      base::RandomStream(study.seed(), version, "blinding").shuffle(added);
    }
    ++version;
    for (const auto& condition : added) {
      codes.emplace(condition, "C" + std::to_string(codes.size() + 1));
    }
  }
  return codes;
}

bool drawsCodesForEachExport(Study& study, RunMode mode) {
  return study.secretFor(mode) != nullptr;
}

std::string drawnCodeSet() {
  std::array<unsigned char, kBytes> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return storage::inHexadecimal(bytes);
}

}  // namespace study
