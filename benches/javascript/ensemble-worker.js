// A worker with an instance of its own, which does the ensemble as often as it is told.

import { parentPort, workerData } from 'node:worker_threads';

import * as shimmy from '../../www/pkg/shimmy.js';

import { work } from './ensembles.js';

shimmy.initSync({ module: workerData });
parentPort?.on('message', (times) => {
  work(shimmy, times);
  parentPort?.postMessage('done');
});
