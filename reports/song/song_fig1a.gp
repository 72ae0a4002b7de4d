# Song 2018, Figure 1a
name = 'song_fig1a'
load 'reports/figure/style.gp'
load 'reports/figure/rod.gp'
plot data index 'exact' using 1:2 with lines ls 1 title 'T(x, 0), eq. 43', \
     data index 'particles' using 1:2 with points ls 3 title sprintf('particles, dx = %s m', option('dx'))
