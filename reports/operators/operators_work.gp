# Error against work, one panel per cloud.
name = 'operators_work'
wide = 1180; high = 620
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,3 margins screen 0.07, 0.985, 0.33, 0.88 spacing screen 0.03, 0.05
set logscale xy
set format y '10^{%T}'
set format x '10^{%T}'
set yrange [5e-5:0.1]
set xlabel 'pairs of neighbours, in all steps  [-]'
clouds = '"lattice" "jitter 0.3" "relaxed"'
names = 'brookshaw brookshaw_corrected schwaiger fatehi_manzari cspm kernel_second flux_divergence fo_ssph so_ssph conjugate positive voronoi_flux'
colours = sprintf('%s %s %s %s %s %s %s %s %s %s %s %s', RED, ORANGE, SKY, BLUE, PURPLE, GREY, '#999933', GREEN, BLACK, \
    '#882255', '#44aa99', '#332288')
shapes = '7 9 11 5 13 8 10 6 4 12 3 14'
# Blocks with data; an operator with a growing mode has none.
full = system("awk '/^# /{name=$2\"_\"$3\"_\"$4} /^[0-9]/{print name}' ".data." | sort -u | tr '\\n' ' '")
K(i) = int(word(drawn, i))
do for [c = 1:3] {
    drawn = ''
    do for [k = 1:12] {
        block = word(names, k).(c == 1 ? '_lattice_' : c == 2 ? '_jitter_0.3' : '_relaxed_')
        if (strstrt(' '.full, ' '.block.' ') > 0 || c == 3) { drawn = drawn.sprintf(' %d', k) }
    }
    set title word(clouds, c).(c == 1 ? ', one exact step' : '') font size_of(11) offset 0,-0.6
    if (c == 1) { set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5 } else { unset ylabel; set format y '' }
    if (c == 3) { set key at screen 0.985, 0.075 bottom right maxrows 3 width 2 } else { unset key }
    plot for [i = 1:words(drawn)] data index sprintf('%s %s', word(names, K(i)), word(clouds, c)) \
        using 1:2 with linespoints lc rgb word(colours, K(i)) pt int(word(shapes, K(i))) ps 0.8 * P \
        lw (word(names, K(i)) eq 'voronoi_flux' ? 2.4 : 1.2) title word(names, K(i))
    unset label 98; unset label 99
}
unset multiplot
