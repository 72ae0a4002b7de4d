# Song 2018, Figure 1c (the paper's text does not name its four times)
name = 'song_fig1c'
keys = 2
load 'reports/figure/style.gp'
load 'reports/figure/rod.gp'
plot data index 'exact 0.5' using 1:2 with lines ls 1 title 'exact', \
     data index 'exact 1' using 1:2 with lines ls 1 notitle, \
     data index 'exact 2.5' using 1:2 with lines ls 1 notitle, \
     data index 'exact 5' using 1:2 with lines ls 1 notitle, \
     data index 'so_ssph 0.5' using 1:2 with points ls 2 title 'SO-SSPH, 0.5 s', \
     data index 'so_ssph 1' using 1:2 with points ls 6 title '1 s', \
     data index 'so_ssph 2.5' using 1:2 with points ls 4 title '2.5 s', \
     data index 'so_ssph 5' using 1:2 with points ls 3 title '5 s'
