# SPDX-License-Identifier: GPL-3.0-or-later
# Rscript heat_desolve.R CASE OUT: R's package deSolve, finite volumes by the method of lines, ode.1D and ode.2D (lsodes).
suppressPackageStartupMessages(library(deSolve))
args <- commandArgs(trailingOnly = TRUE)
pairs <- strsplit(readLines(args[1]), " = ", fixed = TRUE)
case <- setNames(lapply(pairs, function(p) p[2]), sapply(pairs, function(p) p[1]))
if (case$dim == "3" || any(c("shape", "k_law", "k_xy", "conductivity", "contact_resistance") %in% names(case)) ||
    any(c("periodic", "changing") %in% unlist(case)))
    quit(status = 77) # rods and rectangles with walls, and data that stay
numbers <- function(key) as.numeric(strsplit(case[[key]], ",")[[1]])
lo <- numbers("lo"); hi <- numbers("hi"); n <- numbers("cells"); t_end <- numbers("t_end"); dim <- length(n)
width <- (hi - lo) / n; axes <- c("x", "y")[1:dim]

ask <- function(points, what) { # a column for each quantity, at a matrix of points
    file <- paste0(args[2], ".points")
    table <- cbind(points, matrix(width, nrow(points), dim, byrow = TRUE))
    write.table(format(table, digits = 17, trim = TRUE), file, quote = FALSE, sep = ",", row.names = FALSE,
                col.names = c(axes, paste0("d", axes)))
    words <- c("reference", strsplit(case$oracle, " ")[[1]], "--points", file, "--what", what)
    answer <- system2(Sys.getenv("HEATLADDER", "heatladder"), words, stdout = TRUE)
    as.matrix(read.csv(text = answer))[, -(1:dim), drop = FALSE]
}

centres <- lapply(1:dim, function(d) lo[d] + (seq_len(n[d]) - 0.5) * width[d])
points <- as.matrix(expand.grid(centres)) # x fastest
at <- ask(points, paste(c("initial_mean,source,rho_c", paste0("k_", axes)), collapse = ","))
grid <- function(column) matrix(column, n[1])
rho_c <- grid(at[, "rho_c"]); source <- grid(at[, "source"])
# Conductances of the faces across an axis, W/(m^2 K), and of its walls.
axis <- lapply(1:dim, function(d) {
    half <- width[d] / 2 / grid(at[, paste0("k_", axes[d])])
    if (d == 2) half <- t(half)
    m <- nrow(half)
    walls <- lapply(c(lo[d], hi[d]), function(place) {
        feet <- as.matrix(expand.grid(replace(centres, d, place)))
        w <- ask(feet, paste0("wall_", axes[d]))
        own <- half[if (place == lo[d]) 1 else m, ]
        g <- ifelse(w[, 1] == 2, 0, 1 / (own + ifelse(w[, 1] == 3, 1 / w[, 3], 0)))
        list(g = g, T = w[, 2], flux = ifelse(w[, 1] == 2, w[, 2], 0))
    })
    list(g = 1 / (half[-m, , drop = FALSE] + half[-1, , drop = FALSE]), walls = walls)
})
gain <- function(T, a, dx) { # heat into the cells across one axis, W/m^3
    m <- nrow(T); low <- a$walls[[1]]; high <- a$walls[[2]]
    q <- rbind(low$flux + low$g * (low$T - T[1, ]), -a$g * diff(T), -high$flux - high$g * (high$T - T[m, ]))
    -diff(q) / dx
}
rate <- function(time, state, parameters) {
    T <- grid(state)
    heat <- source + gain(T, axis[[1]], width[1]) + if (dim == 2) t(gain(t(T), axis[[2]], width[2])) else 0
    list(as.vector(heat / rho_c))
}
begin <- proc.time()[["elapsed"]]
tight <- list(times = c(0, t_end), y = at[, "initial_mean"], func = rate, parms = NULL, rtol = 1e-8, atol = 1e-10)
march <- if (dim == 2) do.call(ode.2D, c(tight, list(dimens = n, lrw = 20000000))) else
    do.call(ode.1D, c(tight, list(nspec = 1)))
seconds <- proc.time()[["elapsed"]] - begin
writeLines(c(sprintf("# seconds = %g", seconds), paste(c(axes, "T"), collapse = ",")), args[2])
write.table(format(cbind(points, march[2, -1]), digits = 17, trim = TRUE), args[2], append = TRUE, quote = FALSE,
            sep = ",", row.names = FALSE, col.names = FALSE)
