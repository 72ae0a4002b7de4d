# Song 2018, Figure 4f
name = 'song_fig4f'
keys = 2
load 'reports/figure/style.gp'
load 'reports/figure/rod.gp'
plot data index 'exact 1' using 1:2 with lines ls 1 title 'exact', \
     data index 'exact 2' using 1:2 with lines ls 1 notitle, \
     data index 'exact 3' using 1:2 with lines ls 1 notitle, \
     data index 'exact 4' using 1:2 with lines ls 1 notitle, \
     data index 'exact 5' using 1:2 with lines ls 1 notitle, \
     data index 'so_ssph 1' using 1:2 with points ls 2 title 'SO-SSPH, 1 s', \
     data index 'so_ssph 2' using 1:2 with points ls 6 title '2 s', \
     data index 'so_ssph 3' using 1:2 with points ls 4 title '3 s', \
     data index 'so_ssph 4' using 1:2 with points ls 5 title '4 s', \
     data index 'so_ssph 5' using 1:2 with points ls 3 title '5 s'
