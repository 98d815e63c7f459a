// Disables the logging of node-opcua, because the adapter reports errors in its own messages. Must be imported before the rest of the library.
import { setDebugLogger, setErrorLogger, setWarningLogger } from 'node-opcua-debug';

const silent = (): void => {};
setDebugLogger(silent);
setErrorLogger(silent);
setWarningLogger(silent);
