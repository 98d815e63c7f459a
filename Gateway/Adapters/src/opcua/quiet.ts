// Imported before anything else of the library: what it has to say is said in our own words, and on no other stream.
import { setDebugLogger, setErrorLogger, setWarningLogger } from 'node-opcua-debug';

const silent = (): void => {};
setDebugLogger(silent);
setErrorLogger(silent);
setWarningLogger(silent);
