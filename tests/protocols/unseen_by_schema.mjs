// What no schema sees of a protocol: what one part of it says about another, what lies in other
// files, and what JSON.parse lets pass.
export const unseen = [
  /^two (cohorts|devices|conditions|phases|families) share the id /,
  /^there is no (device|condition|block|instrument|file) '/,
  /lies outside the protocol's folder$/,
  /^the file '.*' cannot be read$/,
  /and so does a file before it$/,
  /^this model is felt on a punch, not on a reamer$/,
  /^a reaming material is felt on a reamer, not on a punch$/,
  /^unknown word 'punsh'$/,  // which kinds of device there are, the program knows
  /^a knee is seen with a punch, not with a reamer$/,
  /^the finite elements need start < tool position < end/,
  /^the process noise \(Q\) is indefinite/,
  /there is nothing to weigh$/,
  /^the printed process noise is one per step/,
  /^there are \d+ finite elements, but \d+ stiffnesses$/,
  /^the tool presses on the last finite element/,
  /^material node \d+: 0 ≤ lower ≤ upper must hold$/,
  /^material node \d+ does not lie deeper than the one before it$/,
  /asks for no consent$/,
  /does not ask for an alternative$/,
  /and there are none to choose from here$/,
  /before anybody has agreed to take part$/,
  /^nothing is felt in this study$/,
  /^all orders of \d+ conditions are too many$/,
  /refer to each other in a circle$/,
  /does not come before this block$/,
  /whose order is reversed$/,
  /is asked twice after each condition$/,
  /^this block has no condition '/,
  /has no items of the set '/,
  /have not been felt yet$/,
  /has one alternative only$/,
  /^no block asks '.*' after its conditions$/,
  /has no Likert items to compare$/,
  /have different scales$/,
  /is no block that asks '/,
  /^no block of this family asks '/,
  /^a condition is compared with itself$/,
  /^this pair is compared already$/,
  /^the key '.*' stands here twice$/,
  /holds the character NUL$/,
  /^a whole number is expected here, not one with a decimal point$/, // 42.0 is 42 to JSON.parse
];

// Keys that belong to some objects of the format and not to others.
export const strayKeys = ["instrument", "block", "of", "text", "cut", "nodes", "minimum_cuts", "title"];
