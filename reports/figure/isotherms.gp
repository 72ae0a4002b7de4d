# Isotherms at several times, computed (red, dashed) over exact (black).  `rows` and `columns`: panels; `levels`:
# isotherms; `bold`: the level with a thick line.
load 'reports/figure/style.gp'
unset label 99
unset bmargin
unset title
set size ratio -1
set key off
set style textbox opaque noborder margins 0.3, 0.3
times = system(sprintf("sed -n 's/^# \\(.*\\) computed$/\"\\1\"/p' '%s'", data))
set cntrparam levels @levels
n = 0
set multiplot layout rows, columns title heading noenhanced font size_of(11) \
    margins screen 0.1, 0.98, (foot + 96) / high, 1 - 74.0 / high spacing screen 0.05, 74.0 / high
do for [i = 1:words(times)] {
    time = word(times, i)
    set datafile separator comma
    set contour base
    unset surface
    set table $exact
    splot data index time . ' exact' using 1:2:3
    set table $computed
    splot data index time . ' computed' using 1:2:3
    unset table
    set datafile separator whitespace
    # The number of an isotherm is on its longest part, at another share of it than the neighbours'.
    do for [k = 1:n] { unset label k }
    n = 0; first = 1; level = ''; longest = 0
    do for [l = 1:|$exact| + 1] {
        line = l > |$exact| ? '' : $exact[l]
        if (words(line) != 3 || line[1:1] eq '#') {
            part = l - first
            if (part > 15 && (word($exact[first], 3) ne level || part > longest)) {
                if (word($exact[first], 3) ne level) { n = n + 1 }
                level = word($exact[first], 3); longest = part
                at = $exact[first + int(part * (0.3 + 0.13 * (n % 4)))]
                set label n level at real(word(at, 1)), real(word(at, 2)) center front boxed font size_of(9.5) \
                    tc rgb '#222222'
            }
            first = l + 1
        }
    }
    error = system(sprintf("grep -A 2 '^# %s error$' '%s' | tail -n 1", time, data))
    set title sprintf('%s,  E = %.1f %%', time, error + 0) font size_of(12) offset 0, -0.6
    set xlabel (i > words(times) - columns ? 'x  [m]' : '')
    set ylabel (i % columns == 1 ? 'y  [m]' : '') offset 2
    plot $exact using 1:2 with lines lw 1.1 lc rgb BLACK, \
         $exact using 1:(abs($3 - bold) < 1e-6 ? $2 : NaN) with lines lw 2.4 lc rgb BLACK, \
         $computed using 1:2 with lines lw 1.5 dt (8, 4) lc rgb RED, \
         $computed using 1:(abs($3 - bold) < 1e-6 ? $2 : NaN) with lines lw 2.6 dt (8, 4) lc rgb RED
    if (i == 1) {
        set label 99 caption at screen 0.012, screen (foot - 10.0) / high left noenhanced font size_of(8.5) textcolor rgb '#555555'
        row = (foot + 20.0) / high
        set label 97 'exact' at screen 0.09, screen row font size_of(10)
        set label 96 method at screen 0.23, screen row font size_of(10) noenhanced
        set label 95 'numbers: T, K;  E = Σ|T_e − T_n| / ΣT_e' at screen 0.97, screen row right font size_of(10)
        set arrow 97 from screen 0.03, screen row to screen 0.08, screen row nohead lw 1.1 lc rgb BLACK
        set arrow 96 from screen 0.17, screen row to screen 0.22, screen row nohead lw 1.5 dt (8, 4) lc rgb RED
    } else {
        if (i == 2) { unset label 99; unset label 97; unset label 96; unset label 95; unset arrow }
    }
}
unset multiplot
