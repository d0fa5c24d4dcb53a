#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "study/model/given_answer.h"

/// What release 0.1 wrote as English sentences, read back.
///
/// Frozen: rows that are hashed are never rewritten, so studies hold these sentences for good.
/// Later releases store codes and values. This is the only code that may take a sentence apart, and
/// nothing here follows a change of wording elsewhere.
namespace study::storage::release_0_1 {

/// What the detail of an event says, as far as code needs it: of "answered", {"item": …}, and
/// {"kept_apart": 1} where the answer lies in identity.db. Nothing of other kinds: their sentence
/// is shown as it is.
base::NamedArguments valuesIn(std::string_view kind, std::string_view detail);

/// The detail of an "answered" event about @p answer: "1.1 = 4"; a long text by its SHA-256.
std::string detailOf(const GivenAnswer& answer);

/// Why a trial got its verdict: "30 of 4000 ticks were late; 1 sample was lost". A sentence that is
/// not understood becomes a message of its own words.
std::vector<base::Message> trialReasonsIn(const std::string& sentence);

}  // namespace study::storage::release_0_1
