# Error against spacing along a field: a smooth ring and a patch, with the derived slopes.
name = 'field_error'
wide = 980; high = 480
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,2 margins screen 0.085, 0.985, 0.22, 0.86 spacing screen 0.09, 0.05
set logscale xy
set format y '10^{%T}'
set xlabel 'dx  [m]'
titles = '"smooth ring" "patch, t = 5 s"'
methods = 'faces corners so_ssph'
colour(m) = m == 1 ? RED : m == 2 ? BLUE : GREEN
mark(m) = m == 1 ? 7 : m == 2 ? 5 : 9
do for [k = 1:2] {
    set title word(titles, k) font size_of(11) offset 0,-0.6
    if (k == 1) { set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 1 } else { unset ylabel }
    set xrange [0.0065:0.06]
    set xtics (0.01, 0.02, 0.04)
    if (k == 1) { set yrange [1e-5:1e-2] }
    if (k == 2) { set yrange [1e-3:1e-2]; set format y '%g'; set ytics (0.001, 0.002, 0.005, 0.01) }
    set key bottom right Right noreverse noenhanced
    if (k == 1) {
        plot for [m = 1:3] data index 'ring, '.word(methods, m) using 1:2 with linespoints lc rgb colour(m) \
                pt mark(m) ps 0.9 * P lw 1.3 title word(methods, m), \
            0.35 * x**2 with lines lc rgb GREY dt 2 title 'slope 2'
    }
    if (k == 2) {
        plot for [m = 1:3] data index 'patch, '.word(methods, m) using 1:2 with linespoints lc rgb colour(m) \
                pt mark(m) ps 0.9 * P lw 1.3 title word(methods, m), \
            0.0235 * x**0.5 with lines lc rgb GREY dt 2 title 'slope 1/2', \
            0.026 * x**0.6667 with lines lc rgb GREY dt 4 title 'slope 2/3'
    }
    unset label 98; unset label 99
}
unset multiplot
