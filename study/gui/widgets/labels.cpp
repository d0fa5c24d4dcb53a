#include "study/gui/widgets/labels.h"

#include <map>
#include <utility>

#include <QCoreApplication>
#include <QDateTime>
#include <QEvent>
#include <QLocale>
#include <QRegularExpression>
#include <QScreen>
#include <QStyle>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/theme.h"
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

/// A blank that the laboratory has not filled in must not look like a text of the study.
QString withBlanksMarked(QString html, const QWidget* where) {
  static const QRegularExpression kBlank(QStringLiteral("(\\[\\[[^\\]]*\\]\\])"));
  if (where == nullptr || !html.contains(QStringLiteral("[["))) return html;
  const auto& warn = themeOf(*where).warn;
  return html.replace(
      kBlank,
      QStringLiteral("<span style=\"background-color:%1; color:%2; font-weight:600\">\\1</span>")
          .arg(warn.background.name(), warn.text.name()));
}

/// Formatted text. The gaps between its paragraphs grow with the window's scale; Qt's own gaps do
/// not.
class MarkedText final : public QLabel {
 public:
  MarkedText(const QString& markdown, QWidget* parent)
      : QLabel(parent), html_(withBlanksMarked(report::asHtml(markdown), parent)) {
    setProperty("role", QStringLiteral("text"));
    setTextFormat(Qt::RichText);
    setWordWrap(true);
    setTextInteractionFlags(Qt::NoTextInteraction);
    spaceOut();
  }

  /// Layouts ask for the height several times, and each time QLabel would break the lines again.
  int heightForWidth(int width) const override {
    auto known = heights_.find(width);
    if (known == heights_.end())
      known = heights_.emplace(width, QLabel::heightForWidth(width)).first;
    return known->second;
  }

 protected:
  bool event(QEvent* event) override {
    const auto type = event->type();
    if (type == QEvent::StyleChange) spaceOut();
    if (type == QEvent::StyleChange || type == QEvent::FontChange || type == QEvent::Polish ||
        type == QEvent::ContentsRectChange) {
      heights_.clear();
    }
    return QLabel::event(event);
  }

 private:
  void spaceOut() {
    constexpr int kGap = 8;           // [px] at scale 1, below a paragraph
    constexpr int kAboveHeading = 8;  // [px] at scale 1, in addition
    const int gap = scaled(*this, kGap);
    // A single paragraph, such as a statement, needs no gap below it.
    const bool hasSeveralParagraphs = html_.count(QStringLiteral("<p>")) > 1 ||
                                      html_.contains(QStringLiteral("<h")) ||
                                      html_.contains(QStringLiteral("<li"));
    if (gap == std::exchange(gap_, gap)) return;
    QString html = html_.trimmed();
    const auto styled = [&](const char* tag, int above, int below, int line) {
      html.replace(
          QStringLiteral("<%1>").arg(QLatin1String(tag)),
          QStringLiteral("<%1 style=\"margin-top:%2px; margin-bottom:%3px; line-height:%4%\">")
              .arg(QLatin1String(tag))
              .arg(above)
              .arg(below)
              .arg(line));
    };
    constexpr int kLineHeight = 118;  // line height [%], so that the eye finds the next line
    styled("p", 0, hasSeveralParagraphs ? gap : 0, kLineHeight);
    styled("li", 0, gap / 2, kLineHeight);
    for (const auto* heading : {"h2", "h3"}) {
      styled(heading, scaled(*this, kAboveHeading), gap / 2, 100);
    }
    // No gap above a heading that begins the text, nor below its last paragraph.
    static const QRegularExpression kAboveFirst(
        QStringLiteral("^(<h[23] style=\"margin-top:)\\d+"));
    static const QRegularExpression kBelowLast(
        QStringLiteral("(<p style=\"margin-top:0px; margin-bottom:)\\d+(?=[^>]*>[^<]*</p>$)"));
    const auto none = QStringLiteral("\\1") + QLatin1Char('0');
    heights_.clear();
    setText(html.replace(kAboveFirst, none).replace(kBelowLast, none));
  }

  QString html_;
  int gap_ = -1;
  mutable std::map<int, int> heights_;  ///< by width [px]
};

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
QLabel* headingLabel(const QString& text, QWidget* parent) {
  return label(text, "heading", parent);
}
QLabel* sectionLabel(const QString& text, QWidget* parent) {
  return label(text, "section", parent);
}

QLabel* textLabel(const QString& markdown, QWidget* parent) {
  return new MarkedText(markdown, parent);
}

QString capitalised(const QString& words) {
  return words.left(1).toUpper() + words.mid(1);
}

QString localTime(const std::string& utc) {
  const auto when = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  return when.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

QString phaseTitle(const std::string& id) {
  auto words = capitalised(QString::fromStdString(id));
  return words.replace(u'-', u' ').replace(u'_', u' ');
}

QString describe(const Step& step, const protocols::Labels& labels) {
  // A phase that is called as what it is has a name in every language.
  const auto kind = nameOf(step.kind);
  const bool isNamedAsKind = phaseTitle(step.phase) == phaseTitle(std::string(kind));
  const auto phase = isNamedAsKind ? capitalised(deskText(kind)) : phaseTitle(step.phase);
  const auto alternative =
      QString::fromStdString(labels.nameOf(std::to_string(step.label), deskLanguage()));
  const auto filled = [&](const char* words) { return deskText(words).arg(phase, alternative); };
  if (step.isOptionalTrial) return filled("%1: %2 again?");
  if (step.kind == StepKind::Trial) return filled("%1: %2");
  if (step.kind == StepKind::Questionnaire) return filled("%1: questions on %2");
  return phase;
}

QString statusInWords(SessionState state) {
  if (state == SessionState::AbortedHardware) return deskText("device failed");
  return deskText(asText(statusOf(state)).replace(u'_', u' ').toStdString());
}

QString describeUnfinished(const UnfinishedSession& session) {
  return QString::fromStdString(
      translated(
          "{} ({}), begun {}, is in step {} of {}: {}.",
          session.participant,
          translated(nameOf(session.runMode)),
          localTime(session.startedUtc).toStdString(),
          session.step + 1,
          session.steps,
          describe(session.at, session.labels).toStdString()) +
      " " + translated(whatHappened(session)));
}

QStringList choicesFor(const UnfinishedSession& session) {
  QStringList lines;
  if (session.isOpenElsewhere()) {
    const auto& holder = *session.holder;
    lines << QString::fromStdString(
        translated(kOpenThere, holder.station, holder.pid, localTime(holder.since).toStdString()));
    if (session.mayBeTakenOver()) {
      lines << QString::fromStdString(
          translated(kTakeOver, localTime(session.lastStoredUtc).toStdString()));
    }
    return lines;
  }
  for (const auto& choice : session.choices) lines << deskText(choice);
  return lines;
}

QString nativeName(const QString& language) {
  // Qt names the default regional variant ("American English").
  if (language == QStringLiteral("en")) return QStringLiteral("English");
  const QString name = QLocale(language).nativeLanguageName();
  return name.isEmpty() ? language : name.left(1).toUpper() + name.mid(1);
}

void addLanguages(QComboBox& box, const std::vector<std::string>& tags) {
  for (const auto& language : tags) {
    const auto tag = QString::fromStdString(language);
    box.addItem(nativeName(tag), tag);
  }
}

void chooseLanguage(QComboBox& box, const std::string& tag) {
  const int place = box.findData(QString::fromStdString(tag));
  if (place >= 0) box.setCurrentIndex(place);
}

QString cohortTitle(const protocols::Protocol& protocol, const std::string& id) {
  const auto* cohort = protocol.cohort(id);
  return QString::fromStdString(cohort == nullptr ? id : cohort->title.in(deskLanguage()));
}

void resizeOnScreen(QWidget& window, const QSize& wanted) {
  constexpr QSize kFrame(16, 48);  // [px]: a desktop tells its own only after it is shown
  window.resize(wanted.boundedTo(window.screen()->availableSize() - kFrame));
}

QString signOf(Mark mark) {
  static constexpr const char* kSigns[]{"✓", "!", "✕", ""};
  return QString::fromUtf8(kSigns[static_cast<std::size_t>(mark)]);
}

void showMarked(QLabel& label, Mark mark, const QString& words) {
  static constexpr const char* kRoles[]{"good", "warn", "bad", "resting"};
  setRole(label, kRoles[static_cast<std::size_t>(mark)]);
  const auto sign = signOf(mark);
  label.setText(sign.isEmpty() ? words : sign + QStringLiteral("  ") + words);
}

void setRole(QWidget& widget, const char* role) {
  const QString wanted = QString::fromLatin1(role);
  if (widget.property("role").toString() == wanted) return;
  widget.setProperty("role", wanted);
  widget.style()->unpolish(&widget);  // makes the style sheet read the role again
  widget.style()->polish(&widget);
  QEvent change(QEvent::StyleChange);  // the frame updates its margins on this event
  QCoreApplication::sendEvent(&widget, &change);
}

QLabel* hugeLabel(const QString& text, QWidget* parent) {
  auto* huge = label(text, "huge", parent);
  huge->setAlignment(Qt::AlignCenter);
  return huge;
}

}  // namespace study::gui
