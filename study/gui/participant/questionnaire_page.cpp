#include "study/gui/participant/questionnaire_page.h"

#include <QFrame>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "study/gui/widgets/labels.h"

namespace study::gui {

QuestionnairePage::QuestionnairePage(const Content& content, QWidget* parent)
    : QWidget(parent), language_(content.language) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  auto* inside = new QWidget(scroll);
  auto* layout = new QVBoxLayout(inside);
  layout->setSpacing(18);
  layout->addWidget(titleLabel(content.title, inside));
  if (!content.introduction.isEmpty()) layout->addWidget(bodyLabel(content.introduction, inside));

  for (std::size_t i = 0; i < content.items.size(); ++i) {
    auto* card = new QFrame(inside);
    card->setProperty("role", "card");
    auto* inCard = new QVBoxLayout(card);
    inCard->setContentsMargins(20, 16, 20, 16);
    auto* widget = makeItemWidget(content.items[i], content.choices, content.language, card);
    inCard->addWidget(widget);
    if (!content.items[i].isRequired)
      inCard->addWidget(quietLabel(tr("You may leave this out."), card));
    layout->addWidget(card);
    widgets_.push_back(widget);
    states_.emplace_back();
    for (const auto& answer : content.before) {
      if (answer.item != content.items[i].id) continue;
      widget->show(answer.response);
      states_.back() = {answer.response, answer.firstTouch, answer.changes};
    }
    connect(widget, &ItemWidget::changed, this, [this, i] { emitAnswer(i); });
  }
  layout->addStretch(1);
  scroll->setWidget(inside);
  outer->addWidget(scroll);
  // A focus frame around the first answer would look like a choice and could influence
  // participants. It appears with the first Tab.
  scroll->setFocusPolicy(Qt::StrongFocus);
  scroll->setAccessibleName(content.title);
  scroll->setAccessibleDescription(content.introduction);
  setFocusProxy(scroll);
  shown_.start();
}

bool QuestionnairePage::isComplete() const {
  for (const auto* widget : widgets_) {
    if (!widget->item().isRequired) continue;
    const auto response = widget->response();
    if (!response || questionnaires::validationError(widget->item(), *response).has_value()) {
      const bool isAlternative =
          widget->item().optionSource == questionnaires::OptionSource::Alternatives;
      if (!response || !isAlternative) return false;
    }
  }
  return true;
}

void QuestionnairePage::emitAnswer(std::size_t index) {
  auto& state = states_[index];
  const auto response = widgets_[index]->response();
  const bool isNew = response != state.response;
  if (!isNew && state.isSaved) return;
  const double now = static_cast<double>(shown_.elapsed()) / 1000.0;
  if (isNew) {
    if (state.changes < 0) state.firstTouch = now;
    ++state.changes;
  }
  state.response = response;
  state.isSaved = true;  // markUnsaved() is called before the signal returns
  const auto& item = widgets_[index]->item();
  if (response) {
    emit answered(
        {.item = item.id,
         .response = *response,
         .itemOrder = static_cast<int>(index) + 1,
         .firstTouch = state.firstTouch,
         .responseTime = std::max(now, state.firstTouch),
         .changes = state.changes,
         .language = language_.toStdString()});
  } else {
    emit retracted(QString::fromStdString(item.id));
  }
  emit completeChanged(isComplete());
}

void QuestionnairePage::markUnsaved(const QString& item) {
  for (std::size_t i = 0; i < widgets_.size(); ++i) {
    if (widgets_[i]->item().id == item.toStdString()) states_[i].isSaved = false;
  }
}

void QuestionnairePage::flush() {
  for (std::size_t i = 0; i < widgets_.size(); ++i) emitAnswer(i);
}

}  // namespace study::gui
