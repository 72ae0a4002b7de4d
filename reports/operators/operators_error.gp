# Error against the number of neighbours at one spacing, one panel per cloud: the effect of a wider kernel.
name = 'operators_error'
wide = 1180; high = 620
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,3 margins screen 0.07, 0.985, 0.33, 0.88 spacing screen 0.03, 0.05
set logscale y
set format y '10^{%T}'
set yrange [5e-5:0.3]
set xrange [0:*]
set xlabel 'neighbours of a particle  [-]'
clouds = '"lattice" "jitter 0.1" "relaxed"'
names = 'brookshaw brookshaw_corrected schwaiger fatehi_manzari cspm kernel_second flux_divergence fo_ssph so_ssph conjugate positive'
colours = sprintf('%s %s %s %s %s %s %s %s %s %s %s', RED, ORANGE, SKY, BLUE, PURPLE, GREY, '#999933', GREEN, BLACK, \
    '#882255', '#44aa99')
shapes = '7 9 11 5 13 8 10 6 4 12 3'
do for [c = 1:3] {
    set title word(clouds, c) font size_of(11) offset 0,-0.6
    if (c == 1) { set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5 } else { unset ylabel; set format y '' }
    if (c == 3) { set key at screen 0.985, 0.075 bottom right maxrows 3 width 2 } else { unset key }
    plot for [k = 1:11] data index sprintf('%s %s', word(names, k), word(clouds, c)) using 1:2 with linespoints \
        lc rgb word(colours, k) pt int(word(shapes, k)) ps 0.8 * P lw 1.2 title word(names, k)
    unset label 98; unset label 99
}
unset multiplot
