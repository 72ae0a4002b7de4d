# The lowest weight off the centre, and what runs undershoot.
name = 'stability_maximum'
wide = 900; high = 760
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.97 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 2,1 margins screen 0.10, 0.975, 0.215, 0.92 spacing screen 0.06, 0.05
set xrange [0.6:3]
kernels = 'cubic quartic wendland'
do for [row = 1:2] {
    set xlabel (row == 2 ? 'h/dx  [-]' : '')
    set ylabel (row == 1 ? 'lowest weight off the centre / |w_0|  [-]' : 'undershoot of an impulse of 1 K  [K]') enhanced offset 0.5
    set format y '%g'
    if (row == 1) { set yrange [-0.05:0.55] } else { set yrange [0:0.014] }
    if (row == 1) { set key at screen 0.5, screen 0.07 center bottom horizontal maxrows 2 noenhanced } else { unset key }
    plot for [d = 1:2] for [k = 1:3] data index sprintf('%s %dD', word(kernels, k), d) using 1:(row == 1 ? $2 : $3) \
        with linespoints lc rgb (k == 1 ? RED : k == 2 ? BLUE : GREEN) lw 1.4 dt d \
        pt (k == 1 ? 7 : k == 2 ? 5 : 9) ps (k == 2 ? 0.6 : 0.8) * P pi 3 \
        title sprintf('%s, %dD', word(kernels, k), d)
    unset label 98
    unset label 99
}
unset multiplot
