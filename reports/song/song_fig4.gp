# Song 2018, Figure 4a-e
name = 'song_fig4'
method = 'SO-SSPH'
wide = 1080; high = 780; rows = 2; columns = 3
levels = 'incremental 1, 2, 9'
bold = -1
set xrange [-1.05:1.05]; set yrange [-1.05:1.05]; set xtics 0.5; set ytics 0.5
load 'reports/figure/isotherms.gp'
