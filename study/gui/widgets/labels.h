#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QString>
#include <QStringList>
#include <QWidget>

#include "protocols/model/protocol.h"
#include "study/model/session_state.h"
#include "study/session/unfinished_sessions.h"

namespace study::gui {

/// Converts UTF-8 text from code without Qt to a QString.
QString asText(std::string_view words);
/// Makes the first letter a capital: "cuts" → "Cuts".
QString capitalised(const QString& words);
/// A session's status in the language of the desk: "in progress", "device failed".
QString statusInWords(SessionState state);
/// A UTC time as local time: "2026-03-09 08:15".
QString localTime(const std::string& utc);
/// A phase's id as its title: "round-1" → "Round 1".
QString phaseTitle(const std::string& id);
/// A step by its alternative, without its condition: "Round 1: questions on Tissue 2".
QString describe(const Step& step, const protocols::Labels& labels);
/// The step of an unfinished session and what happened to the session, in the language of the desk.
QString describeUnfinished(const UnfinishedSession& session);
/// What can be done about an unfinished session, a line each.
QStringList choicesFor(const UnfinishedSession& session);
/// The name of a language in that language.
QString nativeName(const QString& language);
/// Adds languages to choose from, each by its native name and with its tag as data.
void addLanguages(QComboBox& box, const std::vector<std::string>& tags);
/// Chooses the language @p tag; another one stays if it is not among those of the box.
void chooseLanguage(QComboBox& box, const std::string& tag);
/// The title of a cohort in the language of the desk; its id if only an earlier version of the
/// protocol has the cohort.
QString cohortTitle(const protocols::Protocol& protocol, const std::string& id);

/// Labels in the styles of the theme.
QLabel* titleLabel(const QString& text, QWidget* parent);
QLabel* bodyLabel(const QString& text, QWidget* parent);
QLabel* quietLabel(const QString& text, QWidget* parent);
QLabel* hugeLabel(const QString& text, QWidget* parent);
/// The heading of a window or of a column.
QLabel* headingLabel(const QString& text, QWidget* parent);
/// The heading of a part of a page.
QLabel* sectionLabel(const QString& text, QWidget* parent);

/// A text for participants in the subset of Markdown that instruments and protocols may use:
/// headings, paragraphs, lists, bold and italics. Links become plain text, pictures are left out.
/// Text in double square brackets, a blank of the study, is marked.
QLabel* textLabel(const QString& markdown, QWidget* parent);

/// How good something is. Each has a sign as well as a colour.
enum class Mark { Good, Warning, Bad, None };
/// "✓", "!", "✕"; empty for none.
QString signOf(Mark mark);
/// Shows a state on a pale ground, with its sign before the words.
void showMarked(QLabel& label, Mark mark, const QString& words);

/// A layout of @p parent within @p margins [px]. Without @p spacing, that of the style.
template <class Layout>
Layout* withMargins(QWidget* parent, const QMargins& margins, int spacing = -1) {
  auto* layout = new Layout(parent);
  layout->setContentsMargins(margins);
  layout->setSpacing(spacing);
  return layout;
}
template <class Layout>
Layout* withoutMargins(QWidget* parent = nullptr, int spacing = -1) {
  return withMargins<Layout>(parent, {}, spacing);
}

/// Resizes a window to @p wanted, or to the room that its screen has for it and its frame.
void resizeOnScreen(QWidget& window, const QSize& wanted);

/// Changes the style of a label ("good", "warn", "resting", "bad", "quiet", "heading") or a button
/// ("main", "tool"; "": as other buttons).
void setRole(QWidget& widget, const char* role);

}  // namespace study::gui
