# Pamplona 2019, Figure 6
name = 'pamplona_fig6'
method = 'FTCS'
load 'reports/figure/isotherms.gp'
