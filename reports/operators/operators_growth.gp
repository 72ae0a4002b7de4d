# Share of clouds on which a mode grows, against jitter: one panel a conductivity ratio; 900 particles.
name = 'operators_growth'
wide = 1180; high = 520
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,3 margins screen 0.07, 0.985, 0.36, 0.88 spacing screen 0.03, 0.05
set yrange [-0.05:1.05]
set xrange [0.05:0.55]
set xtics 0.1, 0.1
set xlabel 'jitter  [dx]'
ratios = '1 0.25 0.1'
names = 'so_ssph fatehi_manzari cspm schwaiger kernel_second fo_ssph brookshaw conjugate positive voronoi_flux'
colours = sprintf('%s %s %s %s %s %s %s %s %s %s', BLACK, BLUE, PURPLE, SKY, GREY, GREEN, RED, '#882255', \
    '#44aa99', ORANGE)
shapes = '4 5 13 11 8 6 7 12 3 9'
isotropic = 'schwaiger kernel_second brookshaw'
do for [c = 1:3] {
    set title sprintf('κ_y/κ_x = %s', word(ratios, c)) font size_of(11) offset 0,-0.6
    if (c == 1) { set ylabel 'share of clouds' offset 0.5 } else { unset ylabel; set format y '' }
    if (c == 1) { set key at screen 0.985, 0.03 bottom right maxrows 3 width 2 } else { unset key }
    drawn = ''
    do for [k = 1:10] {
        if (c == 1 || strstrt(isotropic, word(names, k)) == 0) { drawn = drawn.sprintf(' %d', k) }
    }
    plot for [i = 1:words(drawn)] data index sprintf('%s ratio %s', word(names, int(word(drawn, i))), \
        word(ratios, c)) using 1:2 with linespoints lc rgb word(colours, int(word(drawn, i))) \
        pt int(word(shapes, int(word(drawn, i)))) ps 0.8 * P lw 1.2 title word(names, int(word(drawn, i)))
    unset label 98; unset label 99
}
unset multiplot
