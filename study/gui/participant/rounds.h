#pragma once

#include <map>
#include <string>

#include "study/session/session.h"

namespace study::gui {

/// Where the current step is among the rounds of its session; a round is a block of trials.
struct RoundPlace {
  int round = 0;         ///< from 1; 0: the step belongs to no round
  int rounds = 0;        ///< of the session
  int position = 0;      ///< of a trial and its questions in the round, from 1; 0: another step
  int alternatives = 0;  ///< of the round
};

RoundPlace placeOf(const Session& session);

/// Whether each alternative has its place in the order of the round for its number.
bool isLabelledByPosition(const Session& session);

/// Whether the step is the first trial of a block whose labels an earlier block had for its own.
bool reusesLabels(const Session& session);

/// Whether the step is a preference whose labels number the alternatives in the order of the latest
/// block.
bool isNumberedInFeltOrder(const Session& session);

/// When each alternative of the latest block was felt, from 0, by its label: for a preference whose
/// labels do not say it, if each was felt once.
std::map<std::string, int> feltOrder(const Session& session);

/// The next trial that is not optional; nullptr: none is left.
const Step* nextTrial(const Session& session);

/// Whether each number stands for the same alternative in the round of @p next as in this one.
bool keepsNumbers(const Session& session, const Step& next);

}  // namespace study::gui
