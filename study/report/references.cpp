#include "study/report/references.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "base/joined.h"
#include "study/report/html_text.h"

namespace study::report {
namespace {

// clang-format off
constexpr std::array kPublications{
    Publication{"AERA et al. 2014", "AERA; APA; NCME", "Standards for educational and psychological testing", "American Educational Research Association", "", "", ""},
    Publication{"Bates et al. 2015", "Bates D; Mächler M; Bolker B; Walker S", "Fitting linear mixed-effects models using lme4", "Journal of Statistical Software", "67(1)", "1–48", "10.18637/jss.v067.i01"},
    Publication{"Benjamini & Hochberg 1995", "Benjamini Y; Hochberg Y", "Controlling the false discovery rate: A practical and powerful approach to multiple testing", "Journal of the Royal Statistical Society: Series B", "57(1)", "289–300", "10.1111/j.2517-6161.1995.tb02031.x"},
    Publication{"Benjamini & Yekutieli 2001", "Benjamini Y; Yekutieli D", "The control of the false discovery rate in multiple testing under dependency", "The Annals of Statistics", "29(4)", "1165–1188", "10.1214/aos/1013699998"},
    Publication{kPunchCode, "Bjelland Ø", "ARDUINO-PARTIAL-MENISCECTOMY-HAPTICS-, commit 420bed5 [Computer software]", "GitHub", "", "", ""},
    Publication{"Brown & Forsythe 1974", "Brown MB; Forsythe AB", "Robust tests for the equality of variances", "Journal of the American Statistical Association", "69(346)", "364–367", "10.1080/01621459.1974.10482955"},
    Publication{"Brunner & Munzel 2000", "Brunner E; Munzel U", "The nonparametric Behrens-Fisher problem: Asymptotic theory and a small-sample approximation", "Biometrical Journal", "42(1)", "17–25", ""},
    Publication{"Christensen 2022", "Christensen RHB", "ordinal: Regression models for ordinal data [R package]", "Comprehensive R Archive Network", "", "", ""},
    Publication{"Cook & Hatala 2016", "Cook DA; Hatala R", "Validation of educational assessments: A primer for simulation and beyond", "Advances in Simulation", "1", "31", "10.1186/s41077-016-0033-y"},
    Publication{"Cronbach 1951", "Cronbach LJ", "Coefficient alpha and the internal structure of tests", "Psychometrika", "16(3)", "297–334", "10.1007/BF02310555"},
    Publication{"Feldt 1965", "Feldt LS", "The approximate sampling distribution of Kuder-Richardson reliability coefficient twenty", "Psychometrika", "30(3)", "357–370", "10.1007/BF02289499"},
    Publication{"Feng & Cliff 2004", "Feng D; Cliff N", "Monte Carlo evaluation of ordinal d with improved confidence interval", "Journal of Modern Applied Statistical Methods", "3(2)", "322–332", "10.22237/jmasm/1099267560"},
    Publication{"Fisher 1935", "Fisher RA", "The design of experiments", "Oliver & Boyd", "", "", ""},
    Publication{"Friedman 1937", "Friedman M", "The use of ranks to avoid the assumption of normality implicit in the analysis of variance", "Journal of the American Statistical Association", "32(200)", "675–701", "10.1080/01621459.1937.10503522"},
    Publication{"Greenhouse & Geisser 1959", "Greenhouse SW; Geisser S", "On methods in the analysis of profile data", "Psychometrika", "24(2)", "95–112", "10.1007/BF02289823"},
    Publication{"Hedges 1981", "Hedges LV", "Distribution theory for Glass’s estimator of effect size and related estimators", "Journal of Educational Statistics", "6(2)", "107–128", "10.3102/10769986006002107"},
    Publication{"Hochberg 1988", "Hochberg Y", "A sharper Bonferroni procedure for multiple tests of significance", "Biometrika", "75(4)", "800–802", "10.1093/biomet/75.4.800"},
    Publication{"Holm 1979", "Holm S", "A simple sequentially rejective multiple test procedure", "Scandinavian Journal of Statistics", "6(2)", "65–70", ""},
    Publication{"Hommel 1988", "Hommel G", "A stagewise rejective multiple test procedure based on a modified Bonferroni test", "Biometrika", "75(2)", "383–386", "10.1093/biomet/75.2.383"},
    Publication{"Hurlbert 1984", "Hurlbert SH", "Pseudoreplication and the design of ecological field experiments", "Ecological Monographs", "54(2)", "187–211", "10.2307/1942661"},
    Publication{"Kuznetsova et al. 2017", "Kuznetsova A; Brockhoff PB; Christensen RHB", "lmerTest package: Tests in linear mixed effects models", "Journal of Statistical Software", "82(13)", "1–26", "10.18637/jss.v082.i13"},
    Publication{"Lazic et al. 2020", "Lazic SE; Mellor JR; Ashby MC; Munafo MR", "A Bayesian predictive approach for dealing with pseudoreplication", "Scientific Reports", "10", "2366", "10.1038/s41598-020-59384-7"},
    Publication{"Liddell & Kruschke 2018", "Liddell TM; Kruschke JK", "Analyzing ordinal data with metric models: What could possibly go wrong?", "Journal of Experimental Social Psychology", "79", "328–348", "10.1016/j.jesp.2018.08.009"},
    Publication{"Mann & Whitney 1947", "Mann HB; Whitney DR", "On a test of whether one of two random variables is stochastically larger than the other", "The Annals of Mathematical Statistics", "18(1)", "50–60", "10.1214/aoms/1177730491"},
    Publication{"McDonald 1999", "McDonald RP", "Test theory: A unified treatment", "Lawrence Erlbaum", "", "", ""},
    Publication{"Messick 1995", "Messick S", "Validity of psychological assessment: Validation of inferences from persons’ responses and performances as scientific inquiry into score meaning", "American Psychologist", "50(9)", "741–749", "10.1037/0003-066X.50.9.741"},
    Publication{kReamingPaper, "Pelliccia L; Lorenz M; Heyde C-E; Kaluschke M; Klimant P; Knopp S; Schleifenbaum S; Rotsch C; Weller R; Werner M; Zachmann G; Zajonz D; Hammer N", "A cadaver-based biomechanical model of acetabulum reaming for surgical virtual reality training simulators", "Scientific Reports", "10", "14545", "10.1038/s41598-020-71499-5"},
    Publication{"Rouder et al. 2009", "Rouder JN; Speckman PL; Sun D; Morey RD; Iverson G", "Bayesian t tests for accepting and rejecting the null hypothesis", "Psychonomic Bulletin & Review", "16(2)", "225–237", "10.3758/PBR.16.2.225"},
    Publication{"Royston 1995", "Royston P", "Remark AS R94: A remark on algorithm AS 181: The W-test for normality", "Applied Statistics", "44(4)", "547–551", "10.2307/2986146"},
    Publication{"Schuirmann 1987", "Schuirmann DJ", "A comparison of the two one-sided tests procedure and the power approach for assessing the equivalence of average bioavailability", "Journal of Pharmacokinetics and Biopharmaceutics", "15(6)", "657–680", "10.1007/BF01068419"},
    Publication{"Student 1908", "Student", "The probable error of a mean", "Biometrika", "6(1)", "1–25", "10.1093/biomet/6.1.1"},
    Publication{"Tate & Hyer 1973", "Tate MW; Hyer LA", "Inaccuracy of the X² test of goodness of fit when expected frequencies are small", "Journal of the American Statistical Association", "68(344)", "836–841", ""},
    Publication{"Wagenmakers et al. 2012", "Wagenmakers E-J; Wetzels R; Borsboom D; van der Maas HLJ; Kievit RA", "An agenda for purely confirmatory research", "Perspectives on Psychological Science", "7(6)", "632–638", "10.1177/1745691612463078"},
    Publication{"Welch 1947", "Welch BL", "The generalization of ‘Student’s’ problem when several different population variances are involved", "Biometrika", "34(1–2)", "28–35", "10.1093/biomet/34.1-2.28"},
    Publication{"Wilcoxon 1945", "Wilcoxon F", "Individual comparisons by ranking methods", "Biometrics Bulletin", "1(6)", "80–83", "10.2307/3001968"},
    Publication{"Williams 1949", "Williams EJ", "Experimental designs balanced for the estimation of residual effects of treatments", "Australian Journal of Scientific Research, Series A", "2", "149–168", "10.1071/CH9490149"},
    Publication{"Wilson 1927", "Wilson EB", "Probable inference, the law of succession, and statistical inference", "Journal of the American Statistical Association", "22(158)", "209–212", "10.1080/01621459.1927.10502953"},
    Publication{kPunchPaper, "", "Intraoperative data-based haptic feedback for arthroscopic partial meniscectomy punch simulation", "", "", "", ""},
};
// clang-format on

const Publication& workNamed(std::string_view key) {
  const auto found = std::ranges::find(kPublications, key, &Publication::key);
  if (found == kPublications.end()) throw std::logic_error("no such work: " + std::string(key));
  return *found;
}

std::vector<std::string_view> partsOf(std::string_view list, std::string_view separator) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at < list.size();) {
    const auto end = std::min(list.find(separator, at), list.size());
    parts.push_back(list.substr(at, end - at));
    at = end + separator.size();
  }
  return parts;
}

std::string_view yearOf(const Publication& work) {
  return work.key.substr(work.key.rfind(' ') + 1);
}

/// "Heyde C-E" as APA writes it: "Heyde, C.-E."; a name without initials as it is.
std::string asApa(std::string_view author) {
  const auto space = author.rfind(' ');
  if (space == std::string_view::npos) return std::string(author);
  auto text = std::string(author.substr(0, space)) + ",";
  for (auto at = space + 1; at < author.size();) {
    const auto initial = author.substr(at, static_cast<unsigned char>(author[at]) < 0x80 ? 1 : 2);
    at += initial.size();
    if (initial == "-") {
      text += '-';
    } else {
      text += (text.back() == '-' ? "" : " ") + std::string(initial) + ".";
    }
  }
  return text;
}

/// "Mann, H. B., & Whitney, D. R."
std::string authorsAsApa(const Publication& work) {
  const auto authors = partsOf(work.authors, "; ");
  std::string text;
  for (std::size_t i = 0; i < authors.size(); ++i) {
    const bool isLast = i + 1 == authors.size();
    text += (i == 0 ? "" : isLast ? ", & " : ", ") + asApa(authors[i]);
  }
  return text;
}

/// "Mann HB, Whitney DR"
std::string authorsAsVancouver(const Publication& work) {
  return base::joined(partsOf(work.authors, "; "), ", ");
}

std::string withFullStop(std::string text) {
  return text.empty() || text.back() == '.' || text.back() == '?' ? text : text + ".";
}

/// "Mann, H. B., & Whitney, D. R. (1947). Title. Journal, 18(1), 50–60."
std::string apaEntry(const Publication& work) {
  const auto title = escaped(withFullStop(std::string(work.title)));
  const auto year = fmt::format("({}).", yearOf(work));
  if (work.authors.empty()) return title + " " + year;
  auto text = escaped(withFullStop(authorsAsApa(work))) + " " + year + " ";
  // In books, which have no volume, the title is in italics; in articles, the journal.
  if (work.volume.empty()) {
    text += "<em>" + title + "</em>";
    return withFullStop(text + (work.journal.empty() ? "" : " " + escaped(work.journal)));
  }
  text += title + " <em>" + escaped(work.journal) + "</em>";
  for (const auto part : {work.volume, work.pages}) {
    if (!part.empty()) text += ", " + std::string(part);
  }
  return withFullStop(text);
}

/// "Mann HB, Whitney DR. Title. Journal. 1947;18(1):50–60."
std::string vancouverEntry(const Publication& work) {
  auto text = authorsAsVancouver(work);
  text = withFullStop(text) + (text.empty() ? "" : " ") + withFullStop(std::string(work.title));
  if (!work.journal.empty()) text += fmt::format(" {}. {}", work.journal, yearOf(work));
  if (!work.volume.empty()) text += fmt::format(";{}", work.volume);
  if (!work.pages.empty()) text += fmt::format(":{}", work.pages);
  return escaped(withFullStop(text));
}

}  // namespace

std::span<const Publication> publications() noexcept {
  return kPublications;
}

std::string sourcesWithDois(std::span<const base::Message> sources) {
  std::string text;
  for (const auto& source : sources) {
    const auto key = base::describe(source);
    const auto work = std::ranges::find(publications(), key, &Publication::key);
    const bool hasDoi = work != publications().end() && !work->doi.empty();
    text += (text.empty() ? "" : "; ") + key + (hasDoi ? ", " + std::string(work->doi) : "");
  }
  return text;
}

std::string authorsAndYear(std::string_view key) {
  const auto year = yearOf(workNamed(key));
  return fmt::format("{}, {}", key.substr(0, key.size() - year.size() - 1), year);
}

std::string Citations::cite(std::string_view keys) {
  std::string text;
  for (const auto key : partsOf(keys, ", ")) {
    const auto* work = &workNamed(key);
    auto place = std::ranges::find(cited_, work);
    if (place == cited_.end()) place = cited_.insert(place, work);
    if (wording_ == Wording::Vancouver) {
      text += (text.empty() ? "" : ", ") + std::to_string(place - cited_.begin() + 1);
    } else {
      text += (text.empty() ? "" : "; ") + authorsAndYear(key);
    }
  }
  return wording_ == Wording::Vancouver ? "[" + text + "]" : "(" + text + ")";
}

std::vector<std::string> Citations::list(const words::Words& words) const {
  auto sorted = cited_;
  const bool isApa = wording_ == Wording::Apa;
  if (isApa) {
    const auto sortedBy = [](const Publication* work) {
      return work->authors.empty() ? work->title : work->authors;
    };
    std::ranges::stable_sort(sorted, {}, sortedBy);
  }
  std::vector<std::string> entries;
  for (const auto* work : sorted) {
    auto text =
        isApa ? apaEntry(*work) : std::to_string(entries.size() + 1) + ". " + vancouverEntry(*work);
    if (work->authors.empty()) {
      text += " " + escaped(words("Authors, journal and year are not confirmed."));
    }
    if (!work->doi.empty()) text += " doi:" + std::string(work->doi);
    entries.push_back(text);
  }
  return entries;
}

}  // namespace study::report
