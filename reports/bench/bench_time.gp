# Error over wall time; a bar spans the runs, and the line in black joins what nothing else beats.
chart = 'time'
load 'reports/bench/bench_style.gp'
set xlabel 'wall time of a run  [s]'
set ylabel 'E1  [-]'
plot data index N using 4:3 with lines lc rgb BLACK lw 4 title columnheader(10), \
     for [i=0:N-1] data index i using 4:3:5:6 with xerrorlines lc rgb colour(i) lw 1 dt dash(i) pt point(i) ps 0.8 * P \
     title columnheader(10)
