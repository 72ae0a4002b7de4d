# A disturbance of 1e-10 K under the published and under the true bound.
name = 'stability_blowup'
wide = 940
load 'reports/style.gp'
set logscale xy
set xrange [1:1000]
set yrange [1e-12:1e7]
set ytics 1e2
set format y '10^{%T}'
set xlabel 'step  [-]'
set ylabel 'distance of the disturbed run  [K]'
set key top left Left reverse noenhanced
set label 2 'refused from here on' at 660, 0.5 right noenhanced font size_of(9.5)
set label 1 'refused from here on' at 25, 0.25 noenhanced font size_of(9.5)
plot data index 'so_ssph published' using 1:2 with linespoints ls 2 title 'SO-SSPH, quartic, h/dx = 1.1, 1D: Song eq. 34', \
     data index 'so_ssph true' using 1:2 with linespoints ls 3 title 'the same at 0.99 of the true limit', \
     data index 'ftcs published' using 1:2 with linespoints ls 6 title 'FTCS, 2D: Pamplona eq. 17', \
     data index 'ftcs true' using 1:2 with linespoints ls 4 title 'the same at 0.99 of the true limit'
