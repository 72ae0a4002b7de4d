# Pamplona 2019, Figure 5: 0.625 K is the mean of the walls.
name = 'pamplona_fig5'
method = 'SPH (Brookshaw), ξ = 1.643 m'
wide = 900; high = 940; rows = 2; columns = 2
levels = 'incremental 0.125, 0.1, 0.925'
bold = 0.625
set xrange [0:0.1]; set yrange [0:0.1]; set xtics 0.02; set ytics 0.02
load 'reports/figure/isotherms.gp'
