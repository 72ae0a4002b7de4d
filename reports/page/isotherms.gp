# Isotherms at four times, of the solution (red) over those of the exact one (black), as in Pamplona's Figures 5 and 6.
wide = 900
high = 960
load 'reports/page/style.gp'
unset label 99
unset bmargin
unset title
set xrange [0:0.1]
set yrange [0:0.1]
set xtics 0.02 format '%.2f'
set ytics 0.02 format '%.2f'
set size ratio -1
set key off
set multiplot layout 2, 2 title heading noenhanced font size_of(13) margins 0.09, 0.98, 0.165, 0.91 spacing 0.06, 0.10
do for [i = 1:4] {
    time = word('28.9 57.9 87.0 115.9', i)
    set title sprintf('t = %s s', time) font size_of(12) offset 0, -0.6
    set xlabel i > 2 ? 'x  [m]' : ''
    set ylabel i % 2 ? 'y  [m]' : ''
    plot data index time . ' s exact' using 1:2 with lines lw 1.1 lc rgb BLACK, \
         data index time . ' s computed' using 1:2 with lines lw 1.3 dt (8, 4) lc rgb RED, \
         data index time . ' s levels' using 1:2 with points pt 7 ps 2.4 * P lc rgb 'white', \
         data index time . ' s levels' using 1:2:3 with labels font size_of(10) tc rgb '#222222'
    if (i == 1) {
        set label 99 caption at screen 0.012, screen 0.035 left noenhanced font size_of(8.5) textcolor rgb '#555555'
        set label 97 'exact' at screen 0.40, screen 0.072 font size_of(12)
        set label 96 method at screen 0.57, screen 0.072 font size_of(12) noenhanced
        set arrow 97 from screen 0.34, screen 0.072 to screen 0.39, screen 0.072 nohead lw 1.1 lc rgb BLACK
        set arrow 96 from screen 0.51, screen 0.072 to screen 0.56, screen 0.072 nohead lw 1.3 dt (8, 4) lc rgb RED
    } else {
        if (i == 2) { unset label; unset arrow }
    }
}
unset multiplot
