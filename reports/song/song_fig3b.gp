# Song 2018, Figure 3b
name = 'song_fig3b'
load 'reports/figure/style.gp'
load 'reports/figure/rod.gp'
plot data index 'exact' using 1:2 with lines ls 1 title 'exact', \
     data index 'fo_ssph' using 1:2 with linespoints ls 2 title 'FO-SSPH', \
     data index 'so_ssph' using 1:2 with points ls 3 title 'SO-SSPH'
