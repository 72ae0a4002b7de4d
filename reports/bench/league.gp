# Error over the time of the whole command: other codes, by the examples.
if (!exists("data")) data = 'reports/out/league/league.csv'
name = 'league'
wide = 1000; high = 600
load 'reports/figure/style.gp'
set logscale xy
set format xy '10^{%T}'
set rmargin at screen 0.68
set key at screen 0.695, screen 0.93 left top Left reverse
set autoscale fix
set offsets graph 0.04, graph 0.04, graph 0.05, graph 0.05
set xlabel 'time of the command, start-up and all  [s]'
set ylabel 'E1  [-]'
who(i) = system(sprintf("sed -n 's/^E1.*,//p' '%s' | sed -n %dp", data, i + 1))
blocks = int(system(sprintf("grep -c '^E1' '%s'", data)))
array COLOUR[5] = [BLACK, RED, BLUE, ORANGE, GREEN]
array DASH[3] = [1, 3, 5]
plot for [i=0:blocks-1] data index i using 2:1 with linespoints lc rgb COLOUR[i % 5 + 1] lw 1.2 dt DASH[i / 5 + 1] \
     pt (i % 7 + 4) ps P title who(i)
