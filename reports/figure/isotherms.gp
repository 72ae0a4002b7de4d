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
set multiplot layout rows, columns title heading noenhanced font size_of(13) margins 0.09, 0.98, 0.165, 0.91 spacing 0.05, 0.10
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
    error = system(sprintf("grep -A 2 '^# %s error$' '%s' | tail -n 1", time, data))
    set title sprintf('%s,  E = %.1f %%', time, error + 0) font size_of(12) offset 0, -0.6
    set xlabel (i > words(times) - columns ? 'x  [m]' : '')
    set ylabel (i % columns == 1 ? 'y  [m]' : '')
    plot $exact using 1:2 with lines lw 1.1 lc rgb BLACK, \
         $exact using 1:(abs($3 - bold) < 1e-6 ? $2 : NaN) with lines lw 2.4 lc rgb BLACK, \
         $computed using 1:2 with lines lw 1.5 dt (8, 4) lc rgb RED, \
         $computed using 1:(abs($3 - bold) < 1e-6 ? $2 : NaN) with lines lw 2.6 dt (8, 4) lc rgb RED, \
         $exact using 1:2:(sprintf('%g', $3)) every ::25::25 with labels font size_of(9.5) tc rgb '#222222' \
             boxed
    if (i == 1) {
        set label 99 caption at screen 0.012, screen 0.035 left noenhanced font size_of(8.5) textcolor rgb '#555555'
        set label 97 'exact' at screen 0.09, screen 0.085 font size_of(12)
        set label 96 method at screen 0.23, screen 0.085 font size_of(12) noenhanced
        set label 95 'numbers: temperature, K;  E = Σ|T_e − T_n| / ΣT_e' at screen 0.54, screen 0.085 font size_of(10.5)
        set arrow 97 from screen 0.03, screen 0.085 to screen 0.08, screen 0.085 nohead lw 1.1 lc rgb BLACK
        set arrow 96 from screen 0.17, screen 0.085 to screen 0.22, screen 0.085 nohead lw 1.5 dt (8, 4) lc rgb RED
    } else {
        if (i == 2) { unset label; unset arrow }
    }
}
unset multiplot
