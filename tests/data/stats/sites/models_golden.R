# What R's lme4 1.1-31 (Bates et al. 2015, J. Stat. Softw. 67(1)) says of the mixed models with sites.
# `Rscript models_golden.R` writes models.json beside it, with the answers: four sites of 3 to 7 people, two methods,
# two statements, three answers left out, made up by R's random generator.
suppressMessages(library(lme4))
set.seed(20261125)

people <- data.frame(participant = sprintf("P%02d", 1:20), site = rep(c("bergen", "bodo", "oslo", "tromso"), c(3, 7, 6, 4)))
answers <- merge(people, expand.grid(method = c("a", "b"), statement = c("1", "2"), stringsAsFactors = FALSE))
level <- c(bergen = -0.6, bodo = 0.1, oslo = 0.5, tromso = 0)
effect <- c(bergen = 0.2, bodo = 1.6, oslo = 0.9, tromso = 0)
own <- rnorm(20, sd = 0.9)
taste <- rnorm(40, sd = 0.5)
who <- match(answers$participant, people$participant)
is_a <- answers$method == "a"
answers$score <- pmin(5, pmax(1, round(2.6 + level[answers$site] + effect[answers$site] * is_a + own[who] +
                                       taste[2 * who - is_a] + rnorm(nrow(answers), sd = 0.6))))
answers <- answers[-c(5, 22, 61), ]
answers <- answers[order(answers$participant, answers$method, answers$statement), ]

careful <- lmerControl(optimizer = "bobyqa", optCtrl = list(rhoend = 1e-12, maxfun = 1e6))
fit <- function(formula) lmer(formula, answers, REML = TRUE, control = careful)
fixed <- fit(score ~ method + site + (1 | participant) + (1 | participant:method))
random <- fit(score ~ method + (1 | participant) + (1 | participant:method) + (1 | site) + (1 | site:method))

number <- function(x) sprintf("\"%.17g\"", x)
said <- function(model) {
  variances <- as.data.frame(VarCorr(model))
  paste0("{\"a_minus_b\": ", number(-fixef(model)[["methodb"]]),
         ", \"se\": ", number(sqrt(vcov(model)["methodb", "methodb"])),
         ", \"reml_deviance\": ", number(REMLcrit(model)),
         ",\n  \"variances\": {", paste0("\"", variances$grp, "\": ", number(variances$vcov), collapse = ", "), "}}")
}
rows <- sprintf("[\"%s\", \"%s\", \"%s\", \"%s\", %d]", answers$participant, answers$site, answers$method,
                answers$statement, as.integer(answers$score))
writeLines(paste0("{\"answers\": [\n", paste(rows, collapse = ",\n"), "],\n\"fixed\": ", said(fixed),
                  ",\n\"random\": ", said(random), "}"), "models.json")
