# Error against counted work on square-step: Song's choice, and the matched run.
name = 'matched_fig1'
keys = 3
load 'reports/figure/style.gp'
set logscale xy
set format xy '10^{%T}'
set xlabel 'work of all steps  [pairs of particles]'
set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5
set autoscale fix
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set key vertical maxrows 3
steps(dx, n) = abs(dx - 0.1) < 1e-9 ? sprintf('%d steps', n) : ''
plot data index 'as published' using 1:2 with linespoints lc rgb RED pt 7 lw 1.2 dt 2 title 'SO-SSPH as published (numbers: steps at dx = 0.1 m)', \
     data index 'matched, without the start' using 1:2 with linespoints lc rgb GREY pt 9 lw 1.2 dt 3 title 'matched step, clock started at 0', \
     data index 'matched' using 1:2 with linespoints lc rgb BLUE pt 5 lw 2.4 title 'matched run', \
     data index 'as published' using 1:2:(steps($3, $4)) with labels left offset 0.8,0.8 font size_of(10) notitle, \
     data index 'matched' using 1:2:(steps($3, $4)) with labels left offset 1,0.6 font size_of(10) notitle
