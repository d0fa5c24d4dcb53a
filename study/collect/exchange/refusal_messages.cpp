// Messages for the server's refusals. Their names are those of refuse() in the schema.
#include <algorithm>
#include <array>
#include <string_view>

#include "study/collect/exchange/batch.h"

namespace study::collect {
namespace {

struct Refusal {
  std::string_view name;
  std::string_view words;
};

constexpr std::array kRefusals{
    Refusal{
        "fork",
        "The server has other data of this station under the same numbers. Two copies of this "
        "study's folder have gone on by themselves: an older backup was put back, or the folder "
        "was copied to a second computer. Go on with the copy that sent last; for the other one "
        "ask for an enrolment of its own. If only this copy is left, ask for 'palpate collect "
        "set-aside' on the server, and push again. Nothing was changed on the server, and both "
        "copies are "
        "as they were."},
    Refusal{
        "older_copy",
        "The server has more of this station than this folder: it is an older copy. Put the newest "
        "copy back before anybody takes part; if there is none, ask for another enrolment and "
        "leave this folder as it is."},
    Refusal{
        "gap",
        "Something between what the server has and what was sent is missing. Push again: the "
        "server says from where."},
    Refusal{"damaged", "What arrived is not what was sent. Push again."},
    Refusal{
        "unknown",
        "The server does not know this station. Was it enrolled in another study, or on another "
        "server?"},
    Refusal{
        "foreign", "The server's role that was used here belongs to another station of the study."},
    Refusal{
        "revoked",
        "The study's administrator has shut this station out: the server takes nothing more from "
        "it. What has not arrived stays at the station."},
    Refusal{"expired", "The enrolment of this station was not used in time. Ask for another one."},
    Refusal{
        "newer",
        "The server is older than this program. Whoever runs the server brings it up to date with "
        "'palpate collect init'. Nothing is lost until then."},
    Refusal{
        "protocol",
        "The server does not know the version of the protocol with which a session was run. "
        "Whoever runs the study adds it there: palpate collect init --protocol FILE."},
    Refusal{"code", "A participant's code does not begin with the name of this station."},
    Refusal{
        "place",
        "A session was recorded at another site or station than the one that was enrolled. "
        "'palpate study verify' says more."},
    Refusal{
        "traces",
        "The samples of a trial are not complete on this computer. 'palpate study verify' says "
        "more."},
};

}  // namespace

bool isRefusal(std::string_view name) {
  return std::ranges::any_of(kRefusals, [&](const auto& refusal) { return refusal.name == name; });
}

std::string wordsFor(const ServerAnswer& answer) {
  for (const auto& refusal : kRefusals) {
    if (refusal.name != answer.refused) continue;
    std::string words(refusal.words);
    if (!answer.detail.empty()) words += " (" + answer.detail + ")";
    return words;
  }
  return "The server refused what was sent: " + answer.refused + " (" + answer.detail +
         "). Install the release of the server here.";
}

std::string wordsFor(const ErasureReceipt& receipt) {
  const auto what = "session " + std::to_string(receipt.session) + " of " + receipt.participant;
  if (receipt.left == 0) {
    return "erased on the server: " + what + ", on " + receipt.utc +
           ". No answer, no sample and no key of it is left in its tables. PostgreSQL keeps "
           "deleted rows "
           "in its files until the administrator has them rewritten (docs/collecting.md).";
  }
  return "NOT erased on the server: of " + what + " " + std::to_string(receipt.left) +
         " answers, samples or keys are left. Tell the server's administrator.";
}

}  // namespace study::collect
