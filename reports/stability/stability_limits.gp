# The largest stable step against h/dx: one panel a method and dimension.
name = 'stability_limits'
wide = 1180; high = 860
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.975 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 2,3 margins screen 0.065, 0.985, 0.195, 0.915 spacing screen 0.055, 0.085
set xrange [0.5:3]
set yrange [0.15:25]
set logscale y
set xtics 0.5
kernels = 'cubic quartic wendland'
methods = 'so_ssph fo_ssph brookshaw'
titles = 'SO-SSPH FO-SSPH Brookshaw'
colour(k) = k == 1 ? RED : k == 2 ? BLUE : GREEN
mark(k) = k == 1 ? 7 : k == 2 ? 5 : 9
open(k) = k == 1 ? 6 : k == 2 ? 4 : 8 # of what is published
do for [dim = 1:2] {
    do for [m = 1:3] {
        set title sprintf('%s, %dD', word(titles, m), dim) font size_of(11) offset 0,-0.6
        set xlabel (dim == 2 ? 'h/dx  [-]' : '') offset 0,0.4
        set ylabel (m == 1 ? 'dt κ/dx²  [-]' : '') offset 1
        if (m == 1 && dim == 1) { set key at screen 0.985, 0.07 bottom right maxrows 2 width 2 noenhanced } else { unset key }
        if (m < 3) {
            plot for [k = 1:3] data index sprintf('%s %s %dD', word(methods, m), word(kernels, k), dim) using 1:2 \
                     with linespoints lc rgb colour(k) lw 1.2 dt 2 pt open(k) ps 0.7 * P pi 9 notitle, \
                 for [k = 1:3] data index sprintf('%s %s %dD', word(methods, m), word(kernels, k), dim) using 1:3 \
                     with lines lc rgb colour(k) lw 1.2 dt 1 notitle, \
                 for [k = 1:3] data index sprintf('%s %s %dD', word(methods, m), word(kernels, k), dim) using 1:4 \
                     with points lc rgb colour(k) pt mark(k) ps 0.7 * P notitle, \
                 for [k = 1:3] NaN with linespoints lc rgb colour(k) lw 1.2 dt 1 pt mark(k) ps 0.7 * P title word(kernels, k), \
                 NaN with linespoints lc rgb BLACK lw 1.2 dt 2 pt 6 ps 0.7 * P title 'published', \
                 NaN with lines lc rgb BLACK lw 1.2 dt 1 title 'von Neumann', \
                 NaN with points lc rgb BLACK pt 7 ps 0.7 * P title 'measured', \
                 NaN with lines lc rgb BLACK lw 1.2 dt 2 title 'FTCS published', \
                 NaN with lines lc rgb BLACK lw 1.2 dt 1 title 'FTCS von Neumann'
        } else {
            plot for [k = 1:3] data index sprintf('%s %s %dD', word(methods, m), word(kernels, k), dim) using 1:3 \
                     with lines lc rgb colour(k) lw 1.2 dt 1 notitle, \
                 for [k = 1:3] data index sprintf('%s %s %dD', word(methods, m), word(kernels, k), dim) using 1:4 \
                     with points lc rgb colour(k) pt mark(k) ps 0.7 * P notitle, \
                 data index sprintf('ftcs %dD', dim) using (0.5):1:(2.5):(0) with vectors nohead lc rgb BLACK lw 1.2 dt 2 \
                     title 'FTCS published', \
                 data index sprintf('ftcs %dD', dim) using (0.5):2:(2.5):(0) with vectors nohead lc rgb BLACK lw 1.2 dt 1 \
                     title 'FTCS von Neumann'
        }
        unset label 98
        unset label 99
    }
}
unset multiplot
