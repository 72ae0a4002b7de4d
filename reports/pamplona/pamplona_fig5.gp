# Pamplona 2019, Figure 5
name = 'pamplona_fig5'
method = 'SPH (Brookshaw), ξ = 1.643 m'
load 'reports/figure/isotherms.gp'
