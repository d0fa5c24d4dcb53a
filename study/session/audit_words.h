#pragma once

#include <string>

#include "study/model/given_answer.h"

namespace study {

/// What an answer says, for the audit trail: "1.1 = 4"; a long text by its SHA-256.
std::string auditWords(const GivenAnswer& answer);

}  // namespace study
