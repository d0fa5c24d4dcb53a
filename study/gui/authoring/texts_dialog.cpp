#include "study/gui/authoring/texts_dialog.h"

#include <algorithm>
#include <cmath>

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/reading/instrument_problems.h"
#include "study/gui/participant/participant_window.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/fitting_scroll.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"
#include "study/session/session_length.h"

namespace study::gui {
namespace {

/// The key of the blank for how long data are kept [years]; the texts name the unit.
constexpr std::string_view kYearsBlank = "data_kept_years";
constexpr std::string_view kContactBlank = "contact";

/// The session's duration by the timeline [min], rounded up to a multiple of five.
std::string estimatedMinutes(const protocols::LoadedProtocol& loaded) {
  constexpr double kSecondsPerMinute = 60.0;
  constexpr double kRoundedTo = 5.0;  // [min]
  const double minutes = lengthOf(loaded, {}).seconds / kSecondsPerMinute;
  return std::to_string(std::lround(std::ceil(minutes / kRoundedTo) * kRoundedTo));
}

/// Every text that participants read, in the order of the session.
std::vector<protocols::LocalizedText> textsFor(const protocols::LoadedProtocol& loaded) {
  std::vector<protocols::LocalizedText> texts;
  for (const auto& use : protocols::instrumentUses(loaded.protocol)) {
    auto instrument = *loaded.instrument(use.instrument);
    for (const auto& place : questionnaires::textPlacesOf(instrument)) {
      texts.push_back(*place.texts.front());
    }
  }
  for (const auto& phase : loaded.protocol.phases) texts.push_back(phase.text);
  return texts;
}

/// The first sentence with the blank @p key, in @p language, with gaps for its blanks: "You may ask
/// us to delete your data, until ____." Empty if it is nothing but blanks.
QString sentenceWith(
    const std::string& key,
    const std::string& language,
    const std::vector<protocols::LocalizedText>& texts) {
  static const QRegularExpression kBlank(QStringLiteral("\\[\\[[^\\]]*\\]\\]"));
  static const QRegularExpression kEnd(QStringLiteral("[.;] |\n"));
  const auto blank = QStringLiteral("[[%1]]").arg(QString::fromStdString(key));
  for (const auto& text : texts) {
    const auto words = QString::fromStdString(text.in(language));
    const auto place = words.indexOf(blank);
    if (place < 0) continue;
    qsizetype from = 0;
    for (auto end = kEnd.match(words); end.hasMatch() && end.capturedEnd() <= place;
         end = kEnd.match(words, end.capturedEnd())) {
      from = end.capturedEnd();
    }
    const auto end = kEnd.match(words, place + blank.size());
    auto sentence = words.mid(from, end.hasMatch() ? end.capturedStart() + 1 - from : -1);
    const auto rest = QString(sentence).remove(kBlank);
    const bool hasWords = std::ranges::any_of(rest, [](QChar c) { return c.isLetter(); });
    return hasWords ? sentence.replace(kBlank, QStringLiteral("____")).simplified() : QString();
  }
  return {};
}

}  // namespace

TextsDialog::TextsDialog(const protocols::LoadedProtocol& loaded, Reason reason, QWidget* parent)
    : QDialog(parent),
      protocolTexts_(loaded.protocol.texts),
      participantTexts_(textsFor(loaded)),
      languages_(new QComboBox(this)),
      reason_(new QLineEdit(this)),
      progress_(quietLabel({}, this)),
      saveButton_(new QPushButton(tr("Save"), this)) {
  setWindowTitle(tr("Fill in the texts"));
  languages_->setAccessibleName(tr("Language of the texts"));
  languages_->setObjectName(QStringLiteral("language"));
  for (const auto& language : loaded.protocol.languages) {
    const QString tag = QString::fromStdString(language);
    const QString name = nativeName(tag);
    languages_->addItem(
        language == "en" ? tr("%1 (also shown where another language is empty)").arg(name) : name,
        tag);
  }
  auto* form = new QFormLayout;
  form->setVerticalSpacing(10);
  form->setContentsMargins(0, 0, 8, 0);
  form->setRowWrapPolicy(QFormLayout::WrapAllRows);
  addFields(loaded, *form);
  showSentences();
  reason_->setAccessibleName(tr("Reason for the change"));
  reason_->setObjectName(QStringLiteral("reason"));
  form->addRow(tr("Reason for the change, for the audit trail"), reason_);
  form->setRowVisible(reason_, reason == Reason::Needed);
  auto* inside = new QWidget(this);
  inside->setLayout(form);
  auto* buttons = new QDialogButtonBox(this);
  saveButton_->setProperty("role", QStringLiteral("main"));
  saveButton_->setObjectName(QStringLiteral("save"));
  buttons->addButton(saveButton_, QDialogButtonBox::AcceptRole);
  buttons->addButton(QDialogButtonBox::Cancel);
  auto* layout = withMargins<QVBoxLayout>(this, {24, 20, 24, 20}, 12);
  auto* heading = headingLabel(windowTitle(), this);
  layout->addWidget(heading);
  layout->addWidget(quietLabel(
      tr("Participants read these words in the information, the consent form and at the end."),
      this));
  auto* chosen = new QWidget(this);  // not scrolled: all below depends on it
  auto* line = withoutMargins<QHBoxLayout>(chosen);
  line->addWidget(new QLabel(tr("Language"), chosen));
  line->addWidget(languages_, 1);
  layout->addWidget(chosen);
  chosen->setVisible(languages_->count() > 1);
  layout->addWidget(scrolled(inside, this), 1);
  layout->addWidget(progress_);
  layout->addWidget(buttons);
  resizeOnScreen(*this, {820, 760});
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(languages_, &QComboBox::currentIndexChanged, this, &TextsDialog::showLanguage);
  connect(reason_, &QLineEdit::textChanged, this, &TextsDialog::showProgress);
  showProgress();
  textsAtFirst_ = texts();
}

void TextsDialog::reject() {
  const bool isTyped = texts() != textsAtFirst_ || !reason().isEmpty();
  if (!isTyped || ask(this, MessageTopic::DiscardTexts)) QDialog::reject();
}

void TextsDialog::addFields(const protocols::LoadedProtocol& loaded, QFormLayout& form) {
  for (const auto& blank : protocols::blanksOf(loaded)) {
    typedTexts_[blank.key] = blank.text.all();
    auto* field = new QLineEdit(this);
    QString title = deskText(blank.title);
    field->setObjectName(QStringLiteral("text-") + QString::fromStdString(blank.key));
    if (blank.key == protocols::kDurationBlank && blank.text.isEmpty()) {
      field->setText(QString::fromStdString(estimatedMinutes(loaded)));
      title += tr(" (estimated from the timeline)");
    } else {
      field->setText(QString::fromStdString(blank.text.in("en")));
    }
    if (blank.key == kYearsBlank) {
      static const QRegularExpression kNumber(QStringLiteral("\\d{1,3}"));
      field->setValidator(new QRegularExpressionValidator(kNumber, field));
      title += tr(" (a number)");
    }
    if (blank.key == kContactBlank) {
      field->setPlaceholderText(tr("e.g. Dr A. Example, University of X, a.example@x.org, +47 …"));
    }
    field->setAccessibleName(title);
    auto* label = bodyLabel(title, this);
    label->setBuddy(field);
    form.addRow(label);  // a row of its own, which is as wide as the window
    sentences_[blank.key] = quietLabel({}, this);
    form.addRow(sentences_[blank.key]);
    form.addRow(field);
    fields_[blank.key] = field;
    connect(field, &QLineEdit::textChanged, this, &TextsDialog::showProgress);
  }
}

void TextsDialog::storeFields() {
  for (const auto& [key, field] : fields_) {
    const auto words = field->text().trimmed().toStdString();
    if (words.empty()) {
      typedTexts_[key].erase(shownLanguage_);
    } else {
      typedTexts_[key][shownLanguage_] = words;
    }
  }
}

void TextsDialog::showLanguage() {
  storeFields();
  shownLanguage_ = languages_->currentData().toString().toStdString();
  for (const auto& [key, field] : fields_) {
    const auto& words = typedTexts_[key];
    const auto text = [&](const std::string& language) {
      const auto found = words.find(language);
      return found == words.end() ? QString() : QString::fromStdString(found->second);
    };
    // Other fields still have the words of the language before: they must not be stored yet.
    const QSignalBlocker quiet(field);
    if (shownLanguage_ != "en" || key != kContactBlank) {
      field->setPlaceholderText(shownLanguage_ == "en" ? QString() : text("en"));
    }
    field->setText(text(shownLanguage_));
  }
  showSentences();
  showProgress();
}

void TextsDialog::showSentences() {
  for (const auto& [key, label] : sentences_) {
    const auto sentence = sentenceWith(key, shownLanguage_, participantTexts_);
    label->setText(sentence);
    label->setVisible(!sentence.isEmpty());
  }
}

/// "English 10, Deutsch 2".
QString TextsDialog::filledByLanguage() const {
  QStringList counts;
  for (int i = 0; i < languages_->count(); ++i) {
    const auto tag = languages_->itemData(i).toString();
    const auto filled = std::ranges::count_if(
        typedTexts_, [&](const auto& typed) { return typed.second.count(tag.toStdString()) > 0; });
    counts << QStringLiteral("%1 %2").arg(nativeName(tag)).arg(filled);
  }
  return counts.join(QStringLiteral(", "));
}

void TextsDialog::showProgress() {
  storeFields();
  int filled = 0;
  bool lacksEnglish = false;
  for (const auto& [key, words] : typedTexts_) {
    filled += words.empty() ? 0 : 1;
    lacksEnglish |= !words.empty() && words.count("en") == 0;
  }
  const int all = static_cast<int>(typedTexts_.size());
  const bool hasReason = !reason_->isVisibleTo(this) || !reason().isEmpty();
  progress_->setText(
      lacksEnglish ? tr("A text that is given in another language is also needed in English.")
      : filled < all
          ? tr("Of %1 texts are filled in: %2. A live session needs them all in English.")
                .arg(all)
                .arg(filledByLanguage())
          : tr("All %1 are filled in: %2.").arg(all).arg(filledByLanguage()));
  if (!hasReason) progress_->setText(progress_->text() + QLatin1Char(' ') + tr("Give a reason."));
  saveButton_->setEnabled(!lacksEnglish && hasReason);
}

questionnaires::BlankTexts TextsDialog::texts() const {
  auto texts = protocolTexts_;
  for (const auto& [key, words] : typedTexts_) {
    if (words.empty()) {
      texts.erase(key);
    } else {
      texts[key] = questionnaires::LocalizedText(words);
    }
  }
  return texts;
}

}  // namespace study::gui
