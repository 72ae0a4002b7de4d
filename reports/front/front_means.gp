# The front of k = k_0 T^2: profiles with three means of a pair, and their errors.
name = 'front_means'
wide = 980; high = 520
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,2 margins screen 0.09, 0.98, 0.29, 0.86 spacing screen 0.1, 0.05
means = 'harmonic arithmetic kirchhoff'
colours = sprintf('%s %s %s', RED, ORANGE, BLUE)
set title 'profiles, dx = 1/40 m' font size_of(11) offset 0,-0.6
set xlabel 'x  [m]'
set ylabel 'T  [K]' offset 0.5
set xrange [0:1]
set yrange [0:2.4]
set key top right
plot data index 'exact' using 1:2 with lines lc rgb GREY lw 3 title 'exact', \
    for [k = 1:3] data index 'profile, '.word(means, k) using 1:2 with points lc rgb word(colours, k) \
        pt int(word('7 9 5', k)) ps 0.8 * P title word(means, k)
unset label 98; unset label 99
set title 'errors' font size_of(11) offset 0,-0.6
set logscale xy
set format y '10^{%T}'
set xlabel 'dx  [m]'
set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5
set xrange [0.005:0.12]
set yrange [1e-4:1]
set xtics (0.00625, 0.0125, 0.025, 0.05, 0.1)
set key at graph 0.02, graph 0.83 left top Left reverse
plot for [k = 1:3] data index 'error, '.word(means, k) using 1:2 with linespoints lc rgb word(colours, k) \
        pt int(word('7 9 5', k)) ps 0.9 * P lw (k == 3 ? 2.4 : 1.2) title word(means, k), \
    0.7 * x**1.5 with lines lc rgb GREY dt 2 title 'slope 3/2'
unset multiplot
