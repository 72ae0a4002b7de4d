# The checkerboard over time, and the total variation, both over the peak: the heat itself falls.
name = 'stability_checkerboard'
wide = 1180; high = 820
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.975 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 2,3 margins screen 0.07, 0.985, 0.165, 0.915 spacing screen 0.045, 0.075
set logscale x
set xrange [0.01:*]
set format x '10^{%T}'
methods = 'fo_ssph ftcs_flux so_ssph ftcs'
titles = "'FO-SSPH' 'FTCS with fluxes' 'SO-SSPH' 'FTCS'"
colours = sprintf('%s %s %s %s', RED, BLUE, GREEN, BLACK)
places = "'midway' 'quarter' 'on'"
headings = "'jump midway between particles' 'jump a quarter off' 'jump on a particle'"
do for [row = 1:2] {
    do for [p = 1:3] {
        set title (row == 1 ? word(headings, p) : '') noenhanced font size_of(11) offset 0,-0.6
        set xlabel (row == 2 ? 't  [s]' : '') offset 0,0.3
        if (row == 1) {
            set logscale y
            set yrange [1e-17:1]
            set ytics 1e3
            set format y '10^{%T}'
            set ylabel (p == 1 ? 'checkerboard amplitude / peak  [-]' : '') offset 1
            if (p == 1) { set key at graph 0.99, graph 0.78 top right noenhanced } else { unset key }
        } else {
            unset logscale y
            set yrange [1.88:2.62]
            set ytics 0.1
            set format y '%g'
            set ylabel (p == 1 ? 'total variation / peak  [-]' : '') offset 0
            unset key
            if (p == 1) { set label 1 '2: one hill, no oscillation' at graph 0.03, graph 0.93 font size_of(10) tc rgb GREY }
        }
        if (p > 1) { set format y '' }
        plot for [m = 1:4] data index sprintf('%s %s', word(methods, m), word(places, p)) using 1:(row == 1 ? $2 : $3) \
            with linespoints lc rgb word(colours, m) dt m pt (m == 1 ? 7 : m == 2 ? 4 : m == 3 ? 8 : 2) \
            ps (m == 2 ? 1.4 : m == 3 ? 1.2 : 0.6) * P title word(titles, m)
        unset label 98
        unset label 99
        unset label 1
    }
}
unset multiplot
