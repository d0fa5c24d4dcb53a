#include "study/storage/evidence/witness_file.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>
#include <utility>

#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/evidence/head_check.h"

namespace study::storage {
namespace {

constexpr std::uintmax_t kLargestFile = 64 * 1024 * 1024;  // [bytes]

constexpr const char* kPreface =
    "# Signed heads of the audit trail of a Palpate study. Keep this file where those who can "
    "write "
    "the study cannot.\n"
    "# palpate study verify STUDY --witness FILE\n";

}  // namespace

void writeWitness(const Database& study, const std::string& path, const std::string& utc) {
  const auto station = StationStore::openOrCreate(StationStore::defaultFolder());
  const TrailHeads trail(study);
  std::string text = kPreface;
  for (const auto& each : trail.all()) {
    if (each.isSound) text += each.head.asLine() + "\n";
  }
  writeNewFile(path, text + signHead(study, station, kWitness, utc).asLine() + "\n");
}

std::vector<RecordedHead> readWitness(const std::string& path) {
  std::error_code error;
  const bool isFile = std::filesystem::is_regular_file(path, error) &&
                      std::filesystem::file_size(path, error) <= kLargestFile;
  std::ifstream stream(path);
  if (error || !isFile || !stream) throw UserError(path + " cannot be read as a witness file.");
  std::vector<RecordedHead> heads;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.empty() || line.starts_with('#')) continue;
    auto head = headIn(line);
    if (!head) {
      throw UserError(
          path + ", line " + std::to_string(number) +
          ": this is no signed head. 'palpate study verify --write-witness' writes such files.");
    }
    heads.push_back({std::move(*head), path});
  }
  if (heads.empty()) throw UserError(path + " has no signed head.");
  return heads;
}

Findings checkWitness(const TrailHeads& trail, const std::vector<RecordedHead>& witness) {
  std::vector<RecordedHead> sound;
  std::set<std::string> keys;
  Findings unsound;
  for (const auto& each : witness) {
    if (!each.head.isSigned()) {
      unsound.problems.push_back(
          "the witness of " + std::to_string(each.head.events) +
          " events is not signed by the key that it names: it was changed");
    } else if (each.head.study != trail.study()) {
      unsound.problems.push_back(
          "the witness is of another study (" + each.head.study + ", this one is " + trail.study() +
          ")");
    } else {
      sound.push_back(each);
      keys.insert(each.head.key);
    }
  }
  auto findings = checkHeads(trail, sound);
  findings.problems.insert(
      findings.problems.begin(), unsound.problems.begin(), unsound.problems.end());
  for (const auto& key : keys) {
    findings.remarks.push_back(
        "signed by the station whose key is " + inGroupsOfFour(key) +
        ": compare it with that station's");
  }
  return findings;
}

}  // namespace study::storage
