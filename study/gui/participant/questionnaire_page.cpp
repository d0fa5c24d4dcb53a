#include "study/gui/participant/questionnaire_page.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <QDate>
#include <QHBoxLayout>
#include <QLocale>
#include <QScrollBar>
#include <QStyle>

#include "study/gui/participant/column.h"
#include "study/gui/participant/side_by_side.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

using questionnaires::Item;

/// The items, with identifying items (signatures) moved directly after the consent that they sign.
std::vector<Item> withSignatures(std::vector<Item> items) {
  const auto consent = std::find_if(
      items.begin(), items.end(), [](const Item& item) { return !item.consentOption.empty(); });
  if (consent == items.end()) return items;
  std::stable_partition(
      consent + 1, items.end(), [](const Item& item) { return item.isIdentifying; });
  return items;
}

// [ms] for a participant who has already aimed to notice that another question is there now
constexpr int kIgnoreTime = 700;

/// The clauses of a consent text: its paragraphs, each with the heading above it.
QStringList clausesOf(const QString& text) {
  QStringList clauses;
  for (const auto& paragraph : text.split(QStringLiteral("\n\n"), Qt::SkipEmptyParts)) {
    const bool isBelowHeading =
        !clauses.isEmpty() && clauses.back().startsWith(u'#') && !clauses.back().contains(u'\n');
    if (isBelowHeading) {
      clauses.back() += QStringLiteral("\n\n") + paragraph;
    } else {
      clauses << paragraph;
    }
  }
  return clauses;
}

/// Divides a text at one of its headings, so that both parts are about equally long.
std::pair<QString, QString> inTwoColumns(const QString& text) {
  constexpr double kLineLength = 66.0;     // [characters]
  constexpr double kHeadingLines = 2.2;    // [lines], with the gaps around it
  constexpr double kParagraphLines = 0.6;  // [lines], the gap below it
  const auto clauses = clausesOf(text);
  std::vector<double> lengths;
  for (const auto& clause : clauses) {
    double lines = clause.startsWith(u'#') ? kHeadingLines : 0.0;
    for (const auto& line : clause.split(u'\n', Qt::SkipEmptyParts)) {
      if (!line.startsWith(u'#'))
        lines += std::ceil(static_cast<double>(line.size()) / kLineLength) + kParagraphLines;
    }
    lengths.push_back(lines);
  }
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  qsizetype first = clauses.size();
  double above = 0.0;
  double least = whole;
  for (qsizetype i = 0; i < clauses.size(); ++i) {
    const double longer = std::max(above, whole - above);
    if (clauses[i].startsWith(u'#') && longer < least) {
      least = longer;
      first = i;
    }
    above += lengths[static_cast<std::size_t>(i)];
  }
  const auto joined = [&](qsizetype from, qsizetype to) {
    return clauses.mid(from, to - from).join(QStringLiteral("\n\n"));
  };
  return {joined(0, first), joined(first, clauses.size())};
}

bool isSignature(const std::vector<Item>& items, std::size_t index) {
  if (!items[index].isIdentifying || index == 0) return false;
  return !items[index - 1].consentOption.empty() || isSignature(items, index - 1);
}

}  // namespace

QuestionnairePage::QuestionnairePage(const Content& content, QWidget* parent)
    : QWidget(parent),
      scroll_(new PageScroll(this)),
      scrollContents_(new QWidget(scroll_)),
      items_(withSignatures(content.items)),
      language_(content.language),
      ignoreTimer_(new QTimer(this)) {
  ignoreTimer_->setObjectName(QStringLiteral("settling"));
  ignoreTimer_->setSingleShot(true);
  ignoreTimer_->setInterval(kIgnoreTime);
  connect(ignoreTimer_, &QTimer::timeout, this, [this] {
    for (auto* sheet : sheets_) sheet->setAttribute(Qt::WA_TransparentForMouseEvents, false);
  });
  auto* outer = withoutMargins<QVBoxLayout>(this);
  addContents(content);
  scroll_->setWidget(scrollContents_);
  outer->addWidget(scroll_);
  // A focus frame around the first answer would look like a choice and could influence
  // participants. It appears with the first Tab.
  scroll_->setAccessibleName(content.title);
  scroll_->setAccessibleDescription(content.introduction);
  setFocusProxy(scroll_);
  const auto* bar = scroll_->verticalScrollBar();
  connect(bar, &QScrollBar::valueChanged, this, &QuestionnairePage::scrolled);
  connect(bar, &QScrollBar::rangeChanged, this, &QuestionnairePage::scrolled);
  shown_.start();
  shownAt_.front() = 0.0;
  updateAskedItems();
}

/// The title; below it the introduction and the questions, or both in two columns: a text that is
/// only read, and the terms of a consent beside the question.
void QuestionnairePage::addContents(const Content& content) {
  auto* column = addColumn(*scrollContents_, ColumnWidth::Page, ColumnIn::Scroll);
  const bool isConsent = std::any_of(
      items_.begin(), items_.end(), [](const Item& item) { return !item.consentOption.empty(); });
  column->addWidget(titleLabel(content.title, scrollContents_));
  auto* questions = new QWidget(scrollContents_);
  place_ = withoutMargins<QVBoxLayout>(questions);
  if (isConsent) {
    column->addWidget(new SideBySide(makeTerms(content.introduction), questions, scrollContents_));
  } else {
    const auto& text = content.introduction;
    if (!text.isEmpty()) column->addWidget(items_.empty() ? makeText(text) : makeTextInLines(text));
    column->addWidget(questions);
    questions->setVisible(!items_.empty());
  }
  addSheet();
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (items_[i].startsPage && !entries_.empty()) addSheet();
    addItem(content, i);
  }
  column->addStretch(1);
}

/// The terms of a consent, one below the other.
QWidget* QuestionnairePage::makeTerms(const QString& introduction) {
  auto* head = new QWidget(scrollContents_);
  auto* clauses = withoutMargins<QVBoxLayout>(head);
  constexpr int kBetweenClauses = 14;  // [px] at scale 1
  clauses->setSpacing(scaled(*this, kBetweenClauses));
  for (const auto& clause : clausesOf(introduction)) clauses->addWidget(clauseOf(clause));
  return head;
}

/// A text in lines of about 75 characters.
QWidget* QuestionnairePage::makeTextInLines(const QString& markdown) {
  auto* part = new QWidget(scrollContents_);
  auto* across = withoutMargins<QHBoxLayout>(part);
  auto* text = new QWidget(part);
  text->setProperty("role", QStringLiteral("lines"));
  auto* lines = withoutMargins<QVBoxLayout>(text);
  lines->addWidget(textLabel(markdown, text));
  constexpr int kFirst = 1000;  // stretch, up to the width of the lines
  across->addWidget(text, kFirst);
  across->addStretch(1);
  return part;
}

/// A text that is only read, in two columns where there is room.
QWidget* QuestionnairePage::makeText(const QString& introduction) {
  const auto [first, second] = inTwoColumns(introduction);
  if (second.isEmpty()) return makeTextInLines(first);
  return new SideBySide(makeTextInLines(first), makeTextInLines(second), scrollContents_);
}

void QuestionnairePage::addSheet() {
  auto* sheet = new QWidget(scrollContents_);
  withoutMargins<QVBoxLayout>(sheet, scaled(*this, 14));
  place_->addWidget(sheet);
  if (!sheets_.empty()) sheet->hide();
  sheets_.push_back(sheet);
  shownAt_.push_back(-1.0);
}

/// A frame with one clause of a consent text, separate from the next one so that each is read by
/// itself.
QFrame* QuestionnairePage::clauseOf(const QString& text) {
  auto* clause = new QFrame(scrollContents_);
  clause->setProperty("role", QStringLiteral("clause"));
  auto* layout = new QVBoxLayout(clause);
  const int above = scaled(*this, 5);
  layout->setContentsMargins(scaled(*this, 14), above, scaled(*this, 14), above / 2);
  layout->addWidget(textLabel(text, clause));
  return clause;
}

QFrame* QuestionnairePage::addCard() {
  auto* card = new QFrame(sheets_.back());
  card->setProperty("role", "card");
  auto* layout = new QVBoxLayout(card);
  const int side = scaled(*this, 20);
  const int above = scaled(*this, 16);
  layout->setContentsMargins(side, above, side, above);
  layout->setSpacing(scaled(*this, 8));
  sheets_.back()->layout()->addWidget(card);
  return card;
}

void QuestionnairePage::addItem(const Content& content, std::size_t index) {
  const auto& item = items_[index];
  auto* card = isSignature(items_, index) ? entries_.back().card : addCard();
  constexpr int kAboveSignature = 10;  // [px] at scale 1, besides the usual space
  if (isSignature(items_, index)) {
    static_cast<QVBoxLayout*>(card->layout())->addSpacing(scaled(*this, kAboveSignature));
  }
  auto* mark = quietLabel(tr("Please answer this one"), card);
  setRole(*mark, "warn");
  mark->hide();
  auto* widget = makeItemWidget(item, content.choices, content.language, card);
  card->layout()->addWidget(mark);
  card->layout()->addWidget(widget);
  if (!item.isRequired) widget->addRemark(tr("(optional)"));
  if (isSignature(items_, index) && !items_[index - 1].consentOption.empty()) {
    const auto today = QLocale(content.language).toString(QDate::currentDate(), tr("d MMMM yyyy"));
    auto* date = quietLabel(tr("Date: %1").arg(today), widget);
    date->setWordWrap(false);
    widget->putBesideField(*date);
  }
  entries_.push_back(
      {.widget = widget,
       .card = card,
       .mark = mark,
       .sheet = static_cast<int>(sheets_.size()) - 1});
  for (const auto& answer : content.before) {
    if (answer.item != item.id) continue;
    widget->show(answer.response);
    entries_.back().state = {answer.response, answer.firstTouch, answer.changes};
  }
  connect(widget, &ItemWidget::changed, this, [this, index] {
    emitAnswer(index);
    updateAskedItems();
    emit progressChanged();
  });
}

double QuestionnairePage::now() const {
  return static_cast<double>(shown_.elapsed()) / 1000.0;
}

std::optional<questionnaires::Response> QuestionnairePage::responseOf(const Entry& entry) const {
  return entry.isAsked ? entry.widget->response() : std::nullopt;
}

bool QuestionnairePage::isOpen(const Entry& entry) const {
  const auto& item = entry.widget->item();
  if (!item.isRequired || !entry.isAsked) return false;
  const auto response = entry.widget->response();
  if (!response) return true;
  // Only the session knows which alternatives may be chosen.
  if (item.optionSource == questionnaires::OptionSource::Alternatives) return false;
  return questionnaires::validationError(item, *response).has_value();
}

bool QuestionnairePage::isComplete() const {
  return std::none_of(
      entries_.begin(), entries_.end(), [this](const Entry& entry) { return isOpen(entry); });
}

QuestionnairePage::Progress QuestionnairePage::progress() const {
  Progress progress;
  for (const auto& entry : entries_) {
    if (entry.sheet != sheet_ || !entry.isAsked || !entry.widget->item().isRequired) continue;
    ++progress.required;
    if (isOpen(entry)) ++progress.open;
  }
  return progress;
}

void QuestionnairePage::mark(Entry& entry, bool isOpen) {
  if (entry.mark->isVisibleTo(entry.card) == isOpen) return;
  // A mark leaves its place free when it goes, so that no question moves under the pointer.
  auto policy = entry.mark->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  entry.mark->setSizePolicy(policy);
  entry.mark->setVisible(isOpen);
  entry.card->setProperty("isOpen", isOpen ? QStringLiteral("true") : QString());
  entry.card->style()->unpolish(entry.card);  // makes the style sheet read the property again
  entry.card->style()->polish(entry.card);
}

void QuestionnairePage::scrollToFirstUnanswered() {
  const auto isOpenHere = [this](const Entry& entry) {
    return entry.sheet == sheet_ && isOpen(entry);
  };
  const auto first = std::find_if(entries_.begin(), entries_.end(), isOpenHere);
  if (first == entries_.end()) return;
  for (auto& entry : entries_) {
    if (isOpenHere(entry)) mark(entry, true);
  }
  scroll_->widget()->layout()->activate();  // the mark has moved the widgets below it
  first->widget->setFocus(Qt::TabFocusReason);
  const int top = first->card->mapTo(scroll_->widget(), QPoint(0, 0)).y();
  const int margin = std::max(0, scroll_->viewport()->height() - first->card->height()) / 2;
  scroll_->verticalScrollBar()->setValue(top - margin);
}

bool QuestionnairePage::turnSheet(bool isForward) {
  const auto hasQuestions = [this](int sheet) {
    return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.sheet == sheet && entry.isAsked;
    });
  };
  const int by = isForward ? 1 : -1;
  int to = sheet_ + by;
  while (to >= 0 && to < sheets() && !hasQuestions(to)) to += by;
  if (to < 0 || to >= sheets()) return false;
  sheets_[static_cast<std::size_t>(sheet_)]->hide();
  sheets_[static_cast<std::size_t>(to)]->show();
  sheet_ = to;
  auto& shownAt = shownAt_[static_cast<std::size_t>(to)];
  if (shownAt < 0.0) shownAt = now();
  scroll_->verticalScrollBar()->setValue(0);
  scroll_->setFocus();
  emit progressChanged();
  return true;
}

void QuestionnairePage::emitAnswer(std::size_t index) {
  auto& entry = entries_[index];
  auto& state = entry.state;
  const auto response = responseOf(entry);
  const bool isNew = response != state.response;
  if (!isNew && state.isSaved) return;
  const double since = now() - std::max(0.0, shownAt_[static_cast<std::size_t>(entry.sheet)]);
  if (isNew) {
    if (state.changes < 0) state.firstTouch = since;
    ++state.changes;
  }
  state.response = response;
  state.isSaved = true;  // markUnsaved() is called before the signal returns
  if (!isOpen(entry)) mark(entry, false);
  const auto& item = entry.widget->item();
  if (response) {
    emit answered(
        {.item = item.id,
         .response = *response,
         .itemOrder = static_cast<int>(index) + 1,
         .firstTouch = state.firstTouch,
         .responseTime = std::max(since, state.firstTouch),
         .changes = state.changes,
         .language = language_.toStdString()});
  } else {
    emit retracted(QString::fromStdString(item.id));
  }
}

/// Shows the items whose conditions hold, and retracts the answers to those whose conditions do not
/// hold any more.
void QuestionnairePage::updateAskedItems() {
  std::vector<questionnaires::Answer> given;
  for (const auto& entry : entries_) {
    given.push_back({entry.widget->item().id, entry.widget->response()});
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    auto& entry = entries_[i];
    const bool isAsked = questionnaires::isAsked(items_[i], items_, given);
    if (isAsked == entry.isAsked) continue;
    entry.isAsked = isAsked;
    entry.card->setVisible(isAsked);
    if (entry.sheet == sheet_) ignorePresses();
    if (entry.widget->response()) emitAnswer(i);
  }
}

/// Ignores presses for a moment after questions have moved: a press aimed at one question would
/// answer another. The keyboard still works, because the focus moves with its question.
void QuestionnairePage::ignorePresses() {
  if (!isVisible()) return;
  sheets_[static_cast<std::size_t>(sheet_)]->setAttribute(Qt::WA_TransparentForMouseEvents);
  ignoreTimer_->start();
}

void QuestionnairePage::markUnsaved(const QString& item) {
  for (auto& entry : entries_) {
    if (entry.widget->item().id == item.toStdString()) entry.state.isSaved = false;
  }
}

void QuestionnairePage::flush() {
  for (std::size_t i = 0; i < entries_.size(); ++i) emitAnswer(i);
}

}  // namespace study::gui
