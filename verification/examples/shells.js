// SPDX-License-Identifier: GPL-3.0-or-later
// node shells.js CASE OUT: a ball, finite volumes between shells, cones and half-planes, BDF2 in time.
//
//     rho_c V dT/dt = V source + sum over the faces of a cell of conductance (T_beyond - T)
//
// A cell extends over dr, dtheta and dphi.  Faces at r = 0 and on the axis have no area.  Each step
// solves for all cells at once by conjugate gradients, since cells at the axis are small.  The case
// file gives the radius, k, rho_c and the end time.  `heatladder reference` gives the start, the
// source and the wall.  $HEATLADDER is the path of that program.
'use strict';
const fs = require('fs');
const {execFileSync} = require('child_process');

const FLUX = 2, COOLED = 3;  // kinds of walls in the answers of `reference`; 1: held
const [caseFile, out] = process.argv.slice(2);
const field = Object.fromEntries(fs.readFileSync(caseFile, 'utf8').trim().split('\n').map(line => line.split(' = ')));
if (field.shape !== 'ball' || field.source === 'changing' || field.walls || field.k_law) process.exit(77);
const R = +field.radius, k = +field.k_x, rhoC = +field.rho_c, tEnd = +field.t_end;

// Cells (i, j, l) along r, theta and phi; l is fastest.
const nr = Math.round(R / field.dx), nTheta = 2 * nr, nPhi = 4 * nr, n = nr * nTheta * nPhi;
const dr = R / nr, dTheta = Math.PI / nTheta, dPhi = 2 * Math.PI / nPhi;
const place = (r, theta, phi) =>
    [r * Math.sin(theta) * Math.cos(phi), r * Math.sin(theta) * Math.sin(phi), r * Math.cos(theta)];

const centres = [], feet = [];
const volume = new Float64Array(n), wall = [];
const faces = [];  // [cell, cell beyond, conductance, W/K]
for (let i = 0, c = 0; i < nr; i++)
    for (let j = 0; j < nTheta; j++)
        for (let l = 0; l < nPhi; l++, c++) {
            const theta = (j + 0.5) * dTheta, phi = (l + 0.5) * dPhi;
            const solid = (Math.cos(j * dTheta) - Math.cos((j + 1) * dTheta)) * dPhi;  // angle, sr
            centres.push(place((i + 0.5) * dr, theta, phi));
            volume[c] = solid * ((i + 1) ** 3 - i ** 3) * dr ** 3 / 3;
            if (i + 1 < nr) faces.push([c, c + nTheta * nPhi, k * solid * ((i + 1) * dr) ** 2 / dr]);
            if (j + 1 < nTheta) faces.push([c, c + nPhi, k * dr * Math.sin((j + 1) * dTheta) * dPhi / dTheta]);
            faces.push([c, l + 1 < nPhi ? c + 1 : c + 1 - nPhi, k * dr * dTheta / (Math.sin(theta) * dPhi)]);
            if (i + 1 === nr) {
                feet.push(place(R, theta, phi));
                wall.push({c, area: solid * R ** 2});
            }
        }

function ask(points, what) {
    fs.writeFileSync(out + '.points', 'x,y,z\n' + points.map(point => point.join(',')).join('\n') + '\n');
    const words = ['reference', ...field.oracle.split(' '), '--points', out + '.points', '--time', '0', '--what', what];
    const answer = execFileSync(process.env.HEATLADDER || 'heatladder', words, {encoding: 'utf8', maxBuffer: 2 ** 30});
    return answer.trim().split('\n').slice(1).map(line => line.split(',').slice(3).map(Number));
}

let T = new Float64Array(n), old = T;
const given = new Float64Array(n), lost = new Float64Array(n);  // W and W/K: source and wall
ask(centres, 'initial,source').forEach(([initial, source], c) => { T[c] = initial; given[c] = source * volume[c]; });
ask(feet, 'wall').forEach(([kind, value, b], e) => {
    const {c, area} = wall[e];
    const g = kind === FLUX ? 0 : area / (dr / 2 / k + (kind === COOLED ? 1 / b : 0));
    given[c] += kind === FLUX ? area * value : g * value;
    lost[c] += g;
});

// The matrix of a step: mass/dt and what leaves a cell.
const diagonal = new Float64Array(n), from = Int32Array.from(faces, f => f[0]), to = Int32Array.from(faces, f => f[1]);
const g = Float64Array.from(faces, f => f[2]);
function setDiagonal(perTime) {
    for (let c = 0; c < n; c++) diagonal[c] = perTime * rhoC * volume[c] + lost[c];
    for (let f = 0; f < g.length; f++) diagonal[from[f]] += g[f], diagonal[to[f]] += g[f];
}

function times(x, y) {
    for (let c = 0; c < n; c++) y[c] = diagonal[c] * x[c];
    for (let f = 0; f < g.length; f++) y[from[f]] -= g[f] * x[to[f]], y[to[f]] -= g[f] * x[from[f]];
}

// Conjugate gradients with the diagonal, from the guess x.
function solve(x, right) {
    const r = new Float64Array(n), p = new Float64Array(n), q = new Float64Array(n);
    times(x, q);
    let before = 0, first = 0;
    for (let c = 0; c < n; c++) first += right[c] * right[c] / diagonal[c];
    for (let c = 0; c < n; c++) r[c] = right[c] - q[c];
    for (let step = 0; step < 10000; step++) {
        let rho = 0, pq = 0;
        for (let c = 0; c < n; c++) rho += r[c] * r[c] / diagonal[c];
        if (rho <= 1e-22 * first) return;
        for (let c = 0; c < n; c++) p[c] = r[c] / diagonal[c] + (before && rho / before) * p[c];
        times(p, q);
        for (let c = 0; c < n; c++) pq += p[c] * q[c];
        for (let c = 0; c < n; c++) x[c] += rho / pq * p[c], r[c] -= rho / pq * q[c];
        before = rho;
    }
    throw new Error('the iteration does not converge');
}

const steps = Math.ceil(6 * tEnd * k / (rhoC * dr ** 2)), dt = tEnd / steps, begun = performance.now();
for (let step = 1; step <= steps; step++) {
    const a = step === 1 ? 1 : 1.5;  // Euler's first, then dT/dt = (1.5 T' - 2 T + 0.5 old) / dt
    const right = given.map((heat, c) => heat + rhoC * volume[c] / dt * ((2 * a - 1) * T[c] - (a - 1) * old[c]));
    const next = T.map((now, c) => step === 1 ? now : 2 * now - old[c]);
    setDiagonal(a / dt);
    solve(next, right);
    [old, T] = [T, next];
}
const seconds = (performance.now() - begun) / 1000;

const rows = centres.map((point, c) => [...point, T[c], volume[c]].join(','));
fs.writeFileSync(out, `# steps = ${steps}\n# seconds = ${seconds}\nx,y,z,T,w\n${rows.join('\n')}\n`);
