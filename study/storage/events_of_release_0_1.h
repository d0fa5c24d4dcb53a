#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "study/model/event_kind.h"
#include "study/model/given_answer.h"

/// Reads the English sentences that release 0.1 stored.
///
/// Do not change this code: hashed rows are never rewritten, so studies keep these sentences. Later
/// releases store codes and values. This is the only code that may parse sentences; changes of
/// wording elsewhere do not affect it.
namespace study::storage::release_0_1 {

/// The named values that code needs from the detail of an event of @p kind: for Answered, {"item":
/// …}, and {"kept_apart": 1} if the answer is in identity.db. Empty for other kinds, whose sentence
/// is shown unchanged.
base::NamedArguments valuesIn(EventKind kind, std::string_view detail);

/// The detail of release 0.1's Answered event about @p answer: "1.1 = 4"; a long text is replaced
/// by its SHA-256.
std::string detailOf(const GivenAnswer& answer);

/// The reasons of a trial's verdict in a sentence: "30 of 4000 ticks were late; 1 sample was lost".
/// An unknown sentence becomes a verbatim message.
std::vector<base::Message> trialReasonsIn(const std::string& sentence);

}  // namespace study::storage::release_0_1
