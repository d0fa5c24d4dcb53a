// What no schema sees of an instrument: what one part of a file says about another, and what
// JSON.parse lets pass.
export const unseen = [
  /^two (items|options|scores) share the id /,
  /^two options read the same$/,
  /^the text in '(?!en')[A-Za-z-]+' is missing$/,
  /^this text is blank$/,
  /is not among the options$/,
  /^there is no item '/,
  /^answers to '.*' are no numbers$/,
  /names a person$/,
  /is the id of an item too$/,
  /^more answers are needed than there are items$/,
  /^a (sum|count) with answers missing would count them as zero$/,
  /^nobody can answer .* to '/,
  /^[0-9]+ weights for [0-9]+ items$/,
  /^these weights count nothing$/,
  /is no pairwise_choice item$/,
  /which this score does not count$/,
  /^these two are compared in a pair before$/,
  /^there is no score '/,
  /^more contradictions are needed than there are scores$/,
  /^all answers lie on one side of /,
  /^nobody learns where the words are that do not ship$/,
  /^the scale has a word for this end/,
  /^least is .* and most is /,
  /^steps of .* do not lead from /,
  /labels for .* points$/,
  /has no words for both ends$/,
  /stands here twice$/,
  /holds the character NUL$/,
  /is no earlier item of the same set$/,
  /^consent and names are always asked for$/,
  /is no option of '/,
  /^a whole number is expected here, not one with a decimal point$/, // 5.0 is 5 to JSON.parse
];

// Keys that belong to some objects of the format and not to others.
export const strayKeys = ["options", "scale", "key", "least", "unit", "consent_option",
  "acceptable_from", "wording", "count_from", "weights_from", "missing_as"];
