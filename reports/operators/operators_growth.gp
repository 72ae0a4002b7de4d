# One box per kind of cloud: height is the share of eight draws with a growing mode, colour the growth rate.
name = 'operators_growth'
wide = 1180; high = 640
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set margins at screen 0.15, at screen 0.88, at screen 0.2, at screen 0.83
names = 'voronoi_flux positive conjugate brookshaw brookshaw_corrected schwaiger so_ssph fatehi_manzari fo_ssph flux_divergence kernel_second cspm'
set ytics () nomirror scale 0 noenhanced
do for [k = 1:12] { set ytics add (word(names, k) 13 - k) }
set xtics () nomirror scale 0
do for [group = 0:11] {
    set xtics add ('.1' 6 * group + 1, '.3' 6 * group + 3, '.5' 6 * group + 5)
    set label sprintf('h/dx %s', group % 2 ? '1.5' : '1.1') at first 6 * group + 3, graph 1.02 center font size_of(9)
    if (group) { set arrow from first 6 * group, graph 0 to first 6 * group, graph 1 nohead lc rgb GREY lw 0.5 * (group % 6 ? 1 : 4) }
}
ratios = '1 1/4 1/10'
do for [pair = 0:5] {
    set label sprintf('κ_y/κ_x = %s', word(ratios, pair % 3 + 1)) at first 12 * pair + 6, graph 1.065 center font size_of(9)
}
set label '196 particles' at first 18, graph 1.115 center font size_of(10)
set label '900 particles' at first 54, graph 1.115 center font size_of(10)
set xrange [0:72]
set yrange [0.4:12.6]
unset grid
set xlabel 'jitter  [dx]; height: share of draws; white: refused, since k_y differs from k_x' noenhanced
set cbrange [0.1:1e4]
set logscale cb
set format cb '10^{%T}'
set cblabel 'rate times 100 dx^2/κ_x  [-]' offset 1
set palette defined (0 '#f6d6a8', 1 '#e69f00', 2 '#d55e00', 3 '#7a1f00')
unset key
set style fill solid 1 noborder
plot for [k = 1:12] data index word(names, k).' on clouds' using 1:(13 - k):($1 - 0.45):($1 + 0.45):(13 - k - 0.4):(13 - k + 0.4) \
    with boxxyerror lc rgb '#eef0f2', \
    for [k = 1:12] data index word(names, k).' on clouds' using 1:(13 - k):($1 - 0.45):($1 + 0.45):(13 - k - 0.4):(13 - k - 0.4 + 0.8 * $2):3 \
    with boxxyerror lc palette
