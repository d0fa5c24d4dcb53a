#pragma once

#include <string>
#include <vector>

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// The quasi-identifiers of a study's people, generalised for release. ExportOptions::publicClass
/// must be set.
/// @throws storage::StorageError  if there are fewer people than the smallest class that @p options
///     ask for.
Release publicRelease(Study& study, const ExportOptions& options);

/// The tables of a public export: people with their released quasi-identifiers, and answers without
/// free text, times, dates or anything else that could identify a person. Ids and the order of rows
/// are random, so that they cannot be linked to the study.
/// @throws storage::StorageError  as publicRelease()
std::vector<ExportedTable> publicTables(Study& study, const ExportOptions& options);

/// The README of a public folder.
std::string publicReadme(Study& study, const ExportOptions& options, const Release& release);

/// The identifiability of participants in a few lines: the smallest class before and after, and its
/// causes.
std::string describe(const Release& release);

}  // namespace study
