// palpate-studio: the program with windows. All its functions are also available in palpate.
#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <string_view>

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QIcon>

#include "study/app/printing/visible_output.h"
#include "study/app/studio_options.h"
#include "study/gui/authoring/protocol_window.h"
#include "study/gui/desk/help_window.h"
#include "study/gui/desk/key_question.h"
#include "study/gui/desk/recent_studies.h"
#include "study/gui/desk/tour.h"
#include "study/gui/home/home_window.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/scene/shapes/knee_anatomy.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/mnemonics.h"
#include "study/gui/widgets/theme.h"
#include "study/model/new_file.h"
#include "study/model/storage_error.h"
#include "study/session/study.h"

namespace {

bool isAmong(int argc, char** argv, std::initializer_list<std::string_view> words) {
  return std::any_of(argv + 1, argv + argc, [&](const char* argument) {
    return std::ranges::find(words, argument) != words.end();
  });
}

/// Whether a window can be opened. Without a display Qt would abort the program.
bool hasScreen(int argc, char** argv) {
  for (const char* place : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    if (!qEnvironmentVariableIsEmpty(place)) return true;
  }
  return isAmong(argc, argv, {"-platform", "--platform"});
}

void describe(QCommandLineParser& parser) {
  const auto program = study::app::describeStudio();
  QCoreApplication::setApplicationName(QString::fromStdString(program.name));
  QCoreApplication::setApplicationVersion(QString::fromUtf8(study::appVersion().data()));
  parser.setApplicationDescription(QString::fromStdString(program.text));
  parser.addHelpOption();
  parser.addVersionOption();
  for (const auto& option : program.options) {
    const auto name = QString::fromStdString(study::app::nameOf(option));
    const auto text = QString::fromStdString(option.text);
    if (option.isPositional) {
      parser.addPositionalArgument(name, text, '[' + name + ']');
    } else if (name != QLatin1String("help") && name != QLatin1String("version")) {
      parser.addOption(
          {name,
           text,
           QString::fromStdString(option.value),
           QString::fromStdString(option.defaultValue)});
    }
  }
}

/// The folder of the study. Also accepts the path of its study.db, as file managers pass it.
QString folderOf(const QString& path) {
  const QFileInfo file(path);
  return file.fileName() == QLatin1String("study.db") ? file.absolutePath() : path;
}

int writeKnee(const QString& path) {
  try {
    study::writeNewFile(path.toStdString(), study::gui::scene::kneeAsObj({}));
  } catch (const study::storage::StorageError& error) {
    std::fprintf(stderr, "palpate-studio: %s\n", error.what());
    return 1;
  }
  std::printf("%s\n", qPrintable(path));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  study::setPrivateUmask();
  study::forbidCoreFiles();
  study::app::escapeControlCharactersInOutput();
  QCommandLineParser parser;
  describe(parser);
  if (isAmong(argc, argv, {"--help", "-h", "-?", "--help-all", "--version", "-v"})) {
    const QCoreApplication withoutWindows(argc, argv);
    parser.process(withoutWindows);
  }
  if (isAmong(argc, argv, {"--write-knee"})) {
    const QCoreApplication withoutWindows(argc, argv);
    parser.process(withoutWindows);
    return writeKnee(parser.value(QStringLiteral("write-knee")));
  }
  if (!hasScreen(argc, argv)) {
    std::fputs(
        "palpate-studio: there is no screen to open a window on (neither DISPLAY nor "
        "WAYLAND_DISPLAY is set). Start it at the computer's own desk or with 'ssh -X'; 'palpate "
        "study run' runs a session in a terminal.\n",
        stderr);
    return 1;
  }
  QApplication application(argc, argv);
  QGuiApplication::setDesktopFileName(QStringLiteral(PALPATE_DESKTOP_ID));
  QGuiApplication::setWindowIcon(QIcon(QStringLiteral(":/palpate.svg")));
  study::gui::applyChosenTheme(application);
  study::gui::applyChosenLanguage();
  study::gui::installHelpKey(application);
  study::gui::installMnemonics(application);
  parser.process(application);

  const QString path = parser.positionalArguments().value(0);
  const std::string devices = parser.value(QStringLiteral("devices")).toStdString();
  if (path.isEmpty()) {
    study::gui::HomeWindow home(devices);
    home.show();
    if (study::gui::Tour::isUnseen()) home.showTour();
    return QApplication::exec();
  }
  if (path.endsWith(QLatin1String(".json"))) {
    study::gui::ProtocolWindow protocol(path);
    protocol.show();
    return QApplication::exec();
  }

  const QString folder = folderOf(path);
  int status = 1;
  study::gui::askForPassphraseOfKey(folder.toStdString(), nullptr);
  study::gui::askForPassphraseOfNames(folder.toStdString(), nullptr);
  study::gui::attempt(nullptr, study::gui::MessageTopic::StudyNotOpened, [&] {
    auto study = study::Study::open(folder.toStdString());
    study::gui::OperatorWindow window(study, devices);
    const auto& title = study.protocol().protocol.study.title;
    study::gui::addRecentStudy(folder, QString::fromStdString(title));
    window.show();
    status = QApplication::exec();
  });
  return status;
}
