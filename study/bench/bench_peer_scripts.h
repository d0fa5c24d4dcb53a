#pragma once

namespace study::app {

// What peers run: KIND (csv or database), FILE, KEYS, TIMES. They print lines for us: `version …`,
// `absent …`, `seconds …` for each repetition, and `row …` for each comparison.

/// For R with data.table; from a database also with RSQLite.
extern const char* const kTableInR;
/// For Python with pandas; p values also with SciPy.
extern const char* const kTableInPython;

}  // namespace study::app
