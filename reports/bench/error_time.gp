# Error against wall time on one scene: one curve per method with its usual stepper, and so_ssph with faster steppers.
if (!exists("data")) data = 'reports/out/bench/bench_square-step.csv'
name = 'error_time'
wide = 820; high = 560
load 'reports/figure/style.gp'
unset label 99
unset bmargin
# The words before the bar select a program by its header; the label is after it.
array PROGRAM[9] = ['so_ssph euler at F|so_ssph, Euler', 'so_ssph rk2|so_ssph, RK2', 'so_ssph rkl2|so_ssph, RKL2', \
    'so_ssph exact; h|so_ssph, exact in time', 'so_ssph matched; cubic|so_ssph, matched step', \
    'fo_ssph exact|fo_ssph, exact in time', 'brookshaw exact|brookshaw, exact in time', 'ftcs at F|ftcs', \
    'ftcs_flux at F|ftcs_flux']
words_of(k) = PROGRAM[k][1:strstrt(PROGRAM[k], '|') - 1]
label_of(k) = PROGRAM[k][strstrt(PROGRAM[k], '|') + 1:*]
headers = sprintf("grep '^n,' '%s'", data)
block_of(k) = int(system(sprintf("%s | grep -n ',updates,%s' | head -n 1 | sed 's/:.*//'", headers, words_of(k)))) - 1
array COLOUR[9] = [BLUE, BLUE, BLUE, BLUE, BLUE, RED, PURPLE, BLACK, ORANGE]
array POINT[9] = [6, 4, 8, 12, 10, 1, 2, 3, 14]
array DASH[9] = [1, 2, 3, 4, 5, 1, 2, 1, 2]
array BLOCK[9]
do for [k=1:9] { BLOCK[k] = block_of(k) }
set title heading[1:strstrt(heading, ':')] . ' error against wall time' noenhanced font size_of(12)
set logscale xy
set format xy '10^{%T}'
set mxtics 1
set mytics 1
set margins screen 0.11, screen 0.975, screen 0.34, screen 0.92
set autoscale fix
set offsets graph 0.04, graph 0.04, graph 0.05, graph 0.05
set xlabel 'wall time of a run, whole domain  [s]' offset 0, 0.4
set ylabel 'E1  [-]' offset 0.5
set key at screen 0.09, screen 0.225 left top Left reverse vertical samplen 3 maxrows 5
plot for [k=1:9] data index (BLOCK[k] < 0 ? 0 : BLOCK[k]) using (BLOCK[k] < 0 ? NaN : $4):3 with linespoints \
    lc rgb COLOUR[k] dt DASH[k] lw (k == 1 ? 2.4 : 1.4) pt POINT[k] ps 1.5 * P title label_of(k)
