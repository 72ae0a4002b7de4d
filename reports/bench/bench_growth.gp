# Wall time over the number of particles.
chart = 'growth'
load 'reports/bench/bench_style.gp'
set title heading[1:strstrt(heading, ':')] . ' time against size' noenhanced font size_of(13)
set xlabel 'particles  [-]'
set ylabel 'wall time of a run  [s]'
plot for [i=0:N-1] data index i using 2:4:5:6 with yerrorlines lc rgb colour(i) lw 1 dt dash(i) pt point(i) ps 0.8 * P \
     title columnheader(10)
