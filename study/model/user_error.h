#pragma once

#include "base/user_error.h"

namespace study {

using base::UserError;

}  // namespace study
