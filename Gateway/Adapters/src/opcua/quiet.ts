// Must be imported before the rest of the library. Disables its own logging; errors are reported in our own messages.
import { setDebugLogger, setErrorLogger, setWarningLogger } from 'node-opcua-debug';

const silent = (): void => {};
setDebugLogger(silent);
setErrorLogger(silent);
setWarningLogger(silent);
