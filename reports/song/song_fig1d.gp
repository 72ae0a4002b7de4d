# Song 2018, Figure 1d
name = 'song_fig1d'
keys = 2
load 'reports/figure/style.gp'
load 'reports/figure/rod.gp'
plot data index 'exact' using 1:2 with lines ls 1 title 'exact', \
     data index 'ftcs_flux' using 1:2 with linespoints ls 2 title 'FTCS with heat fluxes', \
     data index 'ftcs direct' using 1:2 with points ls 3 title 'FTCS'
