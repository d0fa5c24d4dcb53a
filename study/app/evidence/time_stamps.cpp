#include "study/app/evidence/time_stamps.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/file.h"
#include "study/app/command_options.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/evidence/trail_heads.h"
#include "study/storage/hasher.h"
#include "study/storage/stored_values.h"
#include "study/words/counted.h"

extern char** environ;

namespace study::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPurpose = "timestamp";
constexpr std::uintmax_t kLargestReply = 256 * 1024;  // [bytes]

struct ProcessOutput {
  int status = -1;
  std::string output;
};

/// Runs a program of the operating system, without a shell.
ProcessOutput run(std::vector<std::string> texts) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw UserError(
        "The program could not be started: too many open files. Close programs, and try again.");
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::vector<char*> words;
  for (auto& text : texts) words.push_back(text.data());
  words.push_back(nullptr);
  pid_t id = -1;
  const int error = posix_spawnp(&id, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  ProcessOutput process;
  std::array<char, 4096> buffer{};
  for (ssize_t size = 0; (size = ::read(ends[0], buffer.data(), buffer.size())) > 0;) {
    process.output.append(buffer.data(), static_cast<std::size_t>(size));
  }
  ::close(ends[0]);
  if (error != 0) {
    throw UserError(
        "The program '" + texts.front() +
        "' is needed for time stamps and is not there. Install it and try again.");
  }
  int status = 0;
  waitpid(id, &status, 0);
  process.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return process;
}

/// Writes a file for openssl to a temporary folder. @return  its path
std::string fileWith(const TemporaryFolder& folder, const char* name, const std::string& content) {
  const auto path = (folder / name).string();
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

std::string contentOf(const std::string& path) {
  std::error_code error;
  const bool isFile = fs::is_regular_file(path, error) && fs::file_size(path) <= kLargestReply;
  auto content = isFile ? base::readFile(path) : std::nullopt;
  if (!content)
    throw UserError(path + " cannot be read, or is larger than 256 kB: check the name.");
  return std::move(*content);
}

/// Writes a request for a time stamp, which contains the SHA-256 of the head's line.
void writeRequest(
    const TemporaryFolder& scratch, const std::string& head, const std::string& path) {
  const auto process = run(
      {"openssl",
       "ts",
       "-query",
       "-data",
       fileWith(scratch, "head", head),
       "-sha256",
       "-no_nonce",
       "-cert",
       "-out",
       path});
  if (process.status != 0)
    throw UserError("openssl could not write the request:\n" + process.output);
}

/// The unverified time in a reply; std::nullopt if the reply is not a time stamp.
std::optional<std::time_t> timeIn(const std::string& reply) {
  const auto text = run({"openssl", "ts", "-reply", "-in", reply, "-text"}).output;
  const std::string_view word = "Time stamp: ";
  const auto at = text.find(word);
  if (at == std::string::npos) return std::nullopt;
  // Format: "Nov 23 20:15:04.123 2026 GMT". The fraction of a second is optional.
  std::istringstream words(text.substr(at + word.size()));
  std::string month;
  std::string day;
  std::string clock;
  std::string year;
  words >> month >> day >> clock >> year;
  const auto plain = fmt::format("{} {} {} {}", month, day, clock.substr(0, clock.find('.')), year);
  std::tm parts{};
  if (strptime(plain.c_str(), "%b %d %H:%M:%S %Y", &parts) == nullptr) return std::nullopt;
  return timegm(&parts);
}

/// The time at which the authority signed the hash of the head.
struct VerifiedTimeStamp {
  std::string utc;          ///< empty if the reply is not valid
  std::string whyNot = {};  ///< why the reply is not valid
};

/// Verifies with openssl that an authority's reply is a time stamp of @p head.
/// @param reply  the content of the reply file
/// @param certificate  path of the authority's root certificate (PEM)
VerifiedTimeStamp verifyReply(
    const std::string& head, const std::string& reply, const std::string& certificate) {
  const TemporaryFolder scratch;
  const auto file = fileWith(scratch, "reply", reply);
  const auto time = timeIn(file);
  if (!time) return {.utc = {}, .whyNot = "it is not an authority's reply with a time stamp"};
  // The certificate is verified for the time of the stamp, because it may have expired since.
  const auto process = run(
      {"openssl",
       "ts",
       "-verify",
       "-data",
       fileWith(scratch, "head", head),
       "-in",
       file,
       "-CAfile",
       certificate,
       "-attime",
       std::to_string(*time)});
  if (process.status != 0) {
    const auto end = process.output.find('\n', process.output.find("error:"));
    return {.utc = {}, .whyNot = "openssl says " + process.output.substr(0, end)};
  }
  std::tm parts{};
  gmtime_r(&*time, &parts);
  std::array<char, 32> text{};
  const auto size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {.utc = {text.data(), size}};
}

std::string signedHead(Study& study) {
  study.transact([&] { study.signTrail(kPurpose); });
  const storage::TrailHeads trail(study.database());
  const bool isSigned = !trail.all().empty() && trail.all().back().seq == trail.lastEvent();
  if (!isSigned) {
    throw UserError("This station cannot sign the audit trail: 'palpate study verify' says why.");
  }
  return trail.all().back().head.asLine();
}

void requireCertificate(const std::string& certificate) {
  std::error_code ignored;
  if (fs::is_regular_file(certificate, ignored)) return;
  if (!certificate.empty()) throw UserError("There is no file " + certificate + ".");
  throw UserError(
      "Give the certificate of the authority's root, which its web site has: "
      "--authority-certificate FILE.pem");
}

void storeTimeStamp(
    Study& study,
    const std::string& head,
    const std::string& reply,
    const VerifiedTimeStamp& timeStamp) {
  study.note(
      {.kind = EventKind::TimeStamped,
       .values = {
           {"head", head},
           {"utc", timeStamp.utc},
           {"reply", storage::inBase64(std::as_bytes(std::span(reply)))}}});
  fmt::print(
      "The authority saw the head of the audit trail on {}: all before it was there then. The time "
      "stamp is kept in {}.\n",
      timeStamp.utc,
      study.folder().string());
}

int storeReply(Study& study, const TimeStampArguments& options) {
  const auto reply = contentOf(options.reply);
  const storage::TrailHeads trail(study.database());
  std::string whyNot = "no request was made here";
  for (const auto& each : trail.all()) {
    if (each.head.purpose != kPurpose) continue;
    const auto timeStamp = verifyReply(each.head.asLine(), reply, options.certificate);
    whyNot = timeStamp.whyNot;
    if (timeStamp.utc.empty()) continue;
    storeTimeStamp(study, each.head.asLine(), reply, timeStamp);
    return 0;
  }
  throw UserError(options.reply + " answers no request of this study: " + whyNot);
}

/// The authority's reply that an event of the audit trail holds; empty if it is damaged.
std::string replyIn(const storage::Event& event) {
  const auto bytes = storage::fromBase64(storage::storedText(event.values, "reply"));
  if (!bytes) return {};
  return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

}  // namespace

int requestTimeStamp(const TimeStampArguments& options) {
  const int ways = static_cast<int>(!options.authority.empty()) +
                   static_cast<int>(!options.request.empty()) +
                   static_cast<int>(!options.reply.empty());
  if (ways != 1)
    throw UserError("Give exactly one of --authority URL, --request FILE and --reply FILE.");
  auto study = Study::open(options.folder);
  if (options.request.empty()) requireCertificate(options.certificate);
  if (!options.reply.empty()) return storeReply(study, options);
  const TemporaryFolder scratch;
  const auto head = signedHead(study);
  const auto request = (scratch / "request").string();
  writeRequest(scratch, head, request);
  if (!options.request.empty()) {
    writeNewFile(options.request, contentOf(request));
    fmt::print(
        "{} has the request, a hash that tells nothing. Send it from a computer with a network:\n"
        "  curl -H 'Content-Type: application/timestamp-query' --data-binary @{} URL -o reply.tsr\n"
        "Then: palpate study timestamp {} --reply reply.tsr --authority-certificate FILE.pem\n",
        options.request,
        asShellWord(options.request),
        asShellWord(options.folder));
    return 0;
  }
  const auto answer = (scratch / "reply").string();
  const auto process = run(
      {"curl",
       "--silent",
       "--show-error",
       "--fail",
       "--proto",
       "=http,https",
       "--max-time",
       "60",
       "--header",
       "Content-Type: application/timestamp-query",
       "--data-binary",
       "@" + request,
       "--output",
       answer,
       "--url",
       options.authority});
  if (process.status != 0) {
    throw UserError(
        options.authority + " gave no time stamp: " + process.output +
        "Without a network, --request FILE and --reply FILE do the same.");
  }
  const auto reply = contentOf(answer);
  const auto timeStamp = verifyReply(head, reply, options.certificate);
  if (timeStamp.utc.empty()) {
    throw UserError("What " + options.authority + " answered is not kept: " + timeStamp.whyNot);
  }
  storeTimeStamp(study, head, reply, timeStamp);
  return 0;
}

void checkTimeStamps(Study& study, const std::string& certificate, Verification& verification) {
  Verification::Check check{
      .what = "every time stamp of an authority is of this audit trail", .problems = {}};
  const storage::TrailHeads trail(study.database());
  std::size_t stamps = 0;
  for (const auto& event : study.events().read()) {
    if (event.kind != EventKind::TimeStamped) continue;
    ++stamps;
    if (certificate.empty()) continue;
    const auto line = storage::storedText(event.values, "head");
    const auto head = storage::headIn(line);
    const auto timeStamp = verifyReply(line, replyIn(event), certificate);
    if (!head || !trail.holds(*head)) {
      check.problems.push_back(
          "a head that was stamped on " + storage::storedText(event.values, "utc") +
          " is not in the trail");
    } else if (timeStamp.utc.empty()) {
      check.problems.push_back(
          fmt::format("the one of {} events: {}", head->events, timeStamp.whyNot));
    } else {
      check.remarks.push_back(
          fmt::format("{} events were there on {}", head->events, timeStamp.utc));
    }
  }
  if (stamps == 0 && certificate.empty()) return;
  if (stamps == 0) check.problems.push_back("there is none");
  if (certificate.empty()) {
    check.remarks.push_back(
        words::counted(stamps, "time stamp was", "time stamps were") +
        " not looked at: give the authority's certificate (--authority-certificate)");
  }
  verification.checks.push_back(std::move(check));
}

}  // namespace study::app
