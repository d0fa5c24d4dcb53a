#pragma once

#include <functional>
#include <string>

#include "study/session/session.h"

namespace tests {

/// What a participant of a test answers: the first thing that is allowed, and text where it may be.
study::GivenAnswer answerTo(
    const study::Session& session, const questionnaires::Item& item, int order = 1);

/// Answers the present step's items: those that must be, or all of them.
void answerStep(study::Session& session, bool all = false);

/// A trial that was felt and kept, with nothing to complain about.
study::TrialRecord feltTrial(int cuts = 1);

/// Gets through the present step, whatever it is; a trial is felt as feltTrial() says.
void passStep(study::Session& session);

/// … until @p isThere, or the session is over.
void walkUntil(study::Session& session, const std::function<bool(const study::Step&)>& isThere);
void walkTo(study::Session& session, study::StepKind kind);
void walkToTheEnd(study::Session& session);

/// Enrols somebody who then gives consent.
study::Session consenting(study::Study& study, const study::Enrolment& enrolment);

/// The events of a session by kind, one after the other, with spaces between them.
std::string eventsOf(study::Study& study, study::SessionId session);

}  // namespace tests
