# A, B, the matching step and the stability limit of SO-SSPH in the plane over h/dx, one panel a kernel.
name = 'matched_fig2'
wide = 1180; high = 660
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.97 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,3 margins screen 0.06, 0.985, 0.36, 0.88 spacing screen 0.05, 0.05
set xrange [0.8:2]
set yrange [0:2]
set xtics 0.2
set xlabel 'h/dx  [-]'
kernels = 'cubic quartic wendland'
set label 1 "The operator answers a wave exp(i ξ·x) by  −κ|ξ|^2 + κ dx^2 [A (ξ_x^4 + ξ_y^4) + B ξ_x^2 ξ_y^2] + O(dx^4)." \
    at screen 0.06, screen 0.245 enhanced font size_of(11)
set label 2 "B = 2 A: that error is A |ξ|^4, the same in all directions.  F = κ dt/dx^2: an Euler step adds −F κ dx^2 |ξ|^4/2," \
    at screen 0.06, screen 0.20 enhanced font size_of(11)
set label 3 "so that F = 2 A at an isotropic h/dx leaves O(dx^4).  It must be below the largest stable F." \
    at screen 0.06, screen 0.155 enhanced font size_of(11)
do for [k = 1:3] {
    set title word(kernels, k).' kernel' font size_of(11) offset 0,-0.6
    set ylabel (k == 1 ? 'A, B/2, F  [-]' : '') offset 1
    if (k == 1) { set key at screen 0.985, 0.265 top right } else { unset key }
    plot data index word(kernels, k) using 1:5 with lines lc rgb BLACK lw 1.4 title 'largest stable F', \
         data index word(kernels, k) using 1:4 with lines lc rgb RED lw 1.8 dt 2 title 'matching F = 2 A', \
         data index word(kernels, k) using 1:2 with lines lc rgb BLUE lw 1.4 dt 1 title 'A', \
         data index word(kernels, k) using 1:3 with lines lc rgb ORANGE lw 1.8 dt 4 title 'B/2', \
         data index word(kernels, k).' isotropic' using 1:2 with points lc rgb BLACK pt 6 ps 1.2 * P title 'isotropic: A = B/2'
    unset label
}
unset multiplot
