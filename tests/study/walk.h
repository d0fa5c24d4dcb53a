#pragma once

#include <functional>
#include <string>

#include "study/session/session.h"

namespace tests {

/// An answer of a test's participant: the first allowed one, and a text in text items.
study::GivenAnswer answerTo(
    const study::Session& session, const questionnaires::Item& item, int order = 1);

/// Answers the items of the present step: the required ones, or all.
void answerStep(study::Session& session, bool all = false);

/// The record of a trial without problems.
study::TrialRecord feltTrial(int cuts = 1);

/// Completes the present step of any kind; trials get feltTrial() as their record.
void passStep(study::Session& session);

/// … until @p isThere holds, or the session is over.
void walkUntil(study::Session& session, const std::function<bool(const study::Step&)>& isThere);
void walkTo(study::Session& session, study::StepKind kind);
void walkToTheEnd(study::Session& session);

/// Enrols a participant who gives consent.
study::Session consenting(study::Study& study, const study::Enrolment& enrolment);

/// The kinds of a session's events in order, separated by spaces.
std::string eventsOf(study::Study& study, study::SessionId session);

}  // namespace tests
