# What R's metafor 3.8-1 (Viechtbauer 2010, J. Stat. Softw. 36(3)) says of differences at several
# sites. `Rscript make_golden.R` writes golden.json beside it; needs r-cran-metafor, whose package
# metadat has the published data: Colditz et al. 1994 (BCG), Hackshaw et al. 1997 (passive smoking),
# Normand 1999 (stay in hospital). The others are made up: sites that agree, two, three, and
# six small ones.
suppressMessages(library(metafor))

bcg <- escalc(measure = "RR", ai = tpos, bi = tneg, ci = cpos, di = cneg, data = dat.bcg)
stay <- escalc(measure = "MD", m1i = m1i, sd1i = sd1i, n1i = n1i, m2i = m2i, sd2i = sd2i, n2i = n2i,
               data = dat.normand1999)
sets <- list(
  bcg = list(y = as.numeric(bcg$yi), se = sqrt(as.numeric(bcg$vi))),
  smoking = list(y = as.numeric(dat.hackshaw1998$yi), se = sqrt(as.numeric(dat.hackshaw1998$vi))),
  stay = list(y = as.numeric(stay$yi), se = sqrt(as.numeric(stay$vi))),
  agreeing = list(y = c(0.51, 0.49, 0.5, 0.52), se = c(0.2, 0.3, 0.25, 0.4)),
  two = list(y = c(0.2, 1.4), se = c(0.3, 0.4)),
  three = list(y = c(-0.4, 0.9, 0.3), se = c(0.25, 0.5, 0.1)),
  small = list(y = c(0.833, -0.25, 1.1, 0.4, 0.05, 0.6667), se = c(0.31, 0.42, 0.55, 0.2, 0.61, 0.33)))

# The smallest steps that still come to an end: the estimate is where the restricted likelihood is
# largest, as far as doubles tell.
fit <- function(set, method, test = "z", threshold = 1e-15) {
  tryCatch(
    rma(set$y, sei = set$se, method = method, test = test, control = list(threshold = threshold, maxiter = 10000)),
    error = function(e) fit(set, method, test, 10 * threshold))
}
number <- function(x) sprintf("%.17g", x)
list_of <- function(x) paste0("[", paste(number(x), collapse = ", "), "]")
of <- function(f) {
  paste0("{\"estimate\": \"", number(f$b[1]), "\", \"se\": \"", number(f$se), "\", \"low\": \"", number(f$ci.lb),
         "\", \"high\": \"", number(f$ci.ub), "\", \"statistic\": \"", number(f$zval), "\", \"p\": \"",
         number(f$pval), "\", \"tau2\": \"", number(f$tau2), "\", \"i2\": \"", number(f$I2), "\"}")
}
without <- function(set, i) fit(list(y = set$y[-i], se = set$se[-i]), "REML", "adhoc")

lines <- vapply(names(sets), function(name) {
  set <- sets[[name]]
  reml <- fit(set, "REML")
  left <- if (length(set$y) < 3) "" else
    paste(vapply(seq_along(set$y), function(i) of(without(set, i)), ""), collapse = ",\n    ")
  paste0("\"", name, "\": {\"y\": ", list_of(set$y), ",\n  \"se\": ", list_of(set$se),
         ",\n  \"q\": \"", number(reml$QE), "\", \"q_p\": \"", number(reml$QEp),
         "\",\n  \"common\": ", of(fit(set, "EE")), ",\n  \"dl\": ", of(fit(set, "DL")),
         ",\n  \"reml\": ", of(reml), ",\n  \"reml_knapp_hartung\": ", of(fit(set, "REML", "adhoc")),
         ",\n  \"without\": [", left, "]}")
}, "")
writeLines(paste0("{\n", paste(lines, collapse = ",\n"), "\n}"), "golden.json")
