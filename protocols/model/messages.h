#pragma once

#include <array>
#include <utility>

#include "base/message.h"

namespace protocols {

/// Warnings for a protocol's author and how to fix their cause ("key" and "key.fix"), and origins
/// of data ("source.…"), and what a later version changed ("changed.…").
inline constexpr auto kMessages = std::to_array<base::MessageKind>({
    {"no_normals",
     "it has no normals; they are taken from its triangles, and edges of more than 40° stay edges"},
    {"no_normals.fix", "save it with normals where it should look otherwise"},
    {"normals_without_direction",
     "{} of its normals have no direction; they are taken from its triangles"},
    {"normals_without_direction.fix", "save it with normals of length 1, or without any"},
    {"device_not_used", "no condition uses '{}'"},
    {"device_not_used.fix", "it will not be opened; remove it"},
    {"condition_not_used", "no block uses '{}'"},
    {"condition_not_used.fix", "nobody will feel it; remove it"},
    {"no_text", "there is no text in '{}'"},
    {"no_text.fix", "English will be shown instead; add \"{}\": \"…\""},
    {"blank_left_in", "still to be filled in ('{}'): {}"},
    {"blank_left_in.fix", "write it into 'texts' of the protocol"},
    {"no_texts_in", "'{}' has no texts in '{}'"},
    {"no_texts_in.fix",
     "English will be shown instead; 'palpate instrument wording {} --language {} --out {}', in "
     "the folder of the protocol, writes a file for them"},
    {"language_of_windows",
     "the program has no words of its own in '{}': buttons and instructions are in English there"},
    {"language_of_windows.fix", "it speaks {}; your own texts may be in any language"},
    {"braces_not_known", "nothing fills in {}: participants read it as it stands"},
    {"braces_not_known.fix", "write {}, or leave the braces out"},
    {"text_names_condition", "participants read '{}' here, which tells of the condition '{}'"},
    {"text_names_condition.fix", "call what is felt by its label"},
    {"date_not_iso", "'{}' is no date that catalogues read"},
    {"date_not_iso.fix", "write year, month and day: 2026-11-20"},
    {"asked_once", "'{}' is asked once, and its result is the change from before to after"},
    {"asked_once.fix", "ask it in a phase before and in a phase after what is felt"},
    {"template.fix",
     "fill them in once for the whole study: 'Fill in the texts…' in the windows, or 'palpate "
     "protocol texts'"},
    {"text_not_used", "no text has the blank [[{}]]"},
    {"text_not_used.fix", "remove it, or correct the name"},
    {"blank.duration", "Duration of a session [minutes]"},
    {"blank.institution", "Institution"},
    {"blank.contact", "Responsible researcher: name, institution, e-mail, telephone"},
    {"blank.ethics", "Ethics committee, and its reference"},
    {"blank.delete_until", "Until when data can be deleted on request: date or event"},
    {"blank.names_seen_by", "Who can see names and the list of codes"},
    {"blank.names_destroyed", "When names and the list of codes are destroyed: date or event"},
    {"blank.data_kept_years", "How long data are kept without names [years]"},
    {"blank.data_protection_officer", "Data protection officer"},
    {"blank.data_protection_authority", "Data protection authority, for complaints"},
    {"blank.own", "{}"},
    {"instrument_not_asked", "nothing asks '{}'"},
    {"instrument_not_asked.fix", "name it in a phase, or remove the file"},
    {"hides_library_instrument",
     "'{}' takes the place of the instrument of this name in the library"},
    {"hides_library_instrument.fix",
     "give it an id of its own, so that nobody takes one for the other"},
    {"no_previous",
     "item '{}' compares with the previous, and '{}' can come first in this block, where there is "
     "none"},
    {"no_previous.fix",
     "use an order in which it cannot, or a statement that compares with nothing"},
    {"no_vibration", "item '{}' asks about vibration, and the force of '{}' has no jitter"},
    {"no_removal", "item '{}' asks about the pace of removal, and '{}' removes nothing"},
    {"scaled_force", "item '{}' asks how large forces are, and those of '{}' are scaled to {} %"},
    {"not_rendered.fix", "ask what the scene renders ('reaming-quality'), or let it render this"},
    {"same_order", "everybody feels this block in the same order"},
    {"same_order.fix",
     "what comes first or last may be preferred for that alone; 'balancedLatinSquare' avoids it"},
    {"not_balanced", "{} participants of '{}' do not balance this design"},
    {"not_balanced.fix", "plan a multiple of {}"},
    {"no_family", "no family of comparisons is declared"},
    {"no_family.fix", "what is compared only after a look at the data is exploratory"},
    {"items_not_analysed", "no family, score or threshold uses these answers to '{}': {}"},
    {"items_not_analysed.fix",
     "the report describes them and tests nothing; declare a family or a score if a result depends "
     "on them"},
    {"alpha_large", "alpha is {}: chance alone may make a result significant that often"},
    {"alpha_large.fix", "0.05 is usual; 0.95 would be a level of confidence"},
    {"same_family", "it compares the same as '{}', with the same test"},
    {"same_family.fix", "keep one of the two: each has an alpha of its own"},
    {"score_not_always_asked",
     "the score '{}' needs '{}', which is asked only after some answers ('show_if'): whoever is "
     "not asked has no score"},
    {"score_not_always_asked.fix",
     "ask it always, leave it out of the score, or let the score need fewer answers "
     "('least_answered')"},
    {"asked_before_consent", "questions are asked here before anybody has agreed to take part"},
    {"asked_before_consent.fix", "put the phase of type 'consent' before it"},
    {"felt_after_debriefing", "something is felt or judged here after the debriefing '{}'"},
    {"felt_after_debriefing.fix", "move the debriefing to the end"},
    {"unlike_statements", "conditions answer different statements in '{}'"},
    {"unlike_statements.fix",
     "a difference may be one of wording; the item ids also tell an analyst which is which"},
    {"blinding_open", "the protocol keeps nobody blind: it says 'open'"},
    {"blinding_open.fix",
     "leave 'blinding' out to keep analysts blind; with 'open' no export of this study is blinded"},
    {"seed_tells", "the seed stands in the protocol, and every order can be computed from it"},
    {"seed_tells.fix",
     "without 'seed' every study draws its own; with it no export of this study is blinded"},
    {"labels_tell", "the number of an alternative says which condition it is"},
    {"labels_tell.fix",
     "choose the labels 'random' or 'position'; with 'condition' no export of this study is "
     "blinded"},
    {"blocks_tell", "no other condition is felt in the same blocks as '{}', which tells it apart"},
    {"blocks_tell.fix",
     "let each condition share all its blocks with another; otherwise no export of this study is "
     "blinded"},
    {"order_tells", "the position in '{}' says which condition it is"},
    {"order_tells.fix",
     "choose an order that differs between participants; with a fixed one no export of this study "
     "is blinded"},
    {"statements_tell", "the statements that are asked in '{}' say which condition it is"},
    {"statements_tell.fix",
     "ask the same statements about every condition; otherwise no export of this study is "
     "blinded"},
    {"pooled_answers",
     "Welch's test takes all answers for independent, and each person gives several"},
    {"pooled_answers.fix",
     "declare 'paired_t', 'sign_flip' or 'signed_rank'; Welch's test is computed all the same, as "
     "exploratory"},
    {"cut_not_felt",
     "with this noise the recorded cut weighs next to nothing; the finite elements alone are felt"},
    {"elements_not_felt",
     "with this noise the finite elements weigh next to nothing; the recorded cut alone is felt"},
    {"one_force_felt.fix",
     "bring noise.finite_elements and noise.interpolation closer together, or take another "
     "variant; 'palpate scene play' draws what is felt"},
    {"cut_beyond_limit",
     "the cut asks for up to {} N, and the device gives {} N at most ('max_force_n'): from travel "
     "{} "
     "to {} a plateau is felt in place of the cut"},
    {"cut_beyond_limit.fix",
     "say so in the paper, or import the cut of another recording; a cut cannot be scaled"},
    {"opening_gives_more",
     "the opening branch lies up to {} N above the closing one (at travel {}), so that opening "
     "gives back more than closing took"},
    {"opening_gives_more.fix", "choose another closure of the recording, or take closing-only"},
    {"other_knee",
     "'{}' shows another knee than '{}', so that they can be told apart by what is seen"},
    {"other_knee.fix", "give all conditions of a block the same 'anatomy'"},
    {"slope_limit_flattens",
     "'slope_limit' flattens this cut: its force rises by {} N in place of {} N"},
    {"slope_limit_flattens.fix",
     "choose a larger limit, in N per travel unit, or leave it out to keep the shape"},
    {"hardly_felt", "at most {} N are felt over the travel from {} to {}: are the units right?"},
    {"hardly_felt.fix",
     "give forces in N and the travel in the unit of the device, in the scene and in its files"},
    {"force_pulls", "over most of the travel the force pulls the hand on in place of resisting it"},
    {"force_pulls.fix",
     "a force that resists is positive; import a recording with the 'factor' -1 in its columns "
     "file"},
    {"elements_beyond_limit",
     "the finite elements ask for up to {} N, and the device gives {} N at most ('max_force_n'): "
     "from travel {} to {} a plateau is felt"},
    {"elements_beyond_limit.fix", "lower yield_force_n or the stiffness, or say so in the paper"},
    {"same_force",
     "the forces of '{}' and '{}' are the same, so that nobody can feel a difference"},
    {"same_force.fix", "change one of them, unless the repetition is meant"},
    {"knee_never_seen", "it is never seen"},
    {"knee_never_seen.fix", "set 'visualisation' to true, in the scene or in a block"},
    {"source.parametric_cut", "A cut of our own making, built from landmarks"},
    {"source.parametric", "parametric; not a recording"},
    {"source.parametric_bone", "A cup of our own making"},
    {"source.parametric_material",
     "A bone of our own making, with the properties that the reaming paper prints"},
    {"source.knee", "The knee that is seen"},
    {"source.tibia", "tibia"},
    {"source.femur", "femur"},
    {"source.capsule", "capsule"},
    {"source.recorded_in", "recorded in '{}'"},
    {"source.changed", "changed by the import: {}"},
    {"source.test_set", "test set {}"},
    {"source.spheres_in", "spheres in '{}'"},
    {"source.fitted_to", "fitted to '{}'"},
    {"changed.scale", "{} of {} participants left out, who answered on another scale: {}"},
    {"changed.score", "{} of {} participants had another rule for this score: {}"},
    {"changed.key", "{} of {} participants answered with another key: {}"},
    {"changed.wording", "{} of {} participants read other words: {}"},
    {"changed.asked", "{} of {} participants answered before this was asked as it is now: {}"},
    {"changed.scene", "{} of {} participants felt another rendering: {}"},
    {"changed.title", "{} of {} participants felt this under another title: {}"},
});

/// A message of kMessages with its arguments.
template <typename... Arguments>
base::Message message(
    base::CheckedKey<kMessages, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kMessages>(key, std::forward<Arguments>(arguments)...);
}

}  // namespace protocols
