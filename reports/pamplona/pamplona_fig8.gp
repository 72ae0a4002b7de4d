# Pamplona 2019, Figure 8
name = 'pamplona_fig8'
high = 600
keys = 5
load 'reports/figure/style.gp'
set logscale xy
set xrange [0.0038:0.0105]
set xtics (0.004, 0.005, 0.006, 0.007, 0.008, 0.009, 0.010)
set format y '10^{%T}'
set mytics 10
set grid mytics ls 98, ls 99
set xlabel 'h  [m]'
set ylabel 'pairs evaluated  [-]'
set key vertical maxrows 5 enhanced
plot data index 'power' using 1:2 with lines lc rgb BLACK lw 1.2 dt 1 title columnheader(2), \
     data index 'exponential' using 1:2 with lines lc rgb GREY lw 1.2 dt 2 title columnheader(2), \
     data index 'steel' using 1:2 with points ls 3 title columnheader(2), \
     data index 'vanadium' using 1:2 with points ls 4 title columnheader(2), \
     data index 'titanium' using 1:2 with points ls 2 title columnheader(2)
