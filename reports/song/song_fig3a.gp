# Song 2018, Figure 3a
name = 'song_fig3a'
load 'reports/figure/style.gp'
set xlabel 'x  [m]' offset 0,-0.5
set ylabel 'y  [m]' offset 0,-0.5
set zlabel 'T  [K]' rotate parallel offset 1
set xrange [-2:2]
set yrange [-2:2]
set zrange [0:11]
set ticslevel 0
set view 58, 32
set hidden3d offset 1 trianglepattern 3
unset grid
set xtics 1
set ytics 1
unset key
splot data index 'particles' using 1:2:3 with lines lc rgb BLUE lw 0.8
