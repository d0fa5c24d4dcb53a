#include "study/gui/widgets/desk_language.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include "haptics/devices/device.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/model/storage_error.h"
#include "study/words/words.h"

namespace study::gui {
namespace {

constexpr const char* kLanguageKey = "language";

/// The texts of all windows but the participant's.
class DeskTranslator final : public QTranslator {
 public:
  void setLanguage(words::Words words) { words_ = std::move(words); }
  const words::Words& words() const noexcept { return words_; }

  bool isEmpty() const override { return words_.catalogue().desk.empty(); }

  QString translate(const char* window, const char* english, const char* /*comment*/, int /*count*/)
      const override {
    const auto& catalogue = words_.catalogue();
    if (catalogue.windows.contains(std::string_view(window))) return {};
    const auto text = catalogue.desk.find(std::string_view(english));
    return text == catalogue.desk.end() ? QString() : QString::fromStdString(text->second);
  }

 private:
  words::Words words_;
};

struct Desk {
  DeskTranslator texts;
  QTranslator dialogs;  ///< of Qt's own dialogs; empty if Qt's translations are not installed
};

Desk& desk() {
  static Desk one;
  return one;
}

}  // namespace

const std::string& deskLanguage() noexcept {
  return desk().texts.words().language();
}

void setDeskLanguage(std::string_view language) {
  auto& [texts, dialogs] = desk();
  QCoreApplication::removeTranslator(&texts);
  QCoreApplication::removeTranslator(&dialogs);
  texts.setLanguage(words::wordsOrEnglish(language));
  if (texts.isEmpty()) return;
  const auto file = QStringLiteral("qtbase_%1").arg(asText(language));
  if (dialogs.load(file, QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(&dialogs);
  }
  QCoreApplication::installTranslator(&texts);  // installed last, so Qt asks it first
}

void applyChosenLanguage() {
  // Fields have numbers as sentences and files have them: with a point, in every language.
  QLocale::setDefault(QLocale::c());
  const auto chosen = studioSettings().value(QLatin1String(kLanguageKey)).toString();
  const auto computer = QLocale::system().name().section(u'_', 0, 0);
  setDeskLanguage((chosen.isEmpty() ? computer : chosen).toStdString());
}

void addLanguagesTo(QMenu& menu) {
  auto* group = new QActionGroup(&menu);
  for (const auto& language : words::languages()) {
    const auto tag = QString::fromStdString(language);
    auto* action = menu.addAction(nativeName(tag));
    action->setObjectName(QStringLiteral("language-") + tag);
    action->setCheckable(true);
    action->setChecked(language == deskLanguage());
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, action, [tag] {
      studioSettings().setValue(QLatin1String(kLanguageKey), tag);
      setDeskLanguage(tag.toStdString());
    });
  }
}

std::string translated(std::string_view english) {
  const auto& texts = desk().texts.words().catalogue().desk;
  const auto text = texts.find(english);
  return text == texts.end() ? std::string(english) : text->second;
}

QString deskText(std::string_view english) {
  return QString::fromStdString(translated(english));
}

QString deskText(const base::Message& message) {
  return QString::fromStdString(desk().texts.words()(message));
}

QString deskText(const std::exception& error) {
  if (const auto* ofDevice = dynamic_cast<const haptics::devices::DeviceError*>(&error)) {
    return QString::fromStdString(desk().texts.words()(ofDevice->messages()));
  }
  const auto* ofStorage = dynamic_cast<const storage::StorageError*>(&error);
  const bool hasMessage = ofStorage != nullptr && !ofStorage->message().empty();
  return hasMessage ? deskText(ofStorage->message()) : QString::fromUtf8(error.what());
}

}  // namespace study::gui
