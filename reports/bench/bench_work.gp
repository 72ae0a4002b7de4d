# Error over counted work, which is the same on every machine.
chart = 'work'
load 'reports/bench/bench_style.gp'
set xlabel 'work  [pairs of particles]'
set ylabel 'E1  [-]'
plot data index N+1 using 7:3 with lines lc rgb BLACK lw 4 title columnheader(10), \
     for [i=0:N-1] data index i using 7:3 with linespoints lc rgb colour(i) lw 1 dt dash(i) pt point(i) ps 0.8 * P \
     title columnheader(10)
