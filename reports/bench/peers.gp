# Error over the time of the solve: programs that others would use, beside ours.  A colour a family, a point a program.
if (!exists("data")) data = 'reports/out/peers/peers_square-step.csv'
name = system(sprintf("basename '%s' .csv", data))
wide = 1100; high = 640
load 'reports/figure/style.gp'
set logscale xy
set format xy '10^{%T}'
set rmargin at screen 0.65
set key at screen 0.665, screen 0.93 left top Left reverse
set autoscale fix
set offsets graph 0.04, graph 0.04, graph 0.05, graph 0.05
set xlabel 'time of the solve, start-up left out  [s]'
set ylabel 'E1  [-]'
array FAMILY[5] = ['so_ssph', 'FTCS', 'SUNDIALS', 'SciPy', 'PySPH']
array COLOUR[5] = [BLACK, GREEN, RED, BLUE, ORANGE]
array WIDTH[5] = [2.2, 1.2, 1.2, 1.2, 1.2]
array DASH[5] = [1, 1, 3, 4, 5]
programs = 'matched exact rkl2 FTCS DIRK ERK DST wave BDF CVODE expm cubic quintic' # the last that fits
points = '7 5 9 13 6 8 10 11 12 4 1 2 3'
family(who) = sum [f=1:5] (strstrt(who, FAMILY[f]) == 1 ? f : 0)
point(who) = (best = 0, sum [p=1:words(programs)] (strstrt(who, word(programs, p)) ? (best = p) : 0), int(word(points, best)))
who(i) = system(sprintf("sed -n 's/^n,.*,//p' '%s' | sed -n %dp", data, i + 1))
blocks = int(system(sprintf("grep -c '^n,' '%s'", data)))
plot for [i=0:blocks-1] data index i using 3:2 with linespoints lc rgb COLOUR[family(who(i))] lw WIDTH[family(who(i))] \
     dt DASH[family(who(i))] pt point(who(i)) ps P title who(i)
