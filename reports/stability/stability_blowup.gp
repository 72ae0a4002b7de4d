# A disturbance of 1e-10 K under the published and under the true bound.
name = 'stability_blowup'
wide = 940; high = 600
load 'reports/figure/style.gp'
# A run that ends before the one under the true bound was refused there.
stats data index 'so_ssph published' using 1:2 name 'so' nooutput
stats data index 'so_ssph true' using 1:2 name 'so_true' nooutput
stats data index 'ftcs published' using 1:2 name 'ftcs' nooutput
stats data index 'ftcs true' using 1:2 name 'ftcs_true' nooutput
set logscale xy
set xrange [1:1000]
set yrange [5e-13:1e1]
set ytics 1e2
set format y '10^{%T}'
set xlabel 'step  [-]'
set ylabel 'distance of the disturbed run  [K]'
set key inside left top Left reverse noenhanced
refused = 'refused from here on'
if (so_max_x < so_true_max_x) set label 1 refused at so_max_x, so_max_y right offset -1,0 noenhanced font size_of(9.5)
if (ftcs_max_x < ftcs_true_max_x) set label 2 refused at ftcs_max_x, ftcs_max_y left offset 1,0 noenhanced font size_of(9.5)
plot data index 'so_ssph published' using 1:2 with linespoints ls 2 title 'SO-SSPH, quartic, h/dx = 1.1, 1D: Song eq. 34', \
     data index 'so_ssph true' using 1:2 with linespoints ls 3 title 'the same at 0.99 of the true limit', \
     data index 'ftcs published' using 1:2 with linespoints ls 6 title 'FTCS, 2D: Pamplona eq. 17', \
     data index 'ftcs true' using 1:2 with linespoints ls 4 title 'the same at 0.99 of the true limit'
