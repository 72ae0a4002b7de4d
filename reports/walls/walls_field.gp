# The error on the disc, one panel a treatment.
name = 'walls_field'
wide = 1180; high = 520
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
unset key
set multiplot layout 1,3 margins screen 0.07, 0.9, 0.2, 0.86 spacing screen 0.03, 0.05
set size ratio -1
set xrange [-1.05:1.05]
set yrange [-1.05:1.05]
set logscale cb
set cbrange [1e-5:1e-1]
set format cb '10^{%T}'
set palette defined (0 '#f7fbff', 1 '#9ecae1', 2 '#2171b5', 3 '#fdae61', 4 '#a50026')
set xlabel 'x  [m]'
names = 'fixed average fit'
do for [k = 1:3] {
    set title word(names, k) font size_of(11) offset 0,-0.6
    if (k == 1) { set ylabel 'y  [m]' offset 1 } else { unset ylabel; set format y '' }
    if (k == 3) { set colorbox user origin screen 0.92, 0.25 size screen 0.015, 0.55 } else { unset colorbox }
    plot data index word(names, k) using 1:2:3 with points pt 7 ps 0.75 * P lc palette
    unset label 98; unset label 99
}
unset multiplot
