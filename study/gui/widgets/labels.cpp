#include "study/gui/widgets/labels.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLocale>
#include <QStyle>

#include "study/gui/widgets/desk_language.h"
#include "study/report/marked_text.h"

namespace study::gui {
namespace {

QLabel* label(const QString& text, const char* role, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", QString::fromLatin1(role));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

}  // namespace

QString asText(std::string_view words) {
  return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

QLabel* titleLabel(const QString& text, QWidget* parent) {
  return label(text, "title", parent);
}
QLabel* bodyLabel(const QString& text, QWidget* parent) {
  return label(text, "body", parent);
}
QLabel* quietLabel(const QString& text, QWidget* parent) {
  return label(text, "quiet", parent);
}

QLabel* textLabel(const QString& markdown, QWidget* parent) {
  auto* text = label(report::asHtml(markdown), "text", parent);
  text->setTextFormat(Qt::RichText);
  text->setTextInteractionFlags(Qt::NoTextInteraction);
  return text;
}

QString capitalised(const QString& words) {
  return words.left(1).toUpper() + words.mid(1);
}

QString statusInWords(SessionState state) {
  return spoken(asText(statusOf(state)).replace(u'_', u' ').toStdString());
}

QString describeUnfinished(const UnfinishedSession& session) {
  const auto begun = session.startedUtc.substr(0, 10) + " " + session.startedUtc.substr(11, 5);
  return QString::fromStdString(
      said(
          "{} ({}), begun {} UTC, is in step {} of {} ({}).",
          session.participant,
          said(nameOf(session.runMode)),
          begun,
          session.step + 1,
          session.steps,
          session.place) +
      " " + said(whatHappened(session)));
}

QString nativeName(const QString& language) {
  // Qt names the default regional variant ("American English").
  if (language == QStringLiteral("en")) return QStringLiteral("English");
  const QString name = QLocale(language).nativeLanguageName();
  return name.isEmpty() ? language : name.left(1).toUpper() + name.mid(1);
}

QString cohortTitle(const protocols::Protocol& protocol, const std::string& id) {
  const auto* cohort = protocol.cohort(id);
  return QString::fromStdString(cohort == nullptr ? id : cohort->title.in(deskLanguage()));
}

void setRole(QLabel& label, const char* role) {
  const QString wanted = QString::fromLatin1(role);
  if (label.property("role").toString() == wanted) return;
  label.setProperty("role", wanted);
  label.style()->unpolish(&label);  // makes the style sheet read the role again
  label.style()->polish(&label);
  QEvent change(QEvent::StyleChange);  // the frame updates its margins on this event
  QCoreApplication::sendEvent(&label, &change);
}

QLabel* hugeLabel(const QString& text, QWidget* parent) {
  auto* huge = label(text, "huge", parent);
  huge->setAlignment(Qt::AlignCenter);
  return huge;
}

}  // namespace study::gui
