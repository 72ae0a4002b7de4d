# Error against the time of the solve, for this code (thick lines) and others.
if (!exists("data")) data = 'reports/out/league/league.csv'
name = system(sprintf("basename '%s' .csv", data))
wide = 1000; high = 600
load 'reports/figure/style.gp'
set logscale xy
set format xy '10^{%T}'
set rmargin at screen 0.72
set key at screen 0.735, screen 0.93 left top Left reverse
set autoscale fix
set offsets graph 0.04, graph 0.04, graph 0.05, graph 0.05
set xlabel 'time of the solve  [s]'
set ylabel 'E1  [-]'
who(i) = system(sprintf("sed -n 's/^n,.*,//p' '%s' | sed -n %dp", data, i + 1))
blocks = int(system(sprintf("grep -c '^n,' '%s'", data)))
array COLOUR[7] = [BLACK, RED, BLUE, ORANGE, GREEN, PURPLE, SKY]
ours(who) = strstrt(who, 'so_ssph') == 1 || strstrt(who, 'voronoi_flux') == 1
width(who) = ours(who) ? 2.2 : 1
dash(who) = ours(who) ? 1 : 2
plot for [i=0:blocks-1] data index i using 3:2 with linespoints lc rgb COLOUR[i % 7 + 1] lw width(who(i)) \
     dt dash(who(i)) pt (i % 7 + 4) ps P title who(i)
