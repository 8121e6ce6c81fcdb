# What all plots share: gnuplot -e "data='…'; out='…'; title='…'" style.gp PLOT.gp
# Colours are Okabe and Ito's, which the colour-blind tell apart.
set terminal svg size 900,420 dynamic font 'sans-serif,13' background 'white' linewidth 1
set output out
set datafile separator ','
set datafile columnheaders
set title title noenhanced
set border 3 lc rgb '#555555'
set tics nomirror out tc rgb '#333333'
set grid lc rgb '#dddddd' lt 1 lw 1
set key outside right top Left reverse samplen 2 noenhanced

color(method) = method eq 'geometry' ? 0x444444 : method eq 'raycast' ? 0x56b4e9 : \
  method eq 'culling' ? 0x0072b2 : method eq 'texture' ? 0x009e73 : method eq 'warp' ? 0xcc79a7 : \
  method eq 'warp2' ? 0xe69f00 : 0xd55e00
# Of frames.csv: the frame in the rows of one method, and a value that breaks the line where there is none.
only(method) = strcol('method') eq method ? column('frame') : NaN
measured(name) = strcol(name) eq '' ? NaN : column(name)
set autoscale xfix
