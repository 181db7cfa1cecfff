/** The page's start. Everything else is reached from here. */
import './page.js';
import { registerOffline } from './offline/register.js';

// The site alone: not the page as one file, nor the development server, whose files change.
if (import.meta.env.MODE === 'site') registerOffline();
