# Pamplona 2019, Figure 7a
name = 'pamplona_fig7a'
keys = 2
load 'reports/figure/style.gp'
set logscale xy
set xrange [0.0038:0.0115]
set xtics (0.004, 0.005, 0.006, 0.007, 0.008, 0.009, 0.010)
set ytics (1, 1.5, 2, 3, 4, 5, 6, 7, 8, 10)
set yrange [1.2:10]
set xlabel 'h  [m]'
set ylabel 'mean of |e| / T at the best ξ  [%]' offset 1
plot data index 'steel' using 1:2 with linespoints ls 3 title 'steel', \
     data index 'vanadium' using 1:2 with linespoints ls 4 title 'vanadium', \
     data index 'titanium' using 1:2 with linespoints ls 2 title 'titanium', \
     data index 'printed' using 1:2 with points pt 6 ps 1.8 * P lw 1.6 lc rgb BLACK title 'printed: SPH, Table 1'
