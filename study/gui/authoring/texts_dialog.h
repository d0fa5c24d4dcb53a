#pragma once

#include <map>
#include <string>
#include <vector>

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/reading/instrument_file.h"

class QFormLayout;
class QPushButton;

namespace study::gui {

/// A form for the blanks in texts that participants read: institution, contact, ethics reference.
/// Each blank has one field, even if several texts contain it. A language without a text of its own
/// uses the English one.
class TextsDialog final : public QDialog {
  Q_OBJECT

 public:
  /// Whether a reason has to be given: an amendment needs one once a live session has begun.
  enum class Reason { Needed, NotNeeded };

  explicit TextsDialog(
      const protocols::LoadedProtocol& loaded,
      Reason reason = Reason::NotNeeded,
      QWidget* parent = nullptr);

  /// The texts of the form, and those of the protocol that have no field in the form.
  questionnaires::BlankTexts texts() const;
  QString reason() const { return reason_->text().trimmed(); }

 public slots:
  /// Asks before what was typed is lost.
  void reject() override;

 private:
  void addFields(const protocols::LoadedProtocol& loaded, QFormLayout& form);
  void showLanguage();
  void showSentences();
  QString filledByLanguage() const;
  void storeFields();
  void showProgress();

  questionnaires::BlankTexts protocolTexts_;
  questionnaires::BlankTexts textsAtFirst_;                 ///< of the form as it opens
  std::vector<protocols::LocalizedText> participantTexts_;  ///< with the blanks, to be shown
  std::map<std::string, QLineEdit*> fields_;                ///< by key
  std::map<std::string, QLabel*> sentences_;                ///< with a gap, above each field
  std::map<std::string, std::map<std::string, std::string>> typedTexts_;  ///< by key and language
  std::string shownLanguage_ = "en";  ///< the language of the fields
  QComboBox* languages_;
  QLineEdit* reason_;
  QLabel* progress_;
  QPushButton* saveButton_;
};

}  // namespace study::gui
