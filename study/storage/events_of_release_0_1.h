#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "study/model/event_kind.h"
#include "study/model/given_answer.h"

/// Reads the English sentences that release 0.1 stored.
///
/// Frozen: hashed rows are never rewritten, so studies keep these sentences for good. Later
/// releases store codes and values. This is the only code that may parse a sentence, and it does
/// not follow changes of wording elsewhere.
namespace study::storage::release_0_1 {

/// The values that code needs from the detail of an event: of Answered, {"item": …}, and
/// {"kept_apart": 1} if the answer is in identity.db. None for other kinds: their sentence is shown
/// unchanged.
base::NamedArguments valuesIn(EventKind kind, std::string_view detail);

/// The detail of release 0.1's Answered event about @p answer: "1.1 = 4"; for a long text its
/// SHA-256.
std::string detailOf(const GivenAnswer& answer);

/// Why a trial got its verdict: "30 of 4000 ticks were late; 1 sample was lost". An unknown
/// sentence becomes a verbatim message.
std::vector<base::Message> trialReasonsIn(const std::string& sentence);

}  // namespace study::storage::release_0_1
