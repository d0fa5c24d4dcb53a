#pragma once

#include <string>
#include <vector>

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// What may be told of a study's people to strangers; without what it is for, only counted.
/// @throws storage::StorageError  in words, if they are fewer than @p options asks a class to have.
Release publicRelease(Study& study, const ExportOptions& options);

/// The tables that go to strangers: people as far as publicRelease() lets them be told, answers
/// without words, times, dates and what else would single somebody out. Ids are drawn from the
/// system's random numbers and rows are in an order drawn from them: nothing leads back.
/// @throws storage::StorageError  as publicRelease()
std::vector<ExportedTable> publicTables(Study& study, const ExportOptions& options);

/// What a person who opens the folder reads first.
std::string publicReadme(Study& study, const ExportOptions& options, const Release& release);

/// Who may be found among whom, in a few lines for the desk: the smallest class before and after,
/// and what causes it.
std::string describe(const Release& release);

}  // namespace study
