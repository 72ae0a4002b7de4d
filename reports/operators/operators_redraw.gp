# Error against spacing, SO-SSPH of order 2 and 4, the cloud placed again every N steps.
name = 'operators_redraw'
wide = 980; high = 600
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,2 margins screen 0.085, 0.985, 0.34, 0.88 spacing screen 0.075, 0.05
set logscale xy
set format y '10^{%T}'
set xtics ('1/160' 1.0/160, '1/80' 1.0/80, '1/40' 1.0/40, '1/20' 1.0/20)
set xrange [0.0055:0.057]
set yrange [1e-7:0.2]
set xlabel 'dx  [m]'
steps = 'no 64 16 4 1' # a block is found by the beginning of its name
do for [panel = 1:2] {
    order = 2 * panel
    set title sprintf('order %d', order) font size_of(11) offset 0,-0.6
    if (panel == 1) { set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5; unset key } else {
        unset ylabel; set key at screen 0.985, 0.09 bottom right maxrows 2 title 'drawn again every N steps' }
    plot for [k = 1:5] data index sprintf('order %d, every %s steps', order, word(steps, k)) using 1:2 with linespoints ls k \
        title word(steps, k) eq 'no' ? 'never' : word(steps, k)
    unset label 98; unset label 99
}
unset multiplot
