# Song 2018, Figure 2b
name = 'song_fig2b'
load 'reports/page/style.gp'
load 'reports/page/convergence.gp'
