# Pamplona 2019, Figure 8, in seconds of this machine: medians, and quartiles
name = 'pamplona_fig8_seconds'
load 'reports/figure/style.gp'
set logscale xy
set xrange [0.0038:0.0105]
set xtics (0.004, 0.005, 0.006, 0.007, 0.008, 0.009, 0.010)
set format y '10^{%T}'
set mytics 10
set grid mytics ls 98, ls 99
set xlabel 'h  [m]'
set ylabel 'wall time of a run, median and quartiles of 9  [s]'
set key top right
plot data index 'steel' using 1:2:3:4 with yerrorlines ls 3 title 'steel', \
     data index 'vanadium' using 1:2:3:4 with yerrorlines ls 4 title 'vanadium', \
     data index 'titanium' using 1:2:3:4 with yerrorlines ls 2 title 'titanium'
