/** The page's start. Everything else is reached from here. */
import './page.js';
