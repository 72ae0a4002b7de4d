# The leak of a field along the isotherms against spacing, with its derived values; of corners its size, as it is below 0.
name = 'field_leak'
high = 520
keys = 2
load 'reports/figure/style.gp'
set logscale xy
set format y '10^{%T}'
set xlabel 'dx  [m]'
set ylabel 'leak  [-]' offset 0.5
set xrange [0.013:0.1]
set xtics (0.02, 0.04, 0.08)
set yrange [1e-7:1e-2]
methods = 'faces corners so_ssph'
colour(m) = m == 1 ? RED : m == 2 ? BLUE : GREEN
mark(m) = m == 1 ? 7 : m == 2 ? 5 : 9
plot for [m = 1:3] data index word(methods, m) using 1:(abs($2)) with points lc rgb colour(m) pt mark(m) \
        ps 0.9 * P title word(methods, m), \
    0.3371 * x**2 with lines lc rgb RED dt 2 title '0.337 dx²', \
    (pi * x)**2 / 3000 with lines lc rgb BLUE dt 2 title '−(π dx)²/3 κ⊥/κ∥', \
    0.6664 * x**2 with lines lc rgb GREEN dt 2 title '0.666 dx²'
