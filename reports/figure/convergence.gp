# Errors against dx; published values as hollow points around the measured ones.
set logscale xy
set format y '10^{%T}'
set xtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1)
set mytics 10
set grid mytics ls 98, ls 99
set xlabel 'dx  [m]'
set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5
set key vertical maxrows 4
set offsets graph 0.03, graph 0.03, 0, 0
plot data index 'fo_ssph measured' using 1:2 with linespoints ls 2 title columnheader(2), \
     data index 'fo_ssph published' using 1:2 with points ls 12 title columnheader(2), \
     data index 'so_ssph measured' using 1:2 with linespoints ls 3 lw 2.2 title columnheader(2), \
     data index 'so_ssph published' using 1:2 with points ls 13 title columnheader(2)
