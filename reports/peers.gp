# Error over the time of the solve: programs that others would use, beside ours.
if (!exists("data")) data = 'reports/out/peers/peers_square-step.csv'
name = system(sprintf("basename '%s' .csv", data))
wide = 1000; high = 600
load 'reports/style.gp'
set logscale xy
set format xy '10^{%T}'
set rmargin at screen 0.68
set key at screen 0.70, screen 0.93 left top Left reverse
set title offset screen -0.12, 0
set offsets graph 0.03, graph 0.03, 0, 0
set xlabel 'time of the solve, one thread  [s]'
set ylabel 'E1  [-]'
stats data using 2 nooutput
OURS = 4 # the first blocks; drawn thicker
array COLOUR[7] = [BLACK, BLUE, GREEN, GREY, RED, ORANGE, PURPLE]
array POINT[7] = [7, 5, 9, 11, 13, 6, 4]
width(i) = i < OURS ? 2.2 : 1.1
dash(i) = i < OURS ? 1 : 2 + i % 4
point(i) = POINT[i % 7 + 1]
plot for [i=0:STATS_blocks-1] data index i using 3:2 with linespoints lc rgb COLOUR[i % 7 + 1] lw width(i) dt dash(i) \
     pt point(i) ps 1.0 * P title columnheader(4)
