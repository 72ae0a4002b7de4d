# Isotherms at four times, of the solution (red) over those of the exact one, as in Pamplona's Figures 5 and 6.
wide = 900
high = 960
load 'reports/figure/style.gp'
unset label 99
unset bmargin
unset title
set xrange [0:0.1]
set yrange [0:0.1]
set xtics 0.02 format '%.2f'
set ytics 0.02 format '%.2f'
set size ratio -1
set key off
times = system(sprintf("sed -n 's/^# \\([0-9.]*\\) computed$/\\1/p' '%s'", data))
set multiplot layout 2, 2 title heading noenhanced font size_of(13) margins 0.09, 0.98, 0.165, 0.91 spacing 0.06, 0.10
do for [i = 1:4] {
    time = word(times, i)
    error = system(sprintf("grep -A 3 '^# %s error$' '%s' | tail -n 1", time, data))
    set title sprintf('t = %s s,  E = %.2f %%', time, error + 0) font size_of(12) offset 0, -0.6
    set xlabel i > 2 ? 'x  [m]' : ''
    set ylabel i % 2 ? 'y  [m]' : ''
    # 0.625 K, the mean of the walls, twice as broad
    plot data index time . ' exact' using 1:2 with lines lw 1.1 lc rgb BLACK, \
         data index time . ' exact' using 1:(abs($3 - 0.625) < 1e-6 ? $2 : NaN) with lines lw 2.4 lc rgb BLACK, \
         data index time . ' computed' using 1:2 with lines lw 1.3 dt (8, 4) lc rgb RED, \
         data index time . ' computed' using 1:(abs($3 - 0.625) < 1e-6 ? $2 : NaN) with lines lw 2.6 dt (8, 4) lc rgb RED, \
         data index time . ' levels' using 1:2 with points pt 7 ps 3.0 * P lc rgb 'white', \
         data index time . ' levels' using 1:2:(sprintf('%g', $3)) with labels font size_of(9.5) tc rgb '#222222'
    if (i == 1) {
        set label 99 caption at screen 0.012, screen 0.035 left noenhanced font size_of(8.5) textcolor rgb '#555555'
        set label 97 'exact' at screen 0.09, screen 0.072 font size_of(12)
        set label 96 method at screen 0.23, screen 0.072 font size_of(12) noenhanced
        set label 95 'numbers: temperature, K;  E = Σ|T_e − T_n| / ΣT_e' at screen 0.60, screen 0.072 font size_of(9.5)
        set arrow 97 from screen 0.03, screen 0.072 to screen 0.08, screen 0.072 nohead lw 1.1 lc rgb BLACK
        set arrow 96 from screen 0.17, screen 0.072 to screen 0.22, screen 0.072 nohead lw 1.3 dt (8, 4) lc rgb RED
    } else {
        if (i == 2) { unset label; unset arrow }
    }
}
unset multiplot
