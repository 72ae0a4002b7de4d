# A, B, the matching step and the stability limit of SO-SSPH in the plane over h/dx, one panel a kernel.
name = 'matched_fig2'
wide = 1180; high = 580
load 'reports/page/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,3 margins screen 0.06, 0.985, 0.34, 0.88 spacing screen 0.05, 0.05
set xrange [0.8:2]
set yrange [0:1.2]
set xtics 0.2
set xlabel 'h/dx  [-]'
kernels = 'cubic quartic wendland'
do for [k = 1:3] {
    set title word(kernels, k).' kernel' font size_of(11) offset 0,-0.6
    if (k == 1) { set key at screen 0.985, 0.03 bottom right } else { unset key }
    plot data index word(kernels, k) using 1:5 with lines lc rgb BLACK lw 1.4 title 'largest stable F', \
         data index word(kernels, k) using 1:4 with lines lc rgb RED lw 1.4 dt 2 title 'matching F = 2 A', \
         data index word(kernels, k) using 1:2 with lines lc rgb BLUE lw 1.4 dt 4 title 'A', \
         data index word(kernels, k) using 1:3 with lines lc rgb GREEN lw 1.4 dt 3 title 'B/2', \
         data index word(kernels, k).' isotropic' using 1:2 with points lc rgb BLACK pt 6 ps 1.2 * P title 'isotropic: A = B/2'
    unset label 98
}
unset multiplot
