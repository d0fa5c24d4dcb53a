#include "tests/study/everything_instrument.h"

#include "tests/study/made_study.h"

namespace tests {

std::string everythingInstrument() {
  return R"({"$schema": "instrument-1.schema.json", "id": "everything", "version": "1",
    "title": {"en": "Everything", "de": "Alles", "nb": "Alt"}, "source": {"citation": "Own wording.", "licence": "CC0-1.0"},
    "languages": ["en", "de", "nb"],
    "scale": {"points": 5, "low_label": {"en": "no", "de": "nein", "nb": "nei"},
              "high_label": {"en": "yes", "de": "ja", "nb": "ja"}},
    "items": [
      {"id": "agree", "type": "likert", "text": {"en": "a", "de": "b", "nb": "c"}, "key": -1},
      {"id": "words", "type": "semantic_differential",
       "left_label": {"en": "soft", "de": "weich", "nb": "myk"},
       "right_label": {"en": "hard", "de": "hart", "nb": "hard"}, "required": false},
      {"id": "slide", "type": "slider", "text": {"en": "a", "de": "b", "nb": "c"},
       "left_label": {"en": "soft", "de": "weich", "nb": "myk"},
       "right_label": {"en": "hard", "de": "hart", "nb": "hard"}, "key": -1, "required": false},
      {"id": "one", "type": "single_choice", "text": {"en": "a", "de": "b", "nb": "c"},
       "options": [{"id": "x", "text": {"en": "X", "de": "X", "nb": "X"}},
                   {"id": "y", "text": {"en": "Y, or \"Z\"", "de": "Y", "nb": "Y"}}],
       "required": false},
      {"id": "many", "type": "multiple_choice", "text": {"en": "a", "de": "b", "nb": "c"},
       "options": [{"id": "x", "text": {"en": "X", "de": "X", "nb": "X"}},
                   {"id": "y", "text": {"en": "Y", "de": "Y", "nb": "Y"}}], "required": false},
      {"id": "count", "type": "number", "text": {"en": "a", "de": "b", "nb": "c"},
       "least": 0, "most": 70, "step": 0.1, "required": false},
      {"id": "line", "type": "short_text", "text": {"en": "a", "de": "b", "nb": "c"},
       "required": false},
      {"id": "story", "type": "long_text", "text": {"en": "a", "de": "b", "nb": "c"},
       "required": false},
      {"id": "pair", "type": "pairwise_choice", "text": {"en": "a", "de": "b", "nb": "c"},
       "options": [{"id": "x", "text": {"en": "X", "de": "X", "nb": "X"}},
                   {"id": "y", "text": {"en": "Y", "de": "Y", "nb": "Y"}}], "required": false},
      {"id": "name", "type": "short_text", "text": {"en": "a", "de": "b", "nb": "c"},
       "identifying": true}
    ]})";
}

std::string protocolWithEverything() {
  return shortProtocol({.form = "everything", .files = R"("everything.json")"});
}

}  // namespace tests
