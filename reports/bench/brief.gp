# Error against wall time on a rod, a square and a cube: every method with its best stepper (heatladder bench --brief).
# A curve a method, a colour a family of methods with nearly the same errors; bars from the fastest to the slowest run.
name = 'brief'
if (!exists("out")) out = 'reports/out'
data = out.'/brief/bench_square-step.csv'
wide = 640; high = 680
load 'reports/figure/style.gp'
machine = system(sprintf("sed -n 's/^# processor: //p' '%s'", data))
unset title
unset label 99
unset bmargin
set label 98 'Error against wall time, one thread, median of 5 runs' at screen 0.5, screen 0.975 center font size_of(11)
set label 99 machine at screen 0.012, screen 0.02 left noenhanced font size_of(8.5) textcolor rgb '#555555'
array FAMILY[8] = ['so_ssph matched; cubic', 'so_ssph exact; h/dx 0.9|contact_ssph exact', \
    'brookshaw exact|brookshaw_corrected exact|schwaiger exact|fatehi_manzari exact; h/dx 0.9', 'cspm exact|kernel_second exact', \
    'positive exact|voronoi_flux exact', 'fo_ssph exact|flux_divergence exact|conjugate exact|ftcs_flux at F', 'ftcs at F', '']
# The key: a family and names; family 0 continues the line above.
array LINE[9] = [1, 2, 3, 0, 4, 5, 6, 0, 7]
array TITLE[9] = ['so_ssph, matched step', 'so_ssph, contact_ssph', 'brookshaw, schwaiger, fatehi_manzari,', \
    'brookshaw_corrected', 'cspm, kernel_second', 'positive, voronoi_flux', 'fo_ssph, flux_divergence,', \
    'conjugate, ftcs_flux', 'ftcs']
array COLOUR[7] = [BLUE, SKY, PURPLE, ORANGE, GREEN, RED, BLACK]
array POINT[7] = [10, 8, 2, 12, 4, 6, 1]
programs(f) = 1 + sum [i = 1:strlen(FAMILY[f])] (FAMILY[f][i:i] eq '|')
program(f, k) = system(sprintf("echo '%s' | cut -d '|' -f %d", FAMILY[f], k))
file(scene) = sprintf('%s/brief/bench_%s.csv', out, scene)
# The block of a program by the first letters of its header; -1 for none.
block(scene, who) = int(system(sprintf("grep '^n,' '%s' | grep -n ',updates,%s' | head -n 1 | sed 's/:.*//' | grep . || echo 0", file(scene), who))) - 1
set logscale xy
set format xy '10^{%T}'
set xtics 100
set mxtics 1
set mytics 1
set xlabel 'wall time of a run  [s]' offset 0, 0.4
set ylabel 'E1  [-]' offset 1
unset key
set errorbars 0.4
B(i) = int(word(blocks, i))
F(i) = int(word(families, i))
set multiplot
do for [s = 1:3] {
    scene = word('rod-step square-step cube-step', s)
    set lmargin at screen (s == 2 ? 0.64 : 0.15); set rmargin at screen (s == 2 ? 0.97 : 0.48)
    set tmargin at screen (s == 3 ? 0.45 : 0.91); set bmargin at screen (s == 3 ? 0.13 : 0.59)
    set title scene noenhanced font size_of(10) offset 0, -0.7
    set autoscale fix
    set offsets graph 0.05, graph 0.05, graph 0.06, graph 0.06
    blocks = ''; families = ''; path = file(scene)
    do for [f = 1:7] { do for [k = 1:programs(f)] {
        b = block(scene, program(f, k))
        if (b >= 0) { blocks = blocks.sprintf(' %d', b); families = families.sprintf(' %d', f) }
    } }
    plot for [i = 1:words(blocks)] path index B(i) using 4:3:5:6 with xerrorbars lc rgb COLOUR[F(i)] lw 0.8 pt 0, \
         for [i = 1:words(blocks)] path index B(i) using 4:3 with linespoints lc rgb COLOUR[F(i)] \
             lw (F(i) == 1 ? 2.2 : 1) pt POINT[F(i)] ps 0.9 * P
    unset label 98; unset label 99
}
# The key is a plot of its own.
set lmargin at screen 0.56; set rmargin at screen 0.98; set tmargin at screen 0.5; set bmargin at screen 0.06
unset border; unset tics; unset title; unset xlabel; unset ylabel; unset logscale; unset offsets; unset grid
set xrange [0:1]; set yrange [0:1]
set key at graph -0.08, graph 0.93 left top Left reverse vertical maxrows 9 samplen 2 spacing 1.1
eval sprintf("set key font '%s'", size_of(9))
plot for [l = 1:9] NaN with linespoints lc rgb (LINE[l] ? COLOUR[LINE[l] ? LINE[l] : 1] : '#ffffff') \
    lw (LINE[l] == 1 ? 2.2 : 1) pt (LINE[l] ? POINT[LINE[l] ? LINE[l] : 1] : 0) ps 0.9 * P title TITLE[l]
unset multiplot
